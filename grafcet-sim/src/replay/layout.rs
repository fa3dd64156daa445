//! What the bits of a recorded state mean: the compiler says it where it hands the chart to the runtime.

use grafcet_compiler::model::{Effect, Model, Place, Qualifier};
use grafcet_compiler::{Wanted, compile_with};
use grafcet_core::record::{Reader, bits_for};
use proc_macro2::{Group, Ident, TokenStream, TokenTree};
use quote::quote;

use crate::chart::Chart;
use crate::simulation::Simulation;
use crate::value::Value;

/// The fields of a state as far as they can be read, in their order.
pub(super) struct Layout {
    fields: Vec<(String, Width)>,
}

enum Width {
    Bool,
    Int {
        signed: bool,
        bits: u32,
    },
    /// A region, its states by name, and whether there is a mark above it.
    States(Vec<String>, bool),
}

impl Layout {
    /// Of a chart that compiles.
    pub(super) fn of(chart: &Chart) -> Option<Self> {
        let code = compile_with(&quote!(::grafcet), chart.source()?.clone(), Wanted { recorded: true, prover: None });
        let parts: Vec<TokenTree> = recorded(code)?.stream().into_iter().collect();
        let enums = enums(&part(&parts, "enums")?);
        let state: Vec<TokenTree> = part(&parts, "state")?.stream().into_iter().collect();
        let mut fields = Vec::new();
        for field in state.split(|tree| matches!(tree, TokenTree::Punct(punct) if punct.as_char() == ',')) {
            let (Some(TokenTree::Ident(name)), Some(TokenTree::Ident(ty))) = (field.first(), field.last()) else {
                break;
            };
            let ty = ty.to_string();
            let width = match enums.iter().find(|one| one.0 == ty) {
                Some((_, states, marked)) => Width::States(states.clone(), *marked),
                None => match number(&ty) {
                    Some(width) => width,
                    // What follows cannot be told from it.
                    None => break,
                },
            };
            let name = name.to_string();
            // What follows has to be read at its place all the same.
            let name = if is_part(chart.model(), &name) { String::new() } else { name };
            fields.push((name, width));
        }
        Some(Self { fields })
    }

    /// What a state has otherwise than the simulation, in words.
    pub(super) fn difference(&self, state: &[u8], simulation: &Simulation<'_>) -> Option<String> {
        let mut bits = Reader::new(state);
        let mut recorded: Vec<String> = Vec::new();
        let mut is_known = true;
        for (name, width) in &self.fields {
            let (found, expected) = match width {
                Width::States(states, marked) => {
                    let Some(place) = bits.take(bits_for(states.len())) else {
                        return Some("its state is torn".to_owned());
                    };
                    if *marked {
                        bits.take(1);
                    }
                    // Only the regions of the situation; what else has their type remembers one of before.
                    if name == "situation" || name.starts_with("region_") {
                        match states.get(place as usize).map(String::as_str) {
                            Some("NONE") => {}
                            Some(step) if simulation.names().step_named(step).is_some() => {
                                recorded.push(step.to_owned());
                            }
                            _ => is_known = false,
                        }
                    }
                    continue;
                }
                Width::Bool => (bits.take(1).map(|bit| Value::Bool(bit != 0)), held(name, simulation)),
                Width::Int { signed, bits: width } => {
                    (int(&mut bits, *width, *signed).map(Value::Int), held(name, simulation))
                }
            };
            if let (Some(found), Some((name, expected))) = (found, expected) {
                if found != expected && !matches!(expected, Value::Ticks(_) | Value::Name(_)) {
                    return Some(format!("`{name}` is {found} in the record, {expected} in the replay"));
                }
            }
        }
        let mut here: Vec<String> =
            simulation.steps().into_iter().map(|step| simulation.names().steps[step].name.clone()).collect();
        recorded.sort_unstable();
        here.sort_unstable();
        let has_regions = self.fields.iter().any(|(_, width)| matches!(width, Width::States(..)));
        (has_regions && is_known && recorded != here)
            .then(|| format!("active are {} in the record, {} in the replay", recorded.join(", "), here.join(", ")))
    }
}

