//! Statements as a block of Rust.

use std::collections::BTreeSet;

use super::expr::{Kind, Scope, fits, strength};
use super::facts::assigned;
use super::parser::{Arm, Expr, Label, Statement};
use super::walk::{count, names};

impl Scope<'_> {
    /// Statements of a block of Rust, one a line.
    pub(super) fn block(&mut self, statements: &[Statement], depth: usize) -> Result<Vec<String>, String> {
        let mut lines = Vec::new();
        for statement in statements {
            lines.extend(self.statement(statement, depth)?);
        }
        Ok(lines)
    }

    fn statement(&mut self, statement: &Statement, depth: usize) -> Result<Vec<String>, String> {
        let indent = "    ".repeat(depth);
        match statement {
            Statement::Assign(target, value) => {
                let Some(kind) = self.kinds.get(&target.to_lowercase()).copied() else {
                    return Err(format!("`{target}` is not declared as a value that Rust has"));
                };
                let value = self.rust(value, Some(kind))?;
                Ok(vec![format!("{indent}{} = {value};", self.names.get(target).unwrap_or_default())])
            }
            Statement::Call(name, _) => Err(format!("`{name}(…)` among other statements")),
            Statement::If(branches, otherwise) => {
                let mut lines = Vec::new();
                for (index, (condition, then)) in branches.iter().enumerate() {
                    let condition = self.rust(condition, Some(Kind::Bool))?;
                    let word = if index == 0 { format!("{indent}if") } else { format!("{indent}}} else if") };
                    lines.push(format!("{word} {condition} {{"));
                    lines.extend(self.block(then, depth + 1)?);
                }
                if !otherwise.is_empty() {
                    lines.push(format!("{indent}}} else {{"));
                    lines.extend(self.block(otherwise, depth + 1)?);
                }
                lines.push(format!("{indent}}}"));
                Ok(lines)
            }
            Statement::Case(of, arms, otherwise) => self.case(of, arms, otherwise, depth),
            Statement::For(name, [from, to], by, body) => self.counted(name, [from, to], by.as_ref(), body, depth),
            Statement::While(condition, body) => {
                let head = format!("{indent}while {} {{", self.rust(condition, Some(Kind::Bool))?);
                self.around(head, body, Vec::new(), depth)
            }
            Statement::Repeat(body, condition) => {
                if continues(body) {
                    return Err("`CONTINUE` within `REPEAT`".to_owned());
                }
                let ends = self.rust(condition, Some(Kind::Bool))?;
                let last = ["if ", &*ends, " {"].concat();
                let last =
                    [format!("{indent}    {last}"), format!("{indent}        break;"), format!("{indent}    }}")];
                self.around(format!("{indent}loop {{"), body, last.to_vec(), depth)
            }
            Statement::Exit => Ok(vec![format!("{indent}break;")]),
            Statement::Continue => Ok(vec![format!("{indent}continue;")]),
        }
    }

    /// A body between its first line, and its last ones.
    fn around(
        &mut self,
        head: String,
        body: &[Statement],
        last: Vec<String>,
        depth: usize,
    ) -> Result<Vec<String>, String> {
        let mut lines = vec![head];
        lines.extend(self.block(body, depth + 1)?);
        lines.extend(last);
        lines.push(format!("{}}}", "    ".repeat(depth)));
        Ok(lines)
    }

    /// `FOR`: over a range where nothing else asks for what it counts, else as it is defined.
    fn counted(
        &mut self,
        name: &str,
        [from, to]: [&Expr; 2],
        by: Option<&Expr>,
        body: &[Statement],
        depth: usize,
    ) -> Result<Vec<String>, String> {
        let indent = "    ".repeat(depth);
        let by = match by {
            None => 1,
            Some(Expr::Int(by)) if *by != 0 => *by,
            Some(_) => return Err("`FOR` by what is no literal".to_owned()),
        };
        let key = name.to_lowercase();
        let Some(kind) = self.kinds.get(&key).or(self.counters.get(&key)).copied() else {
            return Err(format!("`{name}` is not declared as a value that Rust has"));
        };
        if !fits(by.abs(), kind) {
            return Err("`FOR` by a number that its variable cannot hold".to_owned());
        }
        let (first, last) = (self.expr(from, Some(kind))?, self.expr(to, Some(kind))?);
        if self.counters.contains_key(&key) {
            let read = body.iter().map(|one| count(one, name)).sum::<usize>() > 0;
            let word = if read { self.names.get(name).unwrap_or_default() } else { "_" }.to_owned();
            // What is read of literals has the type that was declared.
            let suffix = match (from, to) {
                (Expr::Int(_), Expr::Int(_)) if read => format!("_{}", self.type_of(kind)),
                _ => String::new(),
            };
            let (first, last) = (first.within(strength::BIT_OR), last.within(strength::BIT_OR));
            let mut range =
                if by > 0 { format!("{first}{suffix}..={last}") } else { format!("({last}..={first}{suffix}).rev()") };
            if by.abs() > 1 {
                range = if by > 0 { format!("({range})") } else { range };
                range = format!("{range}.step_by({})", by.abs());
            }
            return self.around(format!("{indent}for {word} in {range} {{"), body, Vec::new(), depth);
        }
        let mut written = BTreeSet::new();
        assigned(body, &mut written);
        let mut read = Vec::new();
        names(to, &mut read);
        if continues(body) || read.iter().any(|one| written.contains(&one.to_lowercase())) {
            return Err(format!(
                "`FOR` over `{name}`, which is read elsewhere, with `CONTINUE` or an end that changes"
            ));
        }
        let name = self.names.get(name).unwrap_or_default().to_owned();
        let sign = if by > 0 { "<=" } else { ">=" };
        let last = last.within(strength::BIT_OR);
        let step = format!("{indent}    {name} {} {};", if by > 0 { "+=" } else { "-=" }, by.abs());
        let head = format!("{indent}while {name} {sign} {last} {{");
        let loop_ = self.around(head, body, vec![step], depth)?;
        Ok([format!("{indent}{name} = {};", first.0)].into_iter().chain(loop_).collect())
    }

    fn case(&mut self, of: &Expr, arms: &[Arm], otherwise: &[Statement], depth: usize) -> Result<Vec<String>, String> {
        let indent = "    ".repeat(depth);
        let kind = self.kind(of);
        if !matches!(kind, Some(Kind::Enum(_)))
            && !kind.is_some_and(|kind| matches!(kind, Kind::Number(name) if !name.starts_with('f')))
        {
            return Err("`CASE` of what is neither an integer nor an enum".to_owned());
        }
        let mut lines = vec![format!("{indent}match {} {{", self.rust(of, kind)?)];
        let mut told = BTreeSet::new();
        for arm in arms {
            let mut patterns = Vec::new();
            for label in &arm.labels {
                let pattern = match label {
                    Label::One(one) => self.pattern(one, kind)?,
                    Label::Range(from, to) => format!("{}..={}", self.pattern(from, kind)?, self.pattern(to, kind)?),
                };
                told.insert(pattern.clone());
                patterns.push(pattern);
            }
            lines.extend(self.arm(&patterns.join(" | "), &arm.body, depth + 1)?);
        }
        let all = match kind {
            Some(Kind::Enum(of)) => self.enums[of].values.len() == told.len(),
            _ => false,
        };
        if !all {
            lines.extend(self.arm("_", otherwise, depth + 1)?);
        } else if !otherwise.is_empty() {
            return Err("`CASE` with all values of its enum and `ELSE`".to_owned());
        }
        lines.push(format!("{indent}}}"));
        Ok(lines)
    }

    /// One assignment stands after its arrow.
    fn arm(&mut self, pattern: &str, body: &[Statement], depth: usize) -> Result<Vec<String>, String> {
        let indent = "    ".repeat(depth);
        if body.is_empty() {
            return Ok(vec![format!("{indent}{pattern} => {{}}")]);
        }
        let lines = self.block(body, depth + 1)?;
        if let ([Statement::Assign(..)], [line]) = (body, &lines[..]) {
            return Ok(vec![format!("{indent}{pattern} => {},", line.trim().trim_end_matches(';'))]);
        }
        Ok([format!("{indent}{pattern} => {{")].into_iter().chain(lines).chain([format!("{indent}}}")]).collect())
    }

    fn pattern(&mut self, label: &Expr, kind: Option<Kind>) -> Result<String, String> {
        let fits = match (label, kind) {
            (Expr::Int(value), Some(kind @ Kind::Number(_))) => fits(*value, kind),
            (Expr::Int(_) | Expr::Name(_) | Expr::Member(..) | Expr::Typed(..), Some(Kind::Enum(_))) => {
                !self.kinds.contains_key(&name_of(label).to_lowercase())
            }
            _ => false,
        };
        if fits {
            self.rust(label, kind)
        } else {
            Err("a label of `CASE` is neither a number nor a value of its enum".to_owned())
        }
    }
}

fn name_of(label: &Expr) -> &str {
    if let Expr::Name(name) = label { name } else { "" }
}

/// Whether `CONTINUE` stands there for this loop, and not for one within it.
fn continues(body: &[Statement]) -> bool {
    body.iter().any(|statement| match statement {
        Statement::Continue => true,
        Statement::For(..) | Statement::While(..) | Statement::Repeat(..) => false,
        other => other.bodies().into_iter().any(|body| continues(body)),
    })
}
