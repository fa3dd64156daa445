//! A program as pseudo-code for a person.

use std::fmt::{self, Display, Formatter, Write as _};

use super::{Comparison, Expr, Fence, Initial, Mark, Phase, PlaceId, Program, Statement, Type, User, Value, Wait};
use crate::model::{Binary, Model, Read, StepId, Tree, Ty, Unary};

/// No line of the list of locals is longer.
const WIDTH: usize = 120;

impl Display for Program<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let dialect = if self.model.is_grafcet() { "grafcet" } else { "sfc" };
        writeln!(f, "{dialect} {}\n\nfields", self.model.name)?;
        for (index, place) in self.places.iter().enumerate().filter(|(_, place)| place.is_field) {
            writeln!(f, "  {}: {} = {}", place.name, self.ty(place.ty), self.initial(PlaceId(index)))?;
        }
        self.locals(f)?;
        writeln!(f, "\ncycle")?;
        self.block(f, &self.cycle, 1)?;
        let Some(deadline) = &self.deadline else { return Ok(()) };
        writeln!(f, "\ndeadline")?;
        let name = |place: PlaceId| &self.places[place.0].name;
        writeln!(f, "  at {} if {}", self.expr(&deadline.reading, 0), self.expr(&deadline.at_once, 0))?;
        for Wait { condition, from, time } in &deadline.waits {
            let (from, time) = (name(*from), self.expr(time, 0));
            writeln!(f, "  {time} after {from} if {}", self.expr(condition, 0))?;
        }
        for (step, over) in &deadline.late {
            writeln!(f, "  {} late if {}", self.model.steps[*step].name, self.expr(over, 0))?;
        }
        Ok(())
    }
}

impl fmt::Debug for Program<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        Display::fmt(self, f)
    }
}

