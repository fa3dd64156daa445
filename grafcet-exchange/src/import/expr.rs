//! Conditions, values and statements in Rust.

use std::collections::{BTreeMap, BTreeSet};

use super::names::Names;
use super::parser::{Expr, Op, Statement};
use super::parts::{Part, conjunction};
use super::source::{Pou, same};

/// What a value is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Kind {
    Bool,
    /// By the name in Rust, floats among them.
    Number(&'static str),
    Time,
}

impl Kind {
    /// Of a type of the standard.
    pub(super) fn of(ty: &str) -> Option<Self> {
        Some(match &*ty.to_uppercase() {
            "BOOL" => Self::Bool,
            "TIME" | "LTIME" => Self::Time,
            "SINT" => Self::Number("i8"),
            "INT" => Self::Number("i16"),
            "DINT" => Self::Number("i32"),
            "LINT" => Self::Number("i64"),
            "USINT" | "BYTE" => Self::Number("u8"),
            "UINT" | "WORD" => Self::Number("u16"),
            "UDINT" | "DWORD" => Self::Number("u32"),
            "ULINT" | "LWORD" => Self::Number("u64"),
            "REAL" => Self::Number("f32"),
            "LREAL" => Self::Number("f64"),
            _ => return None,
        })
    }

    pub(super) fn rust(self) -> &'static str {
        match self {
            Self::Bool => "bool",
            Self::Time => "time",
            Self::Number(name) => name,
        }
    }
}

/// What stands in Rust for an instance of a standard function block.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Instance {
    Rising(Expr),
    Falling(Expr),
    /// `TON`, by its time.
    Delayed(Expr, Expr),
}

/// What names mean.
pub(super) struct Scope<'p> {
    pub(super) names: Names,
    /// By name in small letters.
    pub(super) kinds: BTreeMap<String, Kind>,
    pub(super) steps: BTreeSet<String>,
    /// Variables that hold what an expression was in the scan before.
    pub(super) memory: BTreeMap<String, Expr>,
    pub(super) instances: BTreeMap<String, Instance>,
    /// All programs of the file, for functions that they call.
    pub(super) pous: &'p [Pou],
    /// Functions that a person has to write, by name in small letters.
    pub(super) called: BTreeSet<String>,
    /// Active where the condition is asked.
    pub(super) active: Vec<String>,
    /// What was taken for the memory of an edge, and is read as it is.
    pub(super) plain: BTreeSet<String>,
    /// What is a little different here.
    pub(super) differs: Vec<String>,
}

/// How strongly operators of Rust hold together.
mod strength {
    pub(super) const NONE: u8 = 0;
    pub(super) const OR: u8 = 1;
    pub(super) const AND: u8 = 2;
    pub(super) const COMPARE: u8 = 3;
    pub(super) const BIT_OR: u8 = 4;
    pub(super) const XOR: u8 = 5;
    pub(super) const BIT_AND: u8 = 6;
    pub(super) const SUM: u8 = 7;
    pub(super) const PRODUCT: u8 = 8;
    pub(super) const UNARY: u8 = 9;
    pub(super) const WORD: u8 = 10;
}

/// Rust, and how strongly it holds together.
struct Rust(String, u8);

impl Rust {
    fn word(text: impl Into<String>) -> Self {
        Self(text.into(), strength::WORD)
    }

    fn within(self, strength: u8) -> String {
        if self.1 < strength { format!("({})", self.0) } else { self.0 }
    }
}

