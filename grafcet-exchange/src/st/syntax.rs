//! A program of structured text as data, and as text.

/// A statement.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Statement {
    /// `target := value;`
    Assign(String, String),
    /// `instance(…);`, a call of a function block.
    Call(String),
    /// Conditions with what is done under the first that holds, and what is done under none.
    If(Vec<(String, Vec<Statement>)>, Vec<Statement>),
    /// `CASE on OF`, each arm with what it is.
    Case(String, Vec<Arm>),
    /// `// …`
    Comment(String),
    /// Nothing, as a line between two parts.
    Gap,
}

/// `20: // Heat`
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Arm {
    pub(crate) number: u32,
    pub(crate) title: String,
    pub(crate) body: Vec<Statement>,
}

impl Statement {
    pub(crate) fn assign(target: impl Into<String>, value: impl Into<String>) -> Self {
        Self::Assign(target.into(), value.into())
    }

    /// `IF condition THEN … END_IF;`
    pub(crate) fn when(condition: impl Into<String>, then: Vec<Statement>) -> Self {
        Self::If(vec![(condition.into(), then)], Vec::new())
    }

    pub(crate) fn comment(text: impl Into<String>) -> Self {
        Self::Comment(text.into())
    }
}

/// A declared variable.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Variable {
    pub(crate) name: String,
    pub(crate) ty: String,
    /// After `:=`.
    pub(crate) init: Option<String>,
    /// After `//`.
    pub(crate) note: String,
}

impl Variable {
    pub(crate) fn new(name: impl Into<String>, ty: impl Into<String>) -> Self {
        Self { name: name.into(), ty: ty.into(), init: None, note: String::new() }
    }

    pub(crate) fn init(self, init: impl Into<String>) -> Self {
        Self { init: Some(init.into()), ..self }
    }

    pub(crate) fn note(self, note: impl Into<String>) -> Self {
        Self { note: note.into(), ..self }
    }
}

/// A function or function block that a person has to write.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Stub {
    pub(crate) name: String,
    /// Of a function; a function block returns nothing.
    pub(crate) ty: Option<String>,
    pub(crate) inputs: Vec<Variable>,
    /// What it stands for, in Rust.
    pub(crate) rust: String,
}

/// A function block with all that belongs to it.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub(crate) struct Program {
    pub(crate) header: Vec<String>,
    pub(crate) stubs: Vec<Stub>,
    pub(crate) name: String,
    pub(crate) inputs: Vec<Variable>,
    pub(crate) outputs: Vec<Variable>,
    pub(crate) variables: Vec<Variable>,
    pub(crate) body: Vec<Statement>,
    /// What has another name than in the chart.
    pub(crate) renamed: Vec<(String, String)>,
}

impl Program {
    pub(crate) fn text(&self) -> String {
        let mut text = String::new();
        for line in &self.header {
            push(&mut text, 0, &comment(line));
        }
        for stub in &self.stubs {
            text.push('\n');
            stub.write(&mut text);
        }
        text.push('\n');
        push(&mut text, 0, &format!("FUNCTION_BLOCK {}", self.name));
        let sections = [("VAR_INPUT", &self.inputs), ("VAR_OUTPUT", &self.outputs), ("VAR", &self.variables)];
        for (keyword, variables) in sections {
            declare(&mut text, keyword, variables);
        }
        text.push('\n');
        statements(&mut text, 0, &self.body);
        push(&mut text, 0, "END_FUNCTION_BLOCK");
        text
    }
}

impl Stub {
    pub(crate) fn write(&self, text: &mut String) {
        let end = match &self.ty {
            Some(ty) => {
                push(text, 0, &format!("FUNCTION {} : {ty}", self.name));
                "END_FUNCTION"
            }
            None => {
                push(text, 0, &format!("FUNCTION_BLOCK {}", self.name));
                "END_FUNCTION_BLOCK"
            }
        };
        declare(text, "VAR_INPUT", &self.inputs);
        push(text, 1, &comment(&format!("TO BE WRITTEN, in Rust: {}", self.rust)));
        if let Some(ty) = &self.ty {
            let nothing = nothing(ty);
            push(text, 1, &format!("{} := {nothing};", self.name));
        } else {
            push(text, 1, ";");
        }
        push(text, 0, end);
    }
}

/// What stands for nothing in a type of structured text.
pub(super) fn nothing(ty: &str) -> &'static str {
    match ty {
        "BOOL" => "FALSE",
        "REAL" | "LREAL" => "0.0",
        _ => "0",
    }
}

pub(crate) fn declare(text: &mut String, keyword: &str, variables: &[Variable]) {
    if variables.is_empty() {
        return;
    }
    push(text, 0, keyword);
    for Variable { name, ty, init, note } in variables {
        let init = init.as_ref().map(|init| format!(" := {init}")).unwrap_or_default();
        let note = if note.is_empty() { String::new() } else { format!(" {}", comment(note)) };
        push(text, 1, &format!("{name} : {ty}{init};{note}"));
    }
    push(text, 0, "END_VAR");
}

pub(crate) fn statements(text: &mut String, depth: usize, all: &[Statement]) {
    if all.iter().all(|one| matches!(one, Statement::Comment(_) | Statement::Gap)) && depth > 0 {
        push(text, depth, ";");
    }
    for statement in all {
        match statement {
            Statement::Assign(target, value) => push(text, depth, &format!("{target} := {value};")),
            Statement::Call(call) => push(text, depth, &format!("{call};")),
            Statement::Comment(words) => push(text, depth, &comment(words)),
            Statement::Gap => text.push('\n'),
            Statement::If(branches, otherwise) => {
                for (index, (condition, then)) in branches.iter().enumerate() {
                    push(text, depth, &format!("{} {condition} THEN", if index == 0 { "IF" } else { "ELSIF" }));
                    statements(text, depth + 1, then);
                }
                if !otherwise.is_empty() {
                    push(text, depth, "ELSE");
                    statements(text, depth + 1, otherwise);
                }
                push(text, depth, "END_IF;");
            }
            Statement::Case(on, arms) => {
                push(text, depth, &format!("CASE {on} OF"));
                for (index, arm) in arms.iter().enumerate() {
                    if index > 0 {
                        text.push('\n');
                    }
                    push(text, depth + 1, &format!("{}: {}", arm.number, comment(&arm.title)));
                    statements(text, depth + 2, &arm.body);
                }
                push(text, depth, "END_CASE;");
            }
        }
    }
}

/// On one line, whatever stands in it.
pub(crate) fn comment(text: &str) -> String {
    let words: Vec<&str> = text.split_whitespace().collect();
    if words.is_empty() { "//".to_owned() } else { format!("// {}", words.join(" ")) }
}

pub(crate) fn push(text: &mut String, depth: usize, line: &str) {
    for _ in 0..depth {
        text.push_str("  ");
    }
    text.push_str(line);
    text.push('\n');
}
