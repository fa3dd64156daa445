//! Variants of enums. Where the chart lists them a name holds the place in its own list; in expressions each has its name, by which it meets those of other
//! lists and those that no list has.

use super::real::Symbol;
use super::value::{Error, Term, Value, accept, compare};
use grafcet_compiler::model::{Binary, Model, Name};

/// The term of what a name holds, or is to hold: of a variant that the chart lists, its name and its place.
pub(super) fn term(term: Term, name: Name, model: &Model) -> Result<Term, Error> {
    let Some(variants) = model.variants_of(name) else { return Ok(term) };
    let place = match term {
        Term::Name(symbol, _) => variants.list.iter().position(|variant| variant.name == symbol.name()),
        Term::Int(place, _) => usize::try_from(place).ok(),
        _ => None,
    };
    let found = place.and_then(|place| Some((i128::try_from(place).ok()?, variants.list.get(place)?)));
    let (place, variant) = found.ok_or_else(|| Error::Type(format!("{term:?} is not in the list")))?;
    Ok(Term::Name(Symbol::of(&variant.name.to_string()), Some(place)))
}

/// The value that a name takes from a term.
pub(super) fn value(of: Term, name: Name, model: &Model) -> Result<Value, Error> {
    match term(of, name, model)? {
        Term::Name(_, Some(place)) if model.variants_of(name).is_some() => Ok(Value::Int(place)),
        other => other.into_value(model.ty(name)),
    }
}

/// The value that a name takes from one that the program around tells.
pub(super) fn told(of: Value, name: Name, model: &Model) -> Result<Value, Error> {
    match accept(of, model.ty(name))? {
        Value::Unknown => Ok(of),
        of => value(Term::of(of, model.ty(name))?, name, model),
    }
}

/// Two variants, each with its place where it has one. Rust orders them as the enum declares them, which two lists in different orders cannot both tell.
pub(super) fn compared(operator: Binary, a: (Symbol, Option<i128>), b: (Symbol, Option<i128>)) -> Option<Term> {
    match (operator, a.1, b.1) {
        (Binary::Eq | Binary::Ne, ..) => compare(operator, &a.0, &b.0),
        (_, Some(left), Some(right)) if (left == right) == (a.0 == b.0) => compare(operator, &left, &right),
        _ => None,
    }
}