impl Scope<'_> {
    /// An expression in Rust, or what of it has no translation.
    pub(super) fn rust(&mut self, expr: &Expr, wanted: Option<Kind>) -> Result<String, String> {
        Ok(self.expr(expr, wanted)?.0)
    }

    fn expr(&mut self, expr: &Expr, wanted: Option<Kind>) -> Result<Rust, String> {
        match expr {
            Expr::Bool(value) => Ok(Rust::word(value.to_string())),
            Expr::Int(value @ (0 | 1)) if wanted == Some(Kind::Bool) => Ok(Rust::word((*value == 1).to_string())),
            Expr::Int(value) if matches!(wanted, Some(Kind::Number("f32" | "f64"))) => {
                Ok(literal(&format!("{value}.0")))
            }
            Expr::Int(value) => Ok(literal(&value.to_string())),
            Expr::Real(value) => Ok(literal(value)),
            Expr::Time(nanos) => time(*nanos).map(Rust::word),
            Expr::Name(name) if self.kinds.contains_key(&name.to_lowercase()) => {
                Ok(Rust::word(self.names.get(name).unwrap_or_default()))
            }
            Expr::Name(name) => {
                self.plain.extend(Some(name.to_lowercase()).filter(|name| self.memory.contains_key(name)));
                Err(format!("`{name}` is not declared as a value that Rust has"))
            }
            Expr::Member(..) | Expr::Binary(Op::And, ..) => self.all(expr, wanted),
            Expr::Call(name, arguments) => self.call(name, arguments, wanted),
            Expr::Not(inner) => {
                Ok(Rust(format!("!{}", self.expr(inner, wanted)?.within(strength::UNARY)), strength::UNARY))
            }
            Expr::Minus(inner) => {
                Ok(Rust(format!("-{}", self.expr(inner, wanted)?.within(strength::UNARY)), strength::UNARY))
            }
            Expr::Binary(op, a, b) => {
                if let Some((limit, step)) = self.elapsed(expr).filter(|(limit, _)| **limit != Expr::Time(0)) {
                    return self.part(&Part::Elapsed(limit, step, false), wanted);
                }
                self.binary(*op, a, b, wanted)
            }
        }
    }

    /// `a AND b`, whose parts may make an edge or a time together.
    fn all(&mut self, expr: &Expr, wanted: Option<Kind>) -> Result<Rust, String> {
        if let Expr::Member(of, member) = expr {
            return self.member(of, member);
        }
        let Expr::Binary(_, a, b) = expr else { return self.expr(expr, wanted) };
        let of_numbers = [self.kind(a), self.kind(b)].into_iter().flatten().any(|kind| kind != Kind::Bool);
        if of_numbers {
            return self.binary(Op::And, a, b, wanted);
        }
        let mut parts = Vec::new();
        for part in self.parts(conjunction(expr)) {
            parts.push(self.part(&part, wanted)?);
        }
        if parts.len() == 1 {
            return parts.pop().ok_or_else(String::new);
        }
        let parts: Vec<String> = parts.into_iter().map(|part| part.within(strength::AND)).collect();
        Ok(Rust(parts.join(" && "), strength::AND))
    }

    fn part(&mut self, part: &Part<'_>, wanted: Option<Kind>) -> Result<Rust, String> {
        match part {
            Part::Plain(expr) => self.expr(expr, Some(wanted.unwrap_or(Kind::Bool))),
            Part::Rising(of) => Ok(Rust::word(format!("rising({})", self.rust(of, Some(Kind::Bool))?))),
            Part::Falling(of) => Ok(Rust::word(format!("falling({})", self.rust(of, Some(Kind::Bool))?))),
            Part::Elapsed(limit, step, asks) => {
                if !asks && !self.active.iter().any(|active| same(active, step)) {
                    self.differs.push(format!("`{step}.T` is zero here while the step is not active"));
                }
                let limit = self.rust(limit, Some(Kind::Time))?;
                Ok(Rust(format!("{limit}/{}", self.names.get(step).unwrap_or_default()), strength::PRODUCT))
            }
        }
    }

    fn member(&mut self, of: &str, member: &str) -> Result<Rust, String> {
        if self.steps.contains(&of.to_lowercase()) {
            let step = self.names.get(of).unwrap_or_default().to_owned();
            return match &*member.to_lowercase() {
                "x" => Ok(Rust::word(format!("{step}.X"))),
                "t" => {
                    if !self.active.iter().any(|active| same(active, of)) {
                        self.differs.push(format!("`{of}.T` is zero here while the step is not active"));
                    }
                    Ok(Rust::word(format!("{step}.T")))
                }
                _ => Err(format!("a step has no `{member}`")),
            };
        }
        match self.instances.get(&of.to_lowercase()).cloned() {
            Some(Instance::Rising(of)) if same(member, "q") => self.part(&Part::Rising(of), None),
            Some(Instance::Falling(of)) if same(member, "q") => self.part(&Part::Falling(of), None),
            Some(Instance::Delayed(of, limit)) if same(member, "q") => {
                let of = self.expr(&of, Some(Kind::Bool))?.within(strength::UNARY);
                Ok(Rust(format!("{}/{of}", self.rust(&limit, Some(Kind::Time))?), strength::PRODUCT))
            }
            _ => Err(format!("`{of}.{member}` is a part of something that Rust does not have")),
        }
    }

    /// Where it can be told.
    pub(super) fn kind(&self, expr: &Expr) -> Option<Kind> {
        match expr {
            Expr::Int(_) | Expr::Real(_) => None,
            Expr::Time(_) => Some(Kind::Time),
            Expr::Name(name) => self.kinds.get(&name.to_lowercase()).copied(),
            Expr::Member(_, member) => Some(if same(member, "t") { Kind::Time } else { Kind::Bool }),
            Expr::Call(name, arguments) => {
                let function = self.pous.iter().find(|pou| same(&pou.name, name));
                let returned = function.and_then(|pou| Kind::of(pou.returns.as_deref()?));
                returned.or_else(|| arguments.iter().find_map(|(_, argument)| self.kind(argument)))
            }
            Expr::Minus(inner) => self.kind(inner),
            Expr::Binary(Op::And | Op::Or | Op::Xor | Op::Add | Op::Sub | Op::Mul | Op::Div | Op::Mod, a, b) => {
                self.kind(a).or_else(|| self.kind(b))
            }
            Expr::Bool(_) | Expr::Not(_) | Expr::Binary(..) => Some(Kind::Bool),
        }
    }

    fn binary(&mut self, op: Op, a: &Expr, b: &Expr, wanted: Option<Kind>) -> Result<Rust, String> {
        let (left, right) = (self.kind(a), self.kind(b));
        let compares = matches!(op, Op::Equal | Op::Differs | Op::Less | Op::AtMost | Op::More | Op::AtLeast);
        let both = left.or(right);
        let bits = matches!(both, Some(Kind::Number(_)));
        let (sign, strength) = match op {
            Op::Or if bits => ("|", strength::BIT_OR),
            Op::And if bits => ("&", strength::BIT_AND),
            Op::Or => ("||", strength::OR),
            Op::And => ("&&", strength::AND),
            Op::Xor => ("^", strength::XOR),
            Op::Equal => ("==", strength::COMPARE),
            Op::Differs => ("!=", strength::COMPARE),
            Op::Less => ("<", strength::COMPARE),
            Op::AtMost => ("<=", strength::COMPARE),
            Op::More => (">", strength::COMPARE),
            Op::AtLeast => (">=", strength::COMPARE),
            Op::Add => ("+", strength::SUM),
            Op::Sub => ("-", strength::SUM),
            Op::Mul => ("*", strength::PRODUCT),
            Op::Div => ("/", strength::PRODUCT),
            Op::Mod => ("%", strength::PRODUCT),
        };
        if let (Some(one), Some(other)) = (left, right) {
            if one != other {
                return Err(format!(
                    "{} and {} are two types, and Rust would need to be told how one becomes the other",
                    one.rust(),
                    other.rust()
                ));
            }
        }
        if !compares && both == Some(Kind::Time) {
            return Err("arithmetic of times".to_owned());
        }
        let kind = if compares { both } else { both.or(wanted) };
        let left = self.expr(a, kind)?.within(if compares { strength + 1 } else { strength });
        let of_bool = matches!(op, Op::Or | Op::And | Op::Xor);
        let right = self.expr(b, kind)?.within(if of_bool { strength } else { strength + 1 });
        Ok(Rust(format!("{left} {sign} {right}"), strength))
    }

    fn call(&mut self, name: &str, arguments: &[(Option<String>, Expr)], wanted: Option<Kind>) -> Result<Rust, String> {
        if let [(_, one), rest @ ..] = arguments {
            let method = match (&*name.to_uppercase(), rest.len()) {
                ("ABS", 0) => Some("abs"),
                ("MIN", 1) => Some("min"),
                ("MAX", 1) => Some("max"),
                _ => None,
            };
            if let Some(method) = method {
                let kind = self.kind(one).or(wanted);
                let one = self.expr(one, kind)?.within(strength::WORD);
                let rest: Vec<String> =
                    rest.iter().map(|(_, other)| self.rust(other, kind)).collect::<Result<_, _>>()?;
                return Ok(Rust::word(format!("{one}.{method}({})", rest.join(", "))));
            }
        }
        let Some(function) = self.pous.iter().find(|pou| same(&pou.name, name) && pou.returns.is_some()) else {
            return Err(format!("the function `{name}` is not in this file"));
        };
        let inputs: Vec<_> =
            function.variables.iter().filter(|one| one.section == super::source::Section::Input).collect();
        let mut given = Vec::new();
        for (index, input) in inputs.iter().enumerate() {
            let named = arguments.iter().find(|(name, _)| name.as_deref().is_some_and(|name| same(name, &input.name)));
            let Some((_, argument)) = named.or_else(|| arguments.get(index).filter(|(name, _)| name.is_none())) else {
                return Err(format!("`{name}` is called without `{}`", input.name));
            };
            given.push(self.rust(argument, Kind::of(&input.ty))?);
        }
        // What was Rust once is Rust again, if it still means the same.
        let unchanged =
            inputs.len() == given.len() && inputs.iter().zip(&given).all(|(input, given)| input.name == *given);
        let rust =
            written_in_rust(&function.body).filter(|rust| inputs.iter().all(|input| mentions(rust, &input.name)));
        if let (true, Some(rust)) = (unchanged, rust) {
            let is_word = !rust.contains(' ')
                || rust.split_once('(').is_some_and(|(before, _)| !before.contains(' ') && rust.ends_with(')'));
            return Ok(Rust(rust.to_owned(), if is_word { strength::WORD } else { strength::NONE }));
        }
        self.called.insert(name.to_lowercase());
        if self.names.get(name).is_none() {
            self.names.value(name);
        }
        Ok(Rust::word(format!("{}({})", self.names.get(name).unwrap_or_default(), given.join(", "))))
    }

    /// Statements of a block of Rust, one a line.
    pub(super) fn block(&mut self, statements: &[Statement], depth: usize) -> Result<Vec<String>, String> {
        let indent = "    ".repeat(depth);
        let mut lines = Vec::new();
        for statement in statements {
            match statement {
                Statement::Assign(target, value) => {
                    let Some(kind) = self.kinds.get(&target.to_lowercase()).copied() else {
                        return Err(format!("`{target}` is not declared as a value that Rust has"));
                    };
                    let value = self.rust(value, Some(kind))?;
                    lines.push(format!("{indent}{} = {value};", self.names.get(target).unwrap_or_default()));
                }
                Statement::Call(name, _) => return Err(format!("`{name}(…)` among other statements")),
                Statement::If(branches, otherwise) => {
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
                }
            }
        }
        Ok(lines)
    }
}

