//! What the bits of a recorded state mean: the compiler says it where it hands the chart to the runtime.

use grafcet_compiler::held::Held;
use grafcet_compiler::model::{Id, Name, Place};
use grafcet_compiler::{Wanted, compile_with, meanings};
use grafcet_core::record::{Reader, bits_for};
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use quote::quote;

use crate::chart::Chart;
use crate::interp::{self, Recalled, Situation, is_part};
use crate::simulation::Simulation;
use crate::value::{Value, outside};

/// What the bits of a chart's recorded state mean, as far as they can be read: the fields in their order.
pub struct Layout {
    number: u32,
    fields: Vec<Field>,
    /// The first field that cannot be read, where there is one.
    unread: Option<String>,
}

struct Field {
    name: String,
    what: Option<Held>,
    width: Width,
}

enum Width {
    Bool,
    Int {
        signed: bool,
        bits: u32,
    },
    /// Of `f32` or `f64`.
    Float(u32),
    Ticks,
    /// A region, its states by name, and whether there is a mark above it.
    States(Vec<String>, bool),
    /// So many bytes, a bit for each step.
    Flags(usize),
    /// One of these variants. All fields of an enum are written by one list of it, whatever the chart lists of their names.
    Listed(Vec<String>),
    /// Or nothing.
    Optional(Box<Width>),
}

impl Layout {
    /// Of a chart that compiles; none of one that was made of a model.
    #[must_use]
    pub fn of(chart: &Chart) -> Option<Self> {
        let (root, source) = (quote!(::grafcet), chart.source()?.clone());
        let code = compile_with(&root, source.clone(), Wanted { recorded: true, prover: None });
        let parts: Vec<TokenTree> = recorded(code)?.stream().into_iter().collect();
        let number = number_of(&parts)?;
        let types = Types { enums: enums(&part(&parts, "enums")?), listed: listed(&part(&parts, "listed")?) };
        let meanings = meanings(&root, source);
        let what = |name: &str| meanings.iter().find(|(field, _)| field == name).map(|(_, what)| what.clone());
        let state: Vec<TokenTree> = part(&parts, "state")?.stream().into_iter().collect();
        let (mut fields, mut unread) = (Vec::new(), None);
        for field in state.split(|tree| matches!(tree, TokenTree::Punct(punct) if punct.as_char() == ',')) {
            let [TokenTree::Ident(name), _, ty @ ..] = field else { break };
            let name = name.to_string();
            let Some(width) = types.width(ty) else {
                // What follows cannot be told from it.
                unread = Some(name);
                break;
            };
            fields.push(Field { what: what(&name), name, width });
        }
        // After the clock's own reading stand those at which times began.
        for began in part(&parts, "clock")?.stream().into_iter().skip(1).filter(|_| unread.is_none()) {
            let name = began.to_string();
            fields.push(Field { what: what(&name), name, width: Width::Ticks });
        }
        Some(Self { number, fields, unread })
    }

    /// Tells layouts apart, as [`Recordable::LAYOUT`](grafcet_core::record::Recordable::LAYOUT) of the compiled chart does.
    #[must_use]
    pub const fn number(&self) -> u32 {
        self.number
    }

    /// What a state tells an [`Interpreter`](interp::Interpreter) that is to go on from it: the bits of [`write_state`](grafcet_core::record::Recordable::write_state)
    /// after a cycle at this reading of the clock.
    ///
    /// # Errors
    /// What cannot be read, in words.
    pub fn recalled(&self, state: &[u8], now: u32) -> Result<Recalled, String> {
        let (recalled, read) = self.read(state, now);
        read.map(|()| recalled)
    }

    /// What a state tells, as far as it can be read; and what cannot be, in words.
    pub(super) fn read(&self, state: &[u8], now: u32) -> (Recalled, Result<(), String>) {
        let mut recalled = Recalled { now, ..Recalled::default() };
        let mut bits = Reader::new(state);
        for field in &self.fields {
            if let Err(problem) = field.read(&mut bits, &mut recalled) {
                return (recalled, Err(problem));
            }
        }
        let unread = self.unread.as_ref().map(|name| format!("how the field `{name}` is written down"));
        (recalled, unread.map_or(Ok(()), Err))
    }

    /// What a state has otherwise than the simulation, in words.
    pub(super) fn difference(&self, state: &[u8], simulation: &Simulation<'_>) -> Option<String> {
        let (recalled, _) = self.read(state, 0);
        let (model, machine) = (simulation.chart().model(), simulation.machine());
        for (held, found) in &recalled.values {
            let (name, value) = match held {
                Held::Var(id) if !is_part(model, Place::Var(*id)) => (Name::Var(*id), machine.vars()[id.index()]),
                Held::Output(id) => (Name::Output(*id), machine.outputs()[id.index()]),
                _ => continue,
            };
            if value == *found || value == interp::Value::Unknown {
                continue;
            }
            // Of a variant the state has the name, the simulation the place in the list, where there is one.
            let (found, value) = (outside(*found, name, model), outside(value, name, model));
            if !matches!((&found, &value), (Value::Name(one), Value::Name(other)) if one == other) {
                let name = model.value_name(name);
                return Some(format!("`{name}` is {found} in the record, {value} in the replay"));
            }
        }
        if recalled.first || recalled.steps == *machine.situation() {
            return None;
        }
        let names = |steps: &Situation| {
            let mut names: Vec<&str> = Vec::new();
            names.extend(steps.iter().map(|step| simulation.names().steps[step.index()].name.as_str()));
            names.sort_unstable();
            names.join(", ")
        };
        let (found, here) = (names(&recalled.steps), names(machine.situation()));
        Some(format!("active are {found} in the record, {here} in the replay"))
    }
}