/// Whether a field holds but a part of an output or variable: what `S` has set, beside what acts as long as a step is active.
fn is_part(model: &Model, field: &str) -> bool {
    let plain = |name: &Ident| name.to_string().trim_start_matches("r#").to_owned();
    let of = |place: &Place| match place {
        Place::Output(id) => format!("out_{}", plain(&model.outputs[*id].name)),
        Place::Var(id) => format!("var_{}", plain(&model.vars[*id].name)),
    };
    model.associations.values().any(|one| match &one.effect {
        Effect::Control(place) => !matches!(one.qualifier, Qualifier::S | Qualifier::R) && of(place) == field,
        _ => false,
    })
}

/// The output or variable that a field holds, and its value.
fn held(field: &str, simulation: &Simulation<'_>) -> Option<(String, Value)> {
    let output = field.strip_prefix("out_").and_then(|name| Some((name.to_owned(), simulation.output(name)?)));
    output.or_else(|| {
        let name = field.strip_prefix("var_")?;
        Some((name.to_owned(), simulation.variable(name)?))
    })
}

/// A number as it is in memory, the lowest byte first.
pub(super) fn int(bits: &mut Reader<'_>, width: u32, signed: bool) -> Option<i128> {
    let mut value = 0_u128;
    for byte in 0..width / 8 {
        value |= u128::from(bits.take(8)?) << (8 * byte);
    }
    let unused = 128 - width;
    Some(if signed {
        i128::from_ne_bytes((value << unused).to_ne_bytes()) >> unused
    } else {
        i128::try_from(value).ok()?
    })
}

fn number(ty: &str) -> Option<Width> {
    let bits = |signed, digits: &str| digits.parse().ok().map(|bits| Width::Int { signed, bits });
    match ty {
        "bool" => Some(Width::Bool),
        "Ticks" => Some(Width::Int { signed: false, bits: 32 }),
        "ShortTime" => Some(Width::Int { signed: false, bits: 16 }),
        "usize" => Some(Width::Int { signed: false, bits: 64 }),
        "isize" => Some(Width::Int { signed: true, bits: 64 }),
        _ => ty.strip_prefix('u').and_then(|digits| bits(false, digits)).or_else(|| bits(true, ty.strip_prefix('i')?)),
    }
}

/// What stands between the braces of `recorded! { … }`.
fn recorded(code: TokenStream) -> Option<Group> {
    let trees: Vec<TokenTree> = code.into_iter().collect();
    for (index, tree) in trees.iter().enumerate() {
        let TokenTree::Group(group) = tree else { continue };
        let called = index >= 2 && matches!(&trees[index - 2], TokenTree::Ident(ident) if ident == "recorded");
        if called {
            return Some(group.clone());
        }
        if let Some(found) = recorded(group.stream()) {
            return Some(found);
        }
    }
    None
}

fn part(parts: &[TokenTree], name: &str) -> Option<Group> {
    let at = parts.iter().position(|tree| matches!(tree, TokenTree::Ident(ident) if ident == name))?;
    parts[at..].iter().find_map(|tree| if let TokenTree::Group(group) = tree { Some(group.clone()) } else { None })
}

/// Each with its name, its states, and whether it is another one with a mark above it.
fn enums(part: &Group) -> Vec<(String, Vec<String>, bool)> {
    let mut enums: Vec<(String, Vec<String>, bool)> = Vec::new();
    let mut words: Vec<String> = Vec::new();
    for tree in part.stream() {
        match tree {
            TokenTree::Ident(word) => words.push(word.to_string()),
            TokenTree::Group(group) => {
                let states: Vec<String> = group.stream().into_iter().map(|state| state.to_string()).collect();
                match &std::mem::take(&mut words)[..] {
                    [name] => enums.push((name.clone(), states, false)),
                    [marked, of] => {
                        let states = enums.iter().find(|one| one.0 == *of).map(|one| one.1.clone()).unwrap_or_default();
                        enums.push((marked.clone(), states, true));
                    }
                    _ => {}
                }
            }
            _ => {}
        }
    }
    enums
}
