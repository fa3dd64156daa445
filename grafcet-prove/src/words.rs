//! Proofs in the words of the chart: what a cube excludes, place by place.

use grafcet_compiler::model::{Name, StepId};
use grafcet_compiler::program::{Program, Role, Type};

use crate::circuit::{Circuit, Field};
use crate::lemmas::{About, Relation};
use crate::task::{Invariant, entry};
use crate::ways::Leads;

/// A field of more bits is not gone through value by value.
const FEW_BITS: usize = 12;

/// One line for each cube: what never holds together.
#[must_use]
pub fn lines(program: &Program<'_>, circuit: &Circuit, invariant: &Invariant) -> Vec<String> {
    let mut lines = Vec::new();
    match invariant.depth {
        0 => {}
        1 => lines.push(
            "it follows from itself: after a cycle at whose end it holds comes one at whose end it holds".to_owned(),
        ),
        depth => lines.push(format!(
            "it follows from itself: after {depth} cycles at whose ends it holds comes one at whose end it holds"
        )),
    }
    for cube in &invariant.excluded {
        let mut parts = Vec::new();
        for field in &circuit.fields {
            let mut bits = vec![None; field.width];
            for code in cube {
                let (latch, value) = entry(*code);
                if (field.first..field.first + field.width).contains(&latch) {
                    bits[latch - field.first] = Some(value);
                }
            }
            if bits.iter().any(Option::is_some) {
                parts.push(part(program, field, &bits));
            }
        }
        lines.push(format!("never {}", parts.join(" and ")));
    }
    lines
}

/// One line for each target on the way home: how far it is from where a chart can be.
#[must_use]
pub fn ways(all: &[Leads]) -> Vec<String> {
    let line = |(index, ways): (usize, &Leads)| {
        let (cycles, sets) = (ways.longest(), ways.leads.len());
        let which =
            if all.len() == 1 { String::new() } else { format!(" to place {} of {} on the way", index + 1, all.len()) };
        format!("from {sets} sets of states inputs lead home{which}, in {cycles} cycles at most")
    };
    all.iter().enumerate().map(line).collect()
}

/// One line for each step of which a proof knows how its clock goes with that of the property.
#[must_use]
pub fn clocks(program: &Program<'_>, known: &[About]) -> Vec<String> {
    let mut lines: Vec<(usize, Option<StepId>, Vec<String>)> = Vec::new();
    for about in known {
        let says = |relation: Relation| known.contains(&About { relation, ..*about });
        // It never comes to that.
        if says(Relation::Inactive) && says(Relation::Active) && says(Relation::Later) {
            continue;
        }
        let Some(said) = of_clock(program, *about, known) else { continue };
        match lines.iter_mut().find(|(region, step, _)| (*region, *step) == (about.region, about.step)) {
            Some((_, _, all)) => all.push(said),
            None => lines.push((about.region, about.step, vec![said])),
        }
    }
    let line = |(region, step, all): (usize, Option<StepId>, Vec<String>)| {
        let name = |step: &StepId| program.model.steps[*step].name.to_string();
        let place = match step {
            Some(step) => format!("in {}", name(&step)),
            None => {
                format!("in none of {{{}}}", program.regions[region].iter().map(name).collect::<Vec<_>>().join(", "))
            }
        };
        format!("{place}: {}", all.join(", "))
    };
    lines.into_iter().map(line).collect()
}

/// What one of them says; none of what another one says, too. What comes at most so much later is the time waited.
fn of_clock(program: &Program<'_>, about: About, known: &[About]) -> Option<String> {
    let clock = match about.step {
        Some(step) if about.has_clock => format!("{}.T", program.model.steps[step].name),
        _ => "the time waited".to_owned(),
    };
    let others = || known.iter().filter(|other| (other.region, other.step) == (about.region, about.step));
    let never_waits = others().any(|other| other.relation == Relation::Inactive);
    Some(match about.relation {
        Relation::Inactive => "nothing is waited for".to_owned(),
        Relation::Active => "something is waited for".to_owned(),
        Relation::Later => "not before the first cycle".to_owned(),
        Relation::Below(limit) => {
            let less = |other: &About| matches!(other.relation, Relation::Below(lower) if lower < limit);
            if others().any(less) {
                return None;
            }
            format!("{clock} < {limit} ticks")
        }
        Relation::Behind(offset) => {
            let less = |other: &About| matches!(other.relation, Relation::Behind(lower) if lower < offset);
            if !about.has_clock || about.step.is_none() || never_waits || others().any(less) {
                return None;
            }
            let more = if offset == 0 { String::new() } else { format!(" + {offset} ticks") };
            format!("the time waited <= {clock}{more}")
        }
        Relation::Ahead if !about.has_clock || about.step.is_none() || never_waits => return None,
        Relation::Ahead => format!("the time waited >= {clock}"),
    })
}

fn part(program: &Program<'_>, field: &Field, bits: &[Option<bool>]) -> String {
    let program = field.program(program);
    let ty = field.place.map(|place| program.places[place.0].ty);
    let variants = field.place.and_then(|place| match program.places[place.0].role {
        Role::Var(id) => program.model.variants_of(Name::Var(id)),
        _ => None,
    });
    if field.width == 1 && variants.is_none() && !matches!(ty, Some(Type::State(_))) {
        let not = if bits[0] == Some(true) { "" } else { "not " };
        return format!("{not}{}", field.name);
    }
    if field.width > FEW_BITS {
        return of_bits(field, bits);
    }
    let mut values: Vec<i128> = Vec::new();
    for number in 0..1_u32 << field.width {
        if bits.iter().enumerate().all(|(index, bit)| bit.is_none_or(|bit| bit == (number >> index & 1 == 1))) {
            let wraps = field.signed && number >> (field.width - 1) & 1 == 1;
            values.push(i128::from(number) - if wraps { 1_i128 << field.width } else { 0 });
        }
    }
    values.sort_unstable();
    if let Some(Type::State(region)) = ty {
        let steps = &program.regions[region];
        let mut names = Vec::new();
        for value in values {
            match usize::try_from(value - 1).ok() {
                None => names.push("none".to_owned()),
                Some(index) => names.extend(steps.get(index).map(|step| program.model.steps[*step].name.to_string())),
            }
        }
        return format!("{} in {{{}}}", field.name, names.join(", "));
    }
    if let Some(variants) = variants {
        let names: Vec<String> =
            values.iter().map(|place| variants.text(*place, *place)).filter(|name| !name.is_empty()).collect();
        return format!("{} in {{{}}}", field.name, names.join(", "));
    }
    let ranges = ranges(&values);
    if ranges.len() > 4 { of_bits(field, bits) } else { format!("{} in {{{}}}", field.name, ranges.join(", ")) }
}

fn ranges(values: &[i128]) -> Vec<String> {
    let (mut all, mut rest) = (Vec::new(), values);
    while let Some(first) = rest.first() {
        let count = (0..).zip(rest).take_while(|(index, value)| **value == first + index).count();
        let last = rest[count - 1];
        all.push(if count == 1 { first.to_string() } else { format!("{first}..={last}") });
        rest = &rest[count..];
    }
    all
}

fn of_bits(field: &Field, bits: &[Option<bool>]) -> String {
    let bits = bits.iter().rev().map(|bit| match bit {
        None => '-',
        Some(true) => '1',
        Some(false) => '0',
    });
    format!("{} = 0b{}", field.name, bits.collect::<String>())
}