/// What `cargo grafcet export` has written into a function that stands for Rust.
fn written_in_rust(body: &str) -> Option<&str> {
    let (_, rest) = body.split_once("TO BE WRITTEN, in Rust: ")?;
    let line = rest.lines().next()?.trim();
    Some(line.strip_suffix("*)").unwrap_or(line).trim())
}

/// As a word.
fn mentions(rust: &str, name: &str) -> bool {
    rust.split(|letter: char| !letter.is_alphanumeric() && letter != '_').any(|word| word == name)
}

fn literal(text: &str) -> Rust {
    Rust(text.to_owned(), if text.starts_with('-') { strength::UNARY } else { strength::WORD })
}

/// `1m30s`
pub(super) fn time(nanos: u64) -> Result<String, String> {
    const UNITS: [(&str, u64); 4] = [("h", 3_600_000), ("m", 60_000), ("s", 1_000), ("ms", 1)];
    if nanos % 1_000_000 != 0 {
        return Err("a time finer than the millisecond in which the chart counts".to_owned());
    }
    let mut rest = nanos / 1_000_000;
    let mut text = String::new();
    for (unit, size) in UNITS {
        if rest >= size {
            text.push_str(&(rest / size).to_string());
            text.push_str(unit);
            rest %= size;
        }
    }
    Ok(if text.is_empty() { "0s".to_owned() } else { text })
}
