//! What statements do, and what expressions are worth. Types are never mixed.

use super::parser::{Expression, Statement};
use super::{Call, Cell, Machine, Real, Timer, Type, Value};

/// A value for a variable of a type.
pub(super) fn fitting(ty: Type, value: Value) -> Result<Value, String> {
    match (ty, value) {
        (Type::Bool, Value::Bool(_)) | (Type::Time, Value::Time(_)) => Ok(value),
        (Type::Int(low, high), Value::Int(number)) if (low..=high).contains(&number) => Ok(value),
        (Type::Real(single), Value::Real(real)) if real.single.is_none_or(|of| of == single) => {
            Ok(Value::Real(Real::new(real.number(), Some(single))))
        }
        (Type::Int(..), Value::Int(number)) => Err(format!("{number} does not fit")),
        _ => Err(format!("{value:?} is of another type than {ty:?}")),
    }
}

/// What needs no variable.
pub(super) fn constant(expression: &Expression) -> Result<Value, String> {
    match expression {
        Expression::Literal(value) => Ok(*value),
        Expression::Minus(inner) => match constant(inner)? {
            Value::Int(number) => Ok(Value::Int(-number)),
            Value::Real(real) => Ok(Value::Real(Real::new(-real.number(), real.single))),
            other => Err(format!("-{other:?}")),
        },
        Expression::Not(inner) => match constant(inner)? {
            Value::Bool(value) => Ok(Value::Bool(!value)),
            other => Err(format!("NOT {other:?}")),
        },
        Expression::Binary(operator, a, b) => binary(operator, constant(a)?, constant(b)?),
        other => Err(format!("{other:?} is no constant")),
    }
}

fn binary(operator: &str, a: Value, b: Value) -> Result<Value, String> {
    use Value::{Bool, Int, Time};
    if let (Value::Real(a), Value::Real(b)) = (a, b) {
        return real(operator, a, b);
    }
    if let (Value::Bits(a, first), Value::Bits(b, second)) = (a, b) {
        return super::bits::binary(operator, (a, first), (b, second));
    }
    let order = match (a, b) {
        (Bool(_), Bool(_)) | (Int(_), Int(_)) | (Time(_), Time(_)) => a.cmp(&b),
        _ => return Err(format!("{a:?} {operator} {b:?}")),
    };
    let ordered = !matches!(a, Bool(_));
    Ok(match (operator, a, b) {
        ("and", Bool(a), Bool(b)) => Bool(a && b),
        ("or", Bool(a), Bool(b)) => Bool(a || b),
        ("xor", Bool(a), Bool(b)) => Bool(a != b),
        ("=", ..) => Bool(order.is_eq()),
        ("<>", ..) => Bool(order.is_ne()),
        ("<", ..) if ordered => Bool(order.is_lt()),
        ("<=", ..) if ordered => Bool(order.is_le()),
        (">", ..) if ordered => Bool(order.is_gt()),
        (">=", ..) if ordered => Bool(order.is_ge()),
        ("+", Time(a), Time(b)) => time(a.checked_add(b))?,
        ("-", Time(a), Time(b)) => time(a.checked_sub(b))?,
        ("+", Int(a), Int(b)) => Int(a + b),
        ("-", Int(a), Int(b)) => Int(a - b),
        ("*", Int(a), Int(b)) => Int(a * b),
        ("/", Int(a), Int(b)) => Int(a.checked_div(b).ok_or("division by zero")?),
        ("mod", Int(a), Int(b)) => Int(a.checked_rem(b).ok_or("division by zero")?),
        _ => return Err(format!("{a:?} {operator} {b:?}")),
    })
}

/// Nothing between leaves the type that every PLC has.
fn time(ms: Option<u64>) -> Result<Value, String> {
    ms.filter(|ms| *ms < 1 << 31).map(Value::Time).ok_or_else(|| "a time that does not fit".to_owned())
}

/// Both of one length; the result is, too.
fn real(operator: &str, a: Real, b: Real) -> Result<Value, String> {
    let single = a.single.or(b.single);
    if b.single.is_some_and(|of| Some(of) != single) {
        return Err(format!("{a:?} {operator} {b:?}"));
    }
    let [a, b] = [a, b].map(|real| Real::new(real.number(), single).number());
    let is = |holds| Ok(Value::Bool(holds));
    #[allow(clippy::float_cmp, reason = "so a PLC compares")]
    let number = match operator {
        "=" => return is(a == b),
        "<>" => return is(a != b),
        "<" => return is(a < b),
        "<=" => return is(a <= b),
        ">" => return is(a > b),
        ">=" => return is(a >= b),
        "+" => a + b,
        "-" => a - b,
        "*" => a * b,
        "/" => a / b,
        _ => return Err(format!("{a} {operator} {b}")),
    };
    Ok(Value::Real(Real::new(number, single)))
}

impl Machine {
    pub(super) fn run(&mut self, statements: &[Statement]) -> Result<(), String> {
        statements.iter().try_for_each(|statement| self.one(statement))
    }

    fn one(&mut self, statement: &Statement) -> Result<(), String> {
        match statement {
            Statement::Assign(name, value) => {
                let value = self.value(value)?;
                self.set(name, value)
            }
            Statement::If(branches, otherwise) => {
                for (condition, then) in branches {
                    if self.holds(condition)? {
                        return self.run(then);
                    }
                }
                self.run(otherwise)
            }
            Statement::Case(on, arms) => {
                let Value::Int(number) = self.value(on)? else { return Err("CASE of no number".to_owned()) };
                match arms.iter().find(|(arm, _)| *arm == number) {
                    Some((_, body)) => self.run(body),
                    None => Err(format!("CASE has no {number}")),
                }
            }
            Statement::Call(name, arguments) => self.call(name, arguments),
        }
    }

