//! A program as pseudo-code for a person.

use std::fmt::{self, Display, Formatter, Write as _};

use super::{Comparison, Expr, Fence, Initial, Mark, Phase, PlaceId, Program, Statement, Type, User, Value, Wait};
use crate::model::operands::{self, Leaves, binds};
use crate::model::{Model, Read, StepId, Ty};

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
        writeln!(
            f,
            "  at {} if {}",
            self.expr(&deadline.reading, binds::ALONE),
            self.expr(&deadline.at_once, binds::ALONE)
        )?;
        for Wait { condition, from, time } in &deadline.waits {
            let (from, time) = (name(*from), self.expr(time, binds::ALONE));
            writeln!(f, "  {time} after {from} if {}", self.expr(condition, binds::ALONE))?;
        }
        for (step, over) in &deadline.late {
            writeln!(f, "  {} late if {}", self.model.steps[*step].name, self.expr(over, binds::ALONE))?;
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
        write!(f, "if {}:", self.expr(condition, binds::ALONE))?;
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
            Statement::Set(place, Expr::Table(of, _)) if matches!(self.places[place.0].ty, Type::User(_)) => {
                format!("{} = numbers({})", self.name(*place), self.name(*of))
            }
            Statement::Set(place, value) => format!("{} = {}", self.name(*place), self.expr(value, binds::ALONE)),
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
                let args: Vec<String> = args.iter().map(|arg| self.expr(arg, binds::ALONE)).collect();
                format!("call {}({}) {}", model.actions[*action].name, args.join(", "), self.expr(phase, binds::ALONE))
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
        let value = self.expr(value, binds::ALONE);
        match read {
            Read::Name(name) if self.model.value_name(name) == &value => value,
            Read::Name(name) => format!("{} = {value}", self.model.value_name(name)),
            _ => value,
        }
    }

    /// An expression, in parentheses where it binds less closely than what stands around it.
    fn expr(&self, expr: &Expr<'_>, around: u8) -> String {
        let two = |a: &Expr<'_>, sign: &str, b: &Expr<'_>, (left, right): (u8, u8)| {
            format!("{} {sign} {}", self.expr(a, left), self.expr(b, right))
        };
        // Operators of sums from the left, comparisons not in a row.
        let (compared, summed) = ((binds::BIT_OR, binds::BIT_OR), (binds::SUM, binds::PRODUCT));
        let (text, binds) = match expr {
            Expr::Value(value) => (self.value(*value), binds::WHOLE),
            Expr::Place(place) => (self.name(*place).to_owned(), binds::WHOLE),
            Expr::Initial(place) => (self.initial(*place), binds::WHOLE),
            Expr::Input(id) => (self.model.inputs[*id].name.to_string(), binds::WHOLE),
            Expr::Now => ("now".to_owned(), binds::WHOLE),
            Expr::Is(place, steps) => {
                let names: Vec<String> = steps.iter().map(|step| self.model.steps[*step].name.to_string()).collect();
                (format!("{} is {}", self.name(*place), names.join("|")), binds::COMPARISON)
            }
            Expr::Not(inner) => (format!("!{}", self.expr(inner, binds::UNARY)), binds::UNARY),
            Expr::All(parts) => (self.list(parts, " && ", binds::AND), binds::AND),
            Expr::Any(parts) => (self.list(parts, " || ", binds::OR), binds::OR),
            Expr::Compare(comparison, a, b) => {
                let sign = match comparison {
                    Comparison::Equal => "==",
                    Comparison::Differs => "!=",
                    Comparison::Less => "<",
                    Comparison::AtLeast => ">=",
                };
                (two(a, sign, b, compared), binds::COMPARISON)
            }
            Expr::Choose(parts) => {
                let [condition, then, otherwise] = &**parts;
                let parts = [condition, then, otherwise].map(|part| self.expr(part, binds::ALONE));
                (format!("if {} then {} else {}", parts[0], parts[1], parts[2]), binds::ALONE)
            }
            Expr::Table(place, table) => {
                let name = match table.first() {
                    Some((_, Value::Ticks(_))) => "times",
                    Some((_, Value::Int(_))) => "kinds",
                    _ => "table",
                };
                (format!("{name}({})", self.name(*place)), binds::WHOLE)
            }
            Expr::Next(place) => (format!("{} + 1", self.name(*place)), binds::SUM),
            Expr::Add(a, b) => (two(a, "+", b, summed), binds::SUM),
            Expr::Sub(a, b) => (two(a, "-", b, summed), binds::SUM),
            Expr::Since(a, b) => {
                (format!("since({}, {})", self.expr(a, binds::ALONE), self.expr(b, binds::ALONE)), binds::WHOLE)
            }
            Expr::Period(reached, passed, period) => {
                let period = self.model.time_text(i128::from(*period));
                (
                    format!(
                        "period({}, {}, {period})",
                        self.expr(reached, binds::ALONE),
                        self.expr(passed, binds::ALONE)
                    ),
                    binds::WHOLE,
                )
            }
            Expr::User(user) => return operands::text(&Bound { program: self, user }, user.tree, around),
        };
        if binds < around { format!("({text})") } else { text }
    }

    fn list(&self, parts: &[Expr<'_>], sign: &str, binds: u8) -> String {
        parts.iter().map(|part| self.expr(part, binds + 1)).collect::<Vec<_>>().join(sign)
    }
}

/// What the user has written, with what its names stand for.
struct Bound<'p, 'm> {
    program: &'p Program<'m>,
    user: &'p User<'m>,
}

impl Leaves for Bound<'_, '_> {
    fn model(&self) -> &Model {
        self.program.model
    }

    fn read(&self, read: Read, around: u8) -> String {
        let value = self.user.binds.iter().find(|(other, _)| *other == read);
        value.map_or_else(|| "?".to_owned(), |(_, value)| self.program.expr(value, around))
    }

    fn rust(&self, text: &str, reads: &[Read]) -> (String, u8) {
        let reads: Vec<String> = reads.iter().map(|read| self.read(*read, binds::ALONE)).collect();
        (format!("rust {{ {text} }} of ({})", reads.join(", ")), binds::WHOLE)
    }
}

/// Tokens are printed with more spaces than a person writes.
fn spaced(tokens: &str) -> String {
    tokens.replace(" :: ", "::").replace(" < ", "<").replace(" >", ">").replace(" ,", ",")
}

#[cfg(test)]
mod tests {
    use crate::analysis::Facts;
    use crate::diagnostic::Sink;
    use crate::{model, parse, program};

    #[test]
    fn conditions_have_the_parentheses_that_they_need() {
        let chart = "sfc C { input a, b, c: u8; initial step One; step Two;
                     One -[(a ^ b) & c == 0]-> Two; Two -[(a << 2) + b > a - (b - c)]-> One; }";
        let mut sink = Sink::new();
        let chart = parse::chart(chart.parse().expect("tokens"), &mut sink).expect("a chart");
        let model = model::resolve(&chart, &mut sink);
        let facts = Facts::of(&model);
        let printed = program::naive(&model, &facts).map(|program| program.to_string());
        let printed = printed.unwrap_or_else(|_| panic!("no program"));
        for condition in ["(a ^ b) & c == 0", "(a << 2) + b > a - (b - c)"] {
            assert!(printed.contains(condition), "`{condition}`:\n{printed}");
        }
    }
}