impl Field {
    /// Reads its bits.
    fn read(&self, bits: &mut Reader<'_>, recalled: &mut Recalled) -> Result<(), String> {
        match (&self.width, &self.what) {
            (Width::States(states, marked), Some(Held::Situation(active))) => {
                let place = bits.take(bits_for(states.len())).ok_or_else(torn)? as usize;
                bits.take(usize::from(*marked)).ok_or_else(torn)?;
                match (active.get(place), states.get(place)) {
                    (Some(steps), _) => recalled.steps.extend(steps.iter().copied()),
                    // After the steps: none of them, or that the first cycle is still to come.
                    (None, Some(state)) => recalled.first |= state == "INIT",
                    (None, None) => return Err(torn()),
                }
            }
            (Width::Flags(bytes), Some(Held::Flags { steps, has_start })) => {
                for bit in 0..bytes * 8 {
                    let is_set = bits.take(1).ok_or_else(torn)? != 0;
                    match steps.get(bit) {
                        Some(step) if is_set => _ = recalled.steps.insert(*step),
                        Some(_) => {}
                        None => recalled.first |= is_set && *has_start && bit == steps.len(),
                    }
                }
            }
            (width, what) => {
                let value = width.read(bits)?;
                match (what, value) {
                    (Some(what), Some(value)) => recalled.note(what.clone(), value),
                    (None, _) => return Err(format!("what the field `{}` holds", self.name)),
                    // Its initial value, which nothing has written over.
                    (Some(_), None) => {}
                }
            }
        }
        Ok(())
    }
}

impl Width {
    /// A value of this width; none where there is none, or one that only `next_deadline` asks for.
    fn read(&self, bits: &mut Reader<'_>) -> Result<Option<interp::Value>, String> {
        use interp::{Real, Symbol, Value};
        let mut take = |width| bits.take(width).ok_or_else(torn);
        Ok(Some(match self {
            Self::Bool => Value::Bool(take(1)? != 0),
            Self::Int { signed, bits: width } => Value::Int(int(bits, *width, *signed).ok_or_else(torn)?),
            Self::Ticks => Value::Ticks(take(32)?),
            Self::Float(32) => Value::Real(Real(f32::from_bits(take(32)?).into())),
            Self::Float(_) => {
                let (low, high) = (take(32)?, take(32)?);
                Value::Real(Real(f64::from_bits(u64::from(high) << 32 | u64::from(low))))
            }
            Self::Listed(variants) => {
                let variant = variants.get(take(bits_for(variants.len()))? as usize);
                Value::Name(Symbol::of(variant.ok_or_else(torn)?))
            }
            Self::Optional(value) => {
                let is_some = take(1)? != 0;
                return value.read(bits).map(|value| value.filter(|_| is_some));
            }
            Self::States(states, marked) => {
                take(bits_for(states.len()) + usize::from(*marked))?;
                return Ok(None);
            }
            Self::Flags(_) => return Err("a field of another kind".to_owned()),
        }))
    }
}

fn torn() -> String {
    "a state that is torn".to_owned()
}

/// What the types of the fields are made of.
struct Types {
    enums: Vec<(String, Vec<String>, bool)>,
    /// Each with its variants.
    listed: Vec<(String, Vec<String>)>,
}

impl Types {
    /// Of a type as the compiler writes it, with what says how it is recorded.
    fn width(&self, ty: &[TokenTree]) -> Option<Width> {
        let is_as = |tree: &TokenTree| matches!(tree, TokenTree::Ident(word) if word == "as");
        if let Some(at) = ty.iter().position(is_as) {
            let [TokenTree::Ident(how), optional @ ..] = &ty[at + 1..] else { return None };
            let (_, variants) = self.listed.iter().find(|(name, _)| how == name)?;
            let width = Width::Listed(variants.clone());
            return Some(if optional.is_empty() { width } else { Width::Optional(Box::new(width)) });
        }
        match ty.last()? {
            TokenTree::Group(group) if ty.len() == 1 => {
                let bytes = group.stream().into_iter().last()?.to_string();
                bytes.trim_end_matches("usize").parse().ok().map(Width::Flags)
            }
            TokenTree::Ident(name) => {
                let name = name.to_string();
                let found = self.enums.iter().find(|one| one.0 == name);
                found.map(|(_, states, marked)| Width::States(states.clone(), *marked)).or_else(|| number(&name))
            }
            _ => None,
        }
    }
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
        "Ticks" => Some(Width::Ticks),
        "f32" => Some(Width::Float(32)),
        "f64" => Some(Width::Float(64)),
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

/// What stands after `chart Motor` and the fingerprint.
fn number_of(parts: &[TokenTree]) -> Option<u32> {
    let text = parts.get(3)?.to_string();
    text.trim_end_matches("u32").parse().ok()
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

/// Each with its name and its variants, which are the last words of their paths.
fn listed(part: &Group) -> Vec<(String, Vec<String>)> {
    let (mut listed, mut name) = (Vec::new(), None);
    for tree in part.stream() {
        match tree {
            TokenTree::Ident(word) if name.is_none() => name = Some(word.to_string()),
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
                let variant = |tree| match tree {
                    TokenTree::Group(path) => path.stream().into_iter().last().map(|word| word.to_string()),
                    _ => None,
                };
                let variants = group.stream().into_iter().filter_map(variant).collect();
                listed.extend(name.take().map(|name| (name, variants)));
            }
            _ => {}
        }
    }
    listed
}
