//! Structured text that runs: a reader by its own grammar and an interpreter, for the part of the language that exported programs are made of.
//! Nothing is shared with the exporter.
#![allow(dead_code, reason = "each test needs a part of it")]

mod bits;
mod eval;
mod lexer;
mod parser;

use std::collections::BTreeMap;

#[allow(unused_imports, reason = "each test needs a part of it")]
pub(crate) use parser::statements;
pub(crate) use parser::{Expression, Statement, Unit, units};

/// Whose language it is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Dialect {
    Iec,
    Codesys,
    Tia,
}

/// A value, times in milliseconds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum Value {
    Bool(bool),
    Int(i128),
    Time(u64),
    Real(Real),
    /// A string of so many bits; a literal is of any length.
    Bits(Option<u32>, u64),
}

/// A float: its bits as those of 64, and whether it is one of 32. A literal is either.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct Real {
    bits: u64,
    single: Option<bool>,
}

impl Real {
    pub(crate) fn new(number: f64, single: Option<bool>) -> Self {
        #[allow(clippy::cast_possible_truncation, reason = "that is what a REAL is")]
        let number = if single == Some(true) { f64::from(number as f32) } else { number };
        Self { bits: number.to_bits(), single }
    }

    pub(crate) fn number(self) -> f64 {
        f64::from_bits(self.bits)
    }
}

impl Value {
    /// As charts are compared: `true` is 1, and a float its bits.
    pub(crate) fn number(self) -> i128 {
        match self {
            Self::Bool(value) => i128::from(value),
            Self::Int(value) => value,
            Self::Time(ms) => i128::from(ms),
            Self::Real(real) => i128::from(real.bits),
            Self::Bits(_, bits) => i128::from(bits),
        }
    }
}

/// What is stored under a name.
#[derive(Clone, PartialEq, Eq, Debug)]
enum Cell {
    Value(Type, Value),
    Timer(Timer),
    /// An instance of a function block that somebody has to write.
    Instance(String),
}

/// A type that has values.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Type {
    Bool,
    Time,
    /// The lowest and the highest value.
    Int(i128, i128),
    /// Whether of 32 bits.
    Real(bool),
}

/// TON: on delay.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
struct Timer {
    started: Option<u64>,
    elapsed: u64,
    q: bool,
}

/// A call of a function block that is to be written.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Call {
    /// Of the instance, in small letters.
    pub(crate) instance: String,
    pub(crate) arguments: Vec<Value>,
}

/// The last function block of a text, as a machine.
pub(crate) struct Machine {
    cells: BTreeMap<String, Cell>,
    body: Vec<Statement>,
    functions: BTreeMap<String, Unit>,
    /// In milliseconds since anything.
    pub(crate) now: u64,
    /// Of the last scan.
    pub(crate) calls: Vec<Call>,
    /// What functions that are to be written return.
    pub(crate) world: fn(&str, &[Value]) -> Value,
}

impl Machine {
    /// With all variables at their initial values.
    pub(crate) fn new(text: &str) -> Result<Self, String> {
        Self::of(text, Dialect::Iec)
    }

    /// The same in another dialect.
    pub(crate) fn of(text: &str, dialect: Dialect) -> Result<Self, String> {
        let mut units = units(text, dialect)?;
        let program = units.pop().ok_or("there is no function block")?;
        let functions: BTreeMap<String, Unit> = units.into_iter().map(|unit| (unit.name.clone(), unit)).collect();
        let mut machine = Self {
            cells: BTreeMap::new(),
            body: program.body,
            functions,
            now: 0,
            calls: Vec::new(),
            world: |_, _| Value::Bool(false),
        };
        for variable in program.variables {
            let cell = machine.cell(&variable.ty, variable.init.as_ref())?;
            if machine.cells.insert(variable.name.clone(), cell).is_some()
                || machine.functions.contains_key(&variable.name)
            {
                return Err(format!("`{}` is declared twice", variable.name));
            }
        }
        Ok(machine)
    }

    fn cell(&self, ty: &str, init: Option<&Expression>) -> Result<Cell, String> {
        if ty == "ton" {
            return Ok(Cell::Timer(Timer::default()));
        }
        if self.functions.contains_key(ty) {
            return Ok(Cell::Instance(ty.to_owned()));
        }
        let ty = type_of(ty)?;
        let nothing = match ty {
            Type::Bool => Value::Bool(false),
            Type::Time => Value::Time(0),
            Type::Int(..) => Value::Int(0),
            Type::Real(single) => Value::Real(Real::new(0.0, Some(single))),
        };
        let value = init.map_or(Ok(nothing), eval::constant)?;
        Ok(Cell::Value(ty, eval::fitting(ty, value)?))
    }

    /// One scan.
    pub(crate) fn scan(&mut self) -> Result<(), String> {
        self.calls.clear();
        let body = std::mem::take(&mut self.body);
        let done = self.run(&body);
        self.body = body;
        done
    }

    pub(crate) fn set(&mut self, name: &str, value: Value) -> Result<(), String> {
        match self.cells.get_mut(&name.to_lowercase()) {
            Some(Cell::Value(ty, at)) => {
                *at = eval::fitting(*ty, value).map_err(|error| format!("{name}: {error}"))?;
                Ok(())
            }
            _ => Err(format!("there is no variable `{name}`")),
        }
    }

    pub(crate) fn get(&self, name: &str) -> Result<Value, String> {
        match self.cells.get(&name.to_lowercase()) {
            Some(Cell::Value(_, value)) => Ok(*value),
            _ => Err(format!("there is no variable `{name}`")),
        }
    }

    /// Everything it remembers, to be compared.
    pub(crate) fn memory(&self) -> String {
        format!("{:?}", self.cells)
    }
}

fn type_of(name: &str) -> Result<Type, String> {
    let int = |signed: bool, bits: u32| {
        let (low, bits) = if signed { (-(1 << (bits - 1)), bits - 1) } else { (0, bits) };
        Type::Int(low, (1 << bits) - 1)
    };
    Ok(match name {
        "bool" => Type::Bool,
        "time" => Type::Time,
        "sint" => int(true, 8),
        "usint" => int(false, 8),
        "int" => int(true, 16),
        "uint" => int(false, 16),
        "dint" => int(true, 32),
        "udint" => int(false, 32),
        "lint" => int(true, 64),
        "ulint" => int(false, 64),
        "real" => Type::Real(true),
        "lreal" => Type::Real(false),
        _ => return Err(format!("there is no type `{name}`")),
    })
}
