//! Conditions, values and statements in Rust.

use std::collections::{BTreeMap, BTreeSet};

use super::names::Names;
use super::parser::{Expr, Op};
use super::parts::{Part, conjunction};
use super::source::{Pou, same};
use super::timers::Timed;
use super::types::Enum;

/// What a value is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Kind {
    Bool,
    /// By the name in Rust, floats among them.
    Number(&'static str),
    Time,
    /// By its place among the enums of the file.
    Enum(usize),
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
}

/// What stands in Rust for an instance of a standard function block.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Instance {
    Rising(Expr),
    Falling(Expr),
    /// `TON`, by its time.
    Delayed(Expr, Expr),
    /// `TON` that is called in some steps alone.
    Timed(Vec<Timed>),
    /// `TOF`, by its time.
    Kept(Expr, Expr),
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
    pub(super) enums: &'p [Enum],
    /// By their places, those that the chart needs.
    pub(super) used: BTreeSet<usize>,
    /// Control variables of `FOR` that nothing else reads: they belong to their loop.
    pub(super) counters: BTreeMap<String, Kind>,
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
pub(super) mod strength {
    pub(in crate::import) const NONE: u8 = 0;
    pub(in crate::import) const OR: u8 = 1;
    pub(in crate::import) const AND: u8 = 2;
    pub(in crate::import) const COMPARE: u8 = 3;
    pub(in crate::import) const BIT_OR: u8 = 4;
    pub(in crate::import) const XOR: u8 = 5;
    pub(in crate::import) const BIT_AND: u8 = 6;
    pub(in crate::import) const SUM: u8 = 7;
    pub(in crate::import) const PRODUCT: u8 = 8;
    pub(in crate::import) const UNARY: u8 = 9;
    pub(in crate::import) const WORD: u8 = 10;
}

/// Rust, and how strongly it holds together.
pub(super) struct Rust(pub(super) String, pub(super) u8);

impl Rust {
    pub(super) fn word(text: impl Into<String>) -> Self {
        Self(text.into(), strength::WORD)
    }

    pub(super) fn within(self, strength: u8) -> String {
        if self.1 < strength { format!("({})", self.0) } else { self.0 }
    }
}