impl Program<'_> {
    /// Those of a cycle: their names alone.
    fn locals(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let mut line = String::new();
        for place in self.places.iter().filter(|place| !place.is_field) {
            if line.is_empty() {
                line.push_str("\nlocals\n ");
            }
            let width = line.lines().last().map_or(0, |line| line.chars().count());
            if width + place.name.chars().count() + 2 > WIDTH {
                line.push_str("\n ");
            }
            _ = write!(line, " {}", place.name);
        }
        if line.is_empty() { Ok(()) } else { writeln!(f, "{line}") }
    }

    fn ty(&self, ty: Type<'_>) -> String {
        match ty {
            Type::Bool => "bool".to_owned(),
            Type::Ticks => "time".to_owned(),
            Type::Number => "number".to_owned(),
            Type::Kind { .. } => "kind".to_owned(),
            Type::Phase => "phase".to_owned(),
            Type::State(region) => {
                let name = |state: &StepId| match &self.active_in(region, *state)[..] {
                    [_] => self.model.steps[*state].name.to_string(),
                    steps => self.joint(*state, steps),
                };
                self.states(region).iter().map(name).collect::<Vec<_>>().join(" | ")
            }
            Type::User(Ty::Int { rust, .. } | Ty::Other(rust)) => spaced(&quote::quote!(#rust).to_string()),
            Type::User(_) => "?".to_owned(),
        }
    }

    /// `Wait (Ready, Auto)`
    fn joint(&self, state: StepId, steps: &[StepId]) -> String {
        let name = |step: StepId| self.model.steps[step].name.to_string();
        let others = steps.iter().filter(|step| **step != state).map(|step| name(*step));
        format!("{} ({})", name(state), others.collect::<Vec<_>>().join(", "))
    }

    fn initial(&self, place: PlaceId) -> String {
        match self.places[place.0].initial {
            Initial::Value(value) => self.value(value),
            Initial::Constant(expr) => expr.text.clone(),
            Initial::Default => "default".to_owned(),
        }
    }

    fn value(&self, value: Value) -> String {
        match value {
            Value::Bool(value) => value.to_string(),
            Value::Int(value) => value.to_string(),
            Value::Ticks(ticks) => self.model.time_text(i128::from(ticks)),
            Value::Step(Some(step)) => self.model.steps[step].name.to_string(),
            Value::Step(None) => "none".to_owned(),
            Value::Start(_) => "start".to_owned(),
            Value::Phase(Phase::First) => "first".to_owned(),
            Value::Phase(Phase::Repeated) => "repeated".to_owned(),
            Value::Phase(Phase::Final) => "final".to_owned(),
            Value::Other(handle) => format!("value {handle}"),
        }
    }

    fn name(&self, place: PlaceId) -> &str {
        &self.places[place.0].name
    }

    fn block(&self, f: &mut Formatter<'_>, statements: &[Statement<'_>], depth: usize) -> fmt::Result {
        for statement in statements {
            self.statement(f, statement, depth)?;
        }
        Ok(())
    }

    fn statement(&self, f: &mut Formatter<'_>, statement: &Statement<'_>, depth: usize) -> fmt::Result {
        let indent = "  ".repeat(depth);
        if let Some(line) = self.line(statement) {
            return writeln!(f, "{indent}{line}");
        }
        match statement {
            Statement::Part(name, body) => {
                writeln!(f, "{indent}-- {name}")?;
                self.block(f, body, depth)
            }
            Statement::If(condition, then, otherwise) => {
                write!(f, "{indent}")?;
                self.branches(f, condition, then, otherwise, depth)
            }
            Statement::Match(place, arms, otherwise) => {
                writeln!(f, "{indent}match {}", self.name(*place))?;
                for (values, body) in arms {
                    let values: Vec<String> = values.iter().map(|value| self.value(*value)).collect();
                    self.arm(f, &values.join("|"), body, depth + 1)?;
                }
                if otherwise.is_empty() { Ok(()) } else { self.arm(f, "else", otherwise, depth + 1) }
            }
            Statement::Loop { rounds, body } => {
                writeln!(f, "{indent}loop, at most {rounds} times")?;
                self.block(f, body, depth + 1)
            }
            _ => Ok(()),
        }
    }

    fn arm(&self, f: &mut Formatter<'_>, name: &str, body: &[Statement<'_>], depth: usize) -> fmt::Result {
        let indent = "  ".repeat(depth);
        if let [one] = body {
            if let Some(line) = self.line(one) {
                return writeln!(f, "{indent}{name}: {line}");
            }
        }
        writeln!(f, "{indent}{name}:")?;
        self.block(f, body, depth + 1)
    }

    /// `if a: …`, `else if b: …`, `else: …`
    fn branches(
        &self,
        f: &mut Formatter<'_>,
        condition: &Expr<'_>,
        then: &[Statement<'_>],
        otherwise: &[Statement<'_>],
        depth: usize,
    ) -> fmt::Result {
        let indent = "  ".repeat(depth);
        write!(f, "if {}:", self.expr(condition, 0))?;
        self.branch(f, then, depth)?;
        match otherwise {
            [] => Ok(()),
            [Statement::If(condition, then, otherwise)] => {
                write!(f, "{indent}else ")?;
                self.branches(f, condition, then, otherwise, depth)
            }
            _ => {
                write!(f, "{indent}else:")?;
                self.branch(f, otherwise, depth)
            }
        }
    }

    fn branch(&self, f: &mut Formatter<'_>, body: &[Statement<'_>], depth: usize) -> fmt::Result {
        if let [one] = body {
            if let Some(line) = self.line(one) {
                return writeln!(f, " {line}");
            }
        }
        writeln!(f)?;
        self.block(f, body, depth + 1)
    }

    /// A statement that is one line.
    fn line(&self, statement: &Statement<'_>) -> Option<String> {
        let model = self.model;
        Some(match statement {
            Statement::Set(place, value) => format!("{} = {}", self.name(*place), self.expr(value, 0)),
            Statement::Break => "break".to_owned(),
            Statement::Fence(Fence::Memory) => "fence".to_owned(),
            Statement::Fence(Fence::Armv6m) => "fence on ARMv6-M".to_owned(),
            Statement::Fence(Fence::BeyondArmv6m) => "fence but on ARMv6-M".to_owned(),
            Statement::Fence(Fence::Inputs) => "fence inputs".to_owned(),
            Statement::Run(run) => {
                let writes = run.writes.iter().map(|write| self.name(write.to).to_owned()).collect::<Vec<_>>();
                let reads: Vec<String> = run.binds.iter().map(|(read, value)| self.bind(*read, value)).collect();
                format!("run {} with {} -> {}", run.code.text, reads.join(", "), writes.join(", "))
            }
            Statement::Call(action, phase, args) => {
                let args: Vec<String> = args.iter().map(|arg| self.expr(arg, 0)).collect();
                format!("call {}({}) {}", model.actions[*action].name, args.join(", "), self.expr(phase, 0))
            }
            Statement::Mark(Mark::Cleared(id)) => {
                format!("cleared({})", model.transition_text(&model.transitions[*id]).replace('`', ""))
            }
            Statement::Mark(Mark::Activated(step)) => format!("activated({})", model.steps[*step].name),
            Statement::Mark(Mark::Deactivated(step)) => format!("deactivated({})", model.steps[*step].name),
            Statement::Mark(Mark::Evolved) => "evolved".to_owned(),
            Statement::Part(..) | Statement::If(..) | Statement::Match(..) | Statement::Loop { .. } => return None,
        })
    }

    /// What a name in a block stands for.
    fn bind(&self, read: Read, value: &Expr<'_>) -> String {
        let value = self.expr(value, 0);
        match read {
            Read::Name(name) if self.model.value_name(name) == &value => value,
            Read::Name(name) => format!("{} = {value}", self.model.value_name(name)),
            _ => value,
        }
    }

    /// An expression, in parentheses where it binds less closely than what stands around it.
    fn expr(&self, expr: &Expr<'_>, around: u8) -> String {
        let two = |a: &Expr<'_>, sign: &str, b: &Expr<'_>| format!("{} {sign} {}", self.expr(a, 4), self.expr(b, 4));
        let (text, binds) = match expr {
            Expr::Value(value) => (self.value(*value), 9),
            Expr::Place(place) => (self.name(*place).to_owned(), 9),
            Expr::Initial(place) => (self.initial(*place), 9),
            Expr::Input(id) => (self.model.inputs[*id].name.to_string(), 9),
            Expr::Now => ("now".to_owned(), 9),
            Expr::Is(place, steps) => {
                let names: Vec<String> = steps.iter().map(|step| self.model.steps[*step].name.to_string()).collect();
                (format!("{} is {}", self.name(*place), names.join("|")), 3)
            }
            Expr::Not(inner) => (format!("!{}", self.expr(inner, 8)), 8),
            Expr::All(parts) => (self.list(parts, " && ", 2), 2),
            Expr::Any(parts) => (self.list(parts, " || ", 1), 1),
            Expr::Compare(comparison, a, b) => {
                let sign = match comparison {
                    Comparison::Equal => "==",
                    Comparison::Differs => "!=",
                    Comparison::Below => "<",
                    Comparison::AtLeast => ">=",
                };
                (two(a, sign, b), 3)
            }
            Expr::Choose(parts) => {
                let [condition, then, otherwise] = &**parts;
                let parts = [condition, then, otherwise].map(|part| self.expr(part, 0));
                (format!("if {} then {} else {}", parts[0], parts[1], parts[2]), 0)
            }
            Expr::Table(place, table) => {
                let name = match table.first() {
                    Some((_, Value::Ticks(_))) => "times",
                    Some((_, Value::Int(_))) => "kinds",
                    _ => "table",
                };
                (format!("{name}({})", self.name(*place)), 9)
            }
            Expr::Next(place) => (format!("{} + 1", self.name(*place)), 4),
            Expr::Add(a, b) => (two(a, "+", b), 4),
            Expr::Sub(a, b) => (two(a, "-", b), 4),
            Expr::Since(a, b) => (format!("since({}, {})", self.expr(a, 0), self.expr(b, 0)), 9),
            Expr::Period(reached, passed, period) => {
                let period = self.model.time_text(i128::from(*period));
                (format!("period({}, {}, {period})", self.expr(reached, 0), self.expr(passed, 0)), 9)
            }
            Expr::User(user) => return self.tree(user.tree, user, around),
        };
        if binds < around || binds == 0 && around > 0 { format!("({text})") } else { text }
    }

    fn list(&self, parts: &[Expr<'_>], sign: &str, binds: u8) -> String {
        parts.iter().map(|part| self.expr(part, binds + 1)).collect::<Vec<_>>().join(sign)
    }

    /// What the user has written, with what its names stand for.
    fn tree(&self, tree: &Tree, user: &User<'_>, around: u8) -> String {
        let bound = |read: Read| {
            let value = user.binds.iter().find(|(other, _)| *other == read);
            value.map_or_else(|| "?".to_owned(), |(_, value)| self.expr(value, around))
        };
        let (text, binds) = match tree {
            Tree::Bool(value) => (value.to_string(), 9),
            Tree::Int(value) => (value.to_string(), 9),
            Tree::Read(read) => return bound(*read),
            Tree::Elapsed(time, step) => return bound(Read::Elapsed(*time, *step)),
            Tree::MacroElapsed(time, id) => return bound(Read::MacroElapsed(*time, *id)),
            Tree::Unary(Unary::Not, inner) => (format!("!{}", self.tree(inner, user, 8)), 8),
            Tree::Unary(Unary::Neg, inner) => (format!("-{}", self.tree(inner, user, 8)), 8),
            Tree::Binary(operator, a, b) => {
                let (sign, binds) = sign(*operator);
                let (left, right) = (self.operand(a, b, user, binds), self.operand(b, a, user, binds + 1));
                (format!("{left} {sign} {right}"), binds)
            }
            Tree::Opaque { text, reads, .. } => {
                let reads: Vec<String> = reads.iter().map(|read| bound(*read)).collect();
                (format!("rust {{ {text} }} of ({})", reads.join(", ")), 9)
            }
        };
        if binds < around { format!("({text})") } else { text }
    }

    /// A variant by its name, where an enum is compared.
    fn operand(&self, tree: &Tree, other: &Tree, user: &User<'_>, binds: u8) -> String {
        let variant = Model::variant_text(self.model, other, tree);
        variant.unwrap_or_else(|| self.tree(tree, user, binds))
    }
}

/// How an operator is written, and how closely it binds.
fn sign(operator: Binary) -> (&'static str, u8) {
    match operator {
        Binary::Or => ("||", 1),
        Binary::And => ("&&", 2),
        Binary::Eq => ("==", 3),
        Binary::Ne => ("!=", 3),
        Binary::Lt => ("<", 3),
        Binary::Le => ("<=", 3),
        Binary::Gt => (">", 3),
        Binary::Ge => (">=", 3),
        Binary::BitOr => ("|", 4),
        Binary::BitXor => ("^", 5),
        Binary::BitAnd => ("&", 5),
        Binary::Shl => ("<<", 6),
        Binary::Shr => (">>", 6),
        Binary::Add => ("+", 6),
        Binary::Sub => ("-", 6),
        Binary::Mul => ("*", 7),
        Binary::Div => ("/", 7),
        Binary::Rem => ("%", 7),
    }
}

/// Tokens are printed with more spaces than a person writes.
fn spaced(tokens: &str) -> String {
    tokens.replace(" :: ", "::").replace(" < ", "<").replace(" >", ">").replace(" ,", ",")
}
