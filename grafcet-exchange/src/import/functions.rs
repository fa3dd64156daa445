//! Functions: those of the standard in the words of Rust, those of the file as functions that a person has to write.

use super::expr::{Kind, Rust, Scope, strength};
use super::parser::{Arguments, Expr, Op};
use super::source::{Section, same};

impl Scope<'_> {
    /// What a function of the standard gives, where it can be told.
    pub(super) fn returned(&self, name: &str, arguments: &Arguments) -> Option<Kind> {
        let upper = name.to_uppercase();
        if operator(&upper)
            .is_some_and(|op| matches!(op, Op::Equal | Op::Differs | Op::Less | Op::AtMost | Op::More | Op::AtLeast))
        {
            return Some(Kind::Bool);
        }
        if let Some((_, to)) = conversion(&upper) {
            return self.kind_of(to);
        }
        // What chooses is none of the values.
        let chosen = |(index, (name, _)): &(usize, &(Option<String>, Expr))| match name {
            Some(name) => upper != "SEL" || !same(name, "G"),
            None => upper != "SEL" || *index > 0,
        };
        let values: Vec<&Expr> = arguments.iter().enumerate().filter(chosen).map(|(_, (_, value))| value).collect();
        self.common_of(&values).ok().flatten()
    }

    /// None where it is no function of the standard.
    fn standard(&mut self, name: &str, arguments: &Arguments, wanted: Option<Kind>) -> Option<Result<Rust, String>> {
        // Where the file has a function of that name, it is meant.
        if self.pous.iter().any(|pou| same(&pou.name, name) && pou.returns.is_some()) {
            return None;
        }
        let upper = name.to_uppercase();
        let values: Vec<&Expr> = arguments.iter().map(|(_, value)| value).collect();
        Some(match (&*upper, &values[..]) {
            ("ABS", [one]) => self.method(one, "abs", wanted),
            ("MIN" | "MAX", [_, _, ..]) => self.extreme(&values, &upper.to_lowercase(), wanted),
            ("LIMIT", [_, _, _]) => self.limit(arguments, wanted),
            ("SEL", [_, _, _]) => self.select(arguments, wanted),
            ("MOVE", [one]) => self.expr(one, wanted),
            // As counters that are written out count.
            ("SATURATING_ADD" | "SATURATING_SUB", [of, by]) => {
                let kind = self.kind(of);
                self.expr(of, kind).and_then(|of| {
                    let by = self.rust(by, kind)?;
                    Ok(Rust::word(format!("{}.{name}({by})", of.within(strength::WORD))))
                })
            }
            ("SHL" | "SHR" | "ROL" | "ROR", [of, by]) => self.shifted(&upper, of, by, wanted),
            (_, [first, rest @ ..]) if operator(&upper).is_some() && !rest.is_empty() => {
                let op = operator(&upper)?;
                let fold = |all, next: &&Expr| Expr::Binary(op, Box::new(all), Box::new((*next).clone()));
                self.expr(&rest.iter().fold((*first).clone(), fold), wanted)
            }
            (_, [one]) if conversion(&upper).is_some() => {
                let (from, to) = conversion(&upper)?;
                self.converted(one, from, to)
            }
            _ => return None,
        })
    }

    /// The type that all of them have, or become.
    fn common_of(&self, values: &[&Expr]) -> Result<Option<Kind>, String> {
        values.iter().try_fold(None, |kind, value| self.common(kind, self.kind(value)))
    }

    /// `a.abs()`
    fn method(&mut self, of: &Expr, method: &str, wanted: Option<Kind>) -> Result<Rust, String> {
        let kind = self.kind(of).or(wanted);
        Ok(Rust::word(format!("{}.{method}()", self.expr(of, kind)?.within(strength::WORD))))
    }

    /// `a.min(b).min(c)`: a literal has no methods, as Rust does not know its type yet.
    fn extreme(&mut self, values: &[&Expr], method: &str, wanted: Option<Kind>) -> Result<Rust, String> {
        let kind = self.common_of(values)?.or(wanted);
        let Some(first) = values.iter().position(|value| self.kind(value).is_some()) else {
            return Err(format!("`{}` of literals alone", method.to_uppercase()));
        };
        let mut text = self.operand(values[first], kind)?.within(strength::WORD);
        for (_, other) in values.iter().enumerate().filter(|(index, _)| *index != first) {
            text = format!("{text}.{method}({})", self.rust(other, kind)?);
        }
        Ok(Rust::word(text))
    }

    /// `LIMIT(MN, IN, MX)`, where the upper end counts if the ends are the wrong way round.
    fn limit(&mut self, arguments: &Arguments, wanted: Option<Kind>) -> Result<Rust, String> {
        let [least, of, most] = named(arguments, ["MN", "IN", "MX"]);
        let kind = self.common_of(&[of, least, most])?.or(wanted);
        if self.kind(of).is_none() {
            return Err("`LIMIT` of a literal".to_owned());
        }
        let of = self.operand(of, kind)?.within(strength::WORD);
        Ok(Rust::word(format!("{of}.max({}).min({})", self.rust(least, kind)?, self.rust(most, kind)?)))
    }

    /// `SEL(G, IN0, IN1)`
    fn select(&mut self, arguments: &Arguments, wanted: Option<Kind>) -> Result<Rust, String> {
        let [which, no, yes] = named(arguments, ["G", "IN0", "IN1"]);
        let kind = self.common_of(&[no, yes])?.or(wanted);
        let which = self.rust(which, Some(Kind::Bool))?;
        let (yes, no) = (self.rust(yes, kind)?, self.rust(no, kind)?);
        Ok(Rust(format!("if {which} {{ {yes} }} else {{ {no} }}"), strength::NONE))
    }

    /// By a literal, as Rust shifts by less than a width alone.
    fn shifted(&mut self, name: &str, of: &Expr, by: &Expr, wanted: Option<Kind>) -> Result<Rust, String> {
        let kind = self.kind(of).or(wanted);
        let Some(Kind::Number(ty @ ("u8" | "u16" | "u32" | "u64"))) = kind else {
            return Err(format!("`{name}` of what is no word"));
        };
        let Expr::Int(by) = by else { return Err(format!("`{name}` by what is no literal")) };
        if !(0..ty[1..].parse().unwrap_or(0)).contains(by) {
            return Err(format!("`{name}` by {by}"));
        }
        let method = match name {
            "SHL" => {
                return Ok(Rust(format!("{} << {by}", self.expr(of, kind)?.within(strength::WORD)), strength::NONE));
            }
            "SHR" => {
                return Ok(Rust(format!("{} >> {by}", self.expr(of, kind)?.within(strength::WORD)), strength::NONE));
            }
            "ROL" => "rotate_left",
            _ => "rotate_right",
        };
        Ok(Rust::word(format!("{}.{method}({by})", self.expr(of, kind)?.within(strength::WORD))))
    }

    /// `INT_TO_DINT(n)`
    fn converted(&mut self, of: &Expr, from: Option<&str>, to: &str) -> Result<Rust, String> {
        let Some(to) = self.kind_of(to) else { return Err(format!("the type `{to}` is none that Rust has")) };
        let from = self.kind(of).or_else(|| self.kind_of(from?));
        let of = self.expr(of, from)?;
        let name = self.type_of(to);
        let float = |name: &str| name.starts_with('f');
        match (from, to) {
            (Some(from), to) if from == to => Ok(of),
            (Some(Kind::Bool), Kind::Number(ty)) if !float(ty) => Ok(Rust::word(format!("{ty}::from({})", of.0))),
            (Some(Kind::Number(from)), Kind::Bool) if !float(from) => {
                Ok(Rust(format!("{} != 0", of.within(strength::COMPARE + 1)), strength::COMPARE))
            }
            (Some(Kind::Number(from)), Kind::Number(to)) if float(to) || !float(from) => {
                Ok(Rust(format!("{} as {name}", of.within(strength::UNARY)), strength::NONE))
            }
            (Some(Kind::Enum(_)), Kind::Number(to)) if !float(to) => {
                Ok(Rust(format!("{} as {name}", of.within(strength::UNARY)), strength::NONE))
            }
            (Some(from), _) => Err(format!("a {} as a {name}", self.type_of(from))),
            (None, _) => Err(format!("a value without a type as a {name}")),
        }
    }

    pub(super) fn call(&mut self, name: &str, arguments: &Arguments, wanted: Option<Kind>) -> Result<Rust, String> {
        if let Some(done) = self.standard(name, arguments, wanted) {
            return done;
        }
        let Some(function) = self.pous.iter().find(|pou| same(&pou.name, name) && pou.returns.is_some()) else {
            return Err(format!("the function `{name}` is not in this file"));
        };
        let inputs: Vec<_> = function.variables.iter().filter(|one| one.section == Section::Input).collect();
        let mut given = Vec::new();
        for (index, input) in inputs.iter().enumerate() {
            let named = arguments.iter().find(|(name, _)| name.as_deref().is_some_and(|name| same(name, &input.name)));
            let Some((_, argument)) = named.or_else(|| arguments.get(index).filter(|(name, _)| name.is_none())) else {
                return Err(format!("`{name}` is called without `{}`", input.name));
            };
            let kind = self.kind_of(&input.ty);
            given.push(self.rust(argument, kind)?);
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
}

/// By name, else by place.
fn named<'e, const N: usize>(arguments: &'e Arguments, names: [&str; N]) -> [&'e Expr; N] {
    std::array::from_fn(|index| {
        let by_name = arguments.iter().find(|(name, _)| name.as_deref().is_some_and(|name| same(name, names[index])));
        &by_name.unwrap_or(&arguments[index]).1
    })
}

/// What a function stands for that is an operator, too.
fn operator(upper: &str) -> Option<Op> {
    Some(match upper {
        "AND" => Op::And,
        "OR" => Op::Or,
        "XOR" => Op::Xor,
        "ADD" => Op::Add,
        "SUB" => Op::Sub,
        "MUL" => Op::Mul,
        "DIV" => Op::Div,
        "MOD" => Op::Mod,
        "GT" => Op::More,
        "GE" => Op::AtLeast,
        "EQ" => Op::Equal,
        "NE" => Op::Differs,
        "LE" => Op::AtMost,
        "LT" => Op::Less,
        _ => return None,
    })
}

/// `INT_TO_DINT`, `TO_DINT`
fn conversion(upper: &str) -> Option<(Option<&str>, &str)> {
    upper.split_once("_TO_").map(|(from, to)| (Some(from), to)).or_else(|| Some((None, upper.strip_prefix("TO_")?)))
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