impl Scope<'_> {
    /// An expression in Rust, or what of it has no translation.
    pub(super) fn rust(&mut self, expr: &Expr, wanted: Option<Kind>) -> Result<String, String> {
        Ok(self.operand(expr, wanted)?.0)
    }

    pub(super) fn expr(&mut self, expr: &Expr, wanted: Option<Kind>) -> Result<Rust, String> {
        match expr {
            Expr::Bool(value) => Ok(Rust::word(value.to_string())),
            Expr::Int(value @ (0 | 1)) if wanted == Some(Kind::Bool) => Ok(Rust::word((*value == 1).to_string())),
            Expr::Int(value) if matches!(wanted, Some(Kind::Enum(_))) => self.numbered(*value, wanted),
            Expr::Int(value) if matches!(wanted, Some(Kind::Number("f32" | "f64"))) => {
                Ok(literal(&format!("{value}.0")))
            }
            Expr::Int(value) if wanted.is_none_or(|kind| fits(*value, kind)) => Ok(literal(&value.to_string())),
            Expr::Real(value) if wanted.is_none_or(|kind| matches!(kind, Kind::Number("f32" | "f64"))) => {
                Ok(literal(value))
            }
            Expr::Int(_) | Expr::Real(_) => {
                let kind = wanted.map(|kind| self.type_of(kind)).unwrap_or_default();
                Err(format!("a number that is no value of {kind}"))
            }
            Expr::Time(nanos) => time(*nanos).map(Rust::word),
            Expr::Name(name) if self.kinds.contains_key(&name.to_lowercase()) => {
                Ok(Rust::word(self.names.get(name).unwrap_or_default()))
            }
            Expr::Name(name) if self.counters.contains_key(&name.to_lowercase()) => {
                Ok(Rust::word(self.names.get(name).unwrap_or_default()))
            }
            Expr::Name(name) if self.listed(name, wanted).is_some() => {
                let of = self.listed(name, wanted).unwrap_or_default();
                self.variant(of, name)
            }
            Expr::Typed(ty, value) => match self.enums.iter().position(|one| same(&one.name, ty)) {
                Some(of) => self.variant(of, value),
                None => Err(format!("the type `{ty}` is not in this file")),
            },
            Expr::Bit(name, bit) => self.bit(name, *bit),
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
                Ok(Rust(format!("{limit}/{}", self.names.get_step(step).unwrap_or_default()), strength::PRODUCT))
            }
        }
    }

    fn member(&mut self, of: &str, member: &str) -> Result<Rust, String> {
        if self.steps.contains(&of.to_lowercase()) {
            let step = self.names.get_step(of).unwrap_or_default().to_owned();
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
            Some(Instance::Timed(calls)) if same(member, "q") => self.timed(of, &calls),
            Some(Instance::Kept(of, limit)) if same(member, "q") => {
                let of = self.expr(&of, Some(Kind::Bool))?.within(strength::UNARY);
                Ok(Rust(format!("0s/{of}/{}", self.rust(&limit, Some(Kind::Time))?), strength::PRODUCT))
            }
            _ => {
                // What is kept of an instance that is written out.
                let part = format!("{of}.{member}");
                if self.kinds.contains_key(&part.to_lowercase()) {
                    return Ok(Rust::word(self.names.get(&part).unwrap_or_default()));
                }
                if let Some(of) = self.enums.iter().position(|one| same(&one.name, of)) {
                    return self.variant(of, member);
                }
                Err(format!("`{part}` is a part of something that Rust does not have"))
            }
        }
    }

    /// `w.3`
    fn bit(&mut self, name: &str, bit: i128) -> Result<Rust, String> {
        let width = match self.kinds.get(&name.to_lowercase()) {
            Some(Kind::Number(of)) => of.trim_start_matches(['u', 'i']).parse().unwrap_or(0),
            _ => 0,
        };
        if !(0..width).contains(&bit) {
            return Err(format!("`{name}` has no bit {bit}"));
        }
        let name = self.names.get(name).unwrap_or_default();
        Ok(Rust(format!("{name} & (1 << {bit}) != 0"), strength::COMPARE))
    }

    /// Where it can be told.
    pub(super) fn kind(&self, expr: &Expr) -> Option<Kind> {
        match expr {
            Expr::Int(_) | Expr::Real(_) => None,
            Expr::Time(_) => Some(Kind::Time),
            Expr::Name(name) => {
                let key = name.to_lowercase();
                let known = self.kinds.get(&key).or_else(|| self.counters.get(&key)).copied();
                known.or_else(|| self.listed(name, None).map(Kind::Enum))
            }
            Expr::Member(of, member) => {
                if !self.steps.contains(&of.to_lowercase()) {
                    let part = self.kinds.get(&format!("{of}.{member}").to_lowercase()).copied();
                    if let Some(kind) = part.or_else(|| self.kind_of(of).filter(|kind| matches!(kind, Kind::Enum(_)))) {
                        return Some(kind);
                    }
                }
                Some(if same(member, "t") { Kind::Time } else { Kind::Bool })
            }
            Expr::Typed(of, _) => self.kind_of(of),
            Expr::Call(name, arguments) => {
                let function = self.pous.iter().find(|pou| same(&pou.name, name));
                let returned = function.and_then(|pou| self.kind_of(pou.returns.as_deref()?));
                returned.or_else(|| self.returned(name, arguments))
            }
            Expr::Minus(inner) => self.kind(inner),
            Expr::Binary(Op::And | Op::Or | Op::Xor | Op::Add | Op::Sub | Op::Mul | Op::Div | Op::Mod, a, b) => {
                let (a, b) = (self.kind(a), self.kind(b));
                self.common(a, b).unwrap_or(a)
            }
            Expr::Not(inner) => Some(self.kind(inner).unwrap_or(Kind::Bool)),
            Expr::Bool(_) | Expr::Bit(..) | Expr::Binary(..) => Some(Kind::Bool),
        }
    }

    fn binary(&mut self, op: Op, a: &Expr, b: &Expr, wanted: Option<Kind>) -> Result<Rust, String> {
        let (left, right) = (self.kind(a), self.kind(b));
        let compares = matches!(op, Op::Equal | Op::Differs | Op::Less | Op::AtMost | Op::More | Op::AtLeast);
        let both = self.common(left, right)?;
        let bits = matches!(both, Some(Kind::Number(_)));
        // `a = TRUE`
        if let (Op::Equal | Op::Differs, of, Expr::Bool(value)) | (Op::Equal | Op::Differs, Expr::Bool(value), of) =
            (op, a, b)
        {
            if (op == Op::Equal) == *value {
                return self.expr(of, Some(Kind::Bool));
            }
            return self.expr(&Expr::Not(Box::new(of.clone())), Some(Kind::Bool));
        }
        if matches!(both, Some(Kind::Enum(_))) && !matches!(op, Op::Equal | Op::Differs) {
            return Err("values of an enum are compared with `=` and `<>` alone".to_owned());
        }
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
        if !compares && both == Some(Kind::Time) {
            return Err("arithmetic of times".to_owned());
        }
        let kind = if compares { both } else { both.or(wanted) };
        let left = self.operand(a, kind)?.within(if compares { strength + 1 } else { strength });
        let of_bool = matches!(op, Op::Or | Op::And | Op::Xor);
        let right = self.operand(b, kind)?.within(if of_bool { strength } else { strength + 1 });
        Ok(Rust(format!("{left} {sign} {right}"), strength))
    }
}

/// Whether an integer is a value of a type.
pub(super) fn fits(value: i128, kind: Kind) -> bool {
    let Kind::Number(name) = kind else { return false };
    let Ok(width) = name[1..].parse::<u32>() else { return false };
    match &name[..1] {
        "i" => (-(1_i128 << (width - 1))..1_i128 << (width - 1)).contains(&value),
        "u" => (0..1_i128 << width).contains(&value),
        _ => true,
    }
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