    fn call(&mut self, name: &str, arguments: &[(String, Expression)]) -> Result<(), String> {
        let mut given = Vec::new();
        for (parameter, value) in arguments {
            given.push((parameter.clone(), self.value(value)?));
        }
        match self.cells.get(name) {
            Some(Cell::Timer(timer)) => {
                let argument = |wanted: &str| given.iter().find(|(name, _)| name == wanted).map(|(_, value)| *value);
                let (Some(Value::Bool(on)), Some(Value::Time(limit))) = (argument("in"), argument("pt")) else {
                    return Err(format!("TON {name} is called by {given:?}"));
                };
                let timer = after(*timer, on, limit, self.now);
                self.cells.insert(name.to_owned(), Cell::Timer(timer));
                Ok(())
            }
            Some(Cell::Instance(block)) => {
                self.check(block, &given)?;
                let arguments = given.into_iter().map(|(_, value)| value).collect();
                self.calls.push(Call { instance: name.to_owned(), arguments });
                Ok(())
            }
            _ => Err(format!("there is nothing to call: `{name}`")),
        }
    }

    /// Every input of the unit is given, by a value of its type.
    fn check(&self, unit: &str, given: &[(String, Value)]) -> Result<(), String> {
        let inputs = self.functions[unit].variables.iter().filter(|variable| variable.is_input);
        let declared: Vec<(&String, &String)> = inputs.map(|variable| (&variable.name, &variable.ty)).collect();
        if declared.len() != given.len() {
            return Err(format!("{unit} takes {declared:?}, not {given:?}"));
        }
        for ((name, ty), (parameter, value)) in declared.into_iter().zip(given) {
            if name != parameter {
                return Err(format!("{unit} has no `{parameter}`"));
            }
            fitting(super::type_of(ty)?, *value)?;
        }
        Ok(())
    }

    fn holds(&self, expression: &Expression) -> Result<bool, String> {
        match self.value(expression)? {
            Value::Bool(value) => Ok(value),
            other => Err(format!("IF {other:?}")),
        }
    }

    fn function(function: &str, given: &[Value]) -> Result<Value, String> {
        match (function, given) {
            ("shl" | "shr", [a, b]) => super::bits::shifted(function, *a, *b),
            ("min", [Value::Time(a), Value::Time(b)]) => Ok(Value::Time(*a.min(b))),
            ("max", [Value::Time(a), Value::Time(b)]) => Ok(Value::Time(*a.max(b))),
            ("min", [Value::Int(a), Value::Int(b)]) => Ok(Value::Int(*a.min(b))),
            ("max", [Value::Int(a), Value::Int(b)]) => Ok(Value::Int(*a.max(b))),
            ("sel", [Value::Bool(second), a, b]) => Ok(if *second { *b } else { *a }),
            _ => Err(format!("{function}({given:?})")),
        }
    }

    fn value(&self, expression: &Expression) -> Result<Value, String> {
        match expression {
            Expression::Literal(value) => Ok(*value),
            Expression::Name(name) => self.get(name),
            Expression::Member(name, member) => match (self.cells.get(name), member.as_str()) {
                (Some(Cell::Timer(timer)), "q") => Ok(Value::Bool(timer.q)),
                (Some(Cell::Timer(timer)), "et") => Ok(Value::Time(timer.elapsed)),
                _ => Err(format!("there is no {name}.{member}")),
            },
            Expression::Not(inner) => match self.value(inner)? {
                Value::Bits(Some(bits), value) => Ok(super::bits::not(bits, value)),
                Value::Bool(value) => Ok(Value::Bool(!value)),
                other => Err(format!("NOT {other:?}")),
            },
            Expression::Converted(from, to, inner) => super::bits::converted(from, to, self.value(inner)?),
            Expression::Function(function, given) => {
                let given = given.iter().map(|one| self.value(one)).collect::<Result<Vec<_>, _>>()?;
                Self::function(function, &given)
            }
            Expression::Minus(inner) => match self.value(inner)? {
                Value::Int(number) => Ok(Value::Int(-number)),
                Value::Real(real) => Ok(Value::Real(Real::new(-real.number(), real.single))),
                other => Err(format!("-{other:?}")),
            },
            Expression::Binary(operator, a, b) => binary(operator, self.value(a)?, self.value(b)?),
            Expression::Milliseconds(inner) => match self.value(inner)? {
                Value::Time(ms) => fitting(super::type_of("dint")?, Value::Int(i128::from(ms))),
                other => Err(format!("TIME_TO_DINT({other:?})")),
            },
            Expression::To(ty, inner) => fitting(super::type_of(ty)?, self.value(inner)?),
            Expression::Call(name, arguments) => {
                let mut given = Vec::new();
                for (parameter, value) in arguments {
                    given.push((parameter.clone(), self.value(value)?));
                }
                let unit = self.functions.get(name).ok_or_else(|| format!("there is no function `{name}`"))?;
                let ty = unit.ty.as_ref().ok_or_else(|| format!("`{name}` is no function"))?;
                self.check(name, &given)?;
                let values: Vec<Value> = given.into_iter().map(|(_, value)| value).collect();
                fitting(super::type_of(ty)?, (self.world)(name, &values))
            }
        }
    }
}

/// The timer after a call.
fn after(timer: Timer, on: bool, limit: u64, now: u64) -> Timer {
    if !on {
        return Timer::default();
    }
    let started = timer.started.unwrap_or(now);
    let elapsed = (now - started).min(limit);
    Timer { started: Some(started), elapsed, q: elapsed >= limit }
}
