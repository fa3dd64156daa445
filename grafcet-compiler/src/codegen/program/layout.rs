//! How the places of a program are stored: which are fields, of which type, under which name.

use proc_macro2::{Ident, TokenStream};

use super::bytes;
use super::constants::{self, Constant};
use super::flags::Flags;
use crate::codegen::{Cx, force, names};
use crate::list::PushAll;
use crate::model::{StepId, Ty};
use crate::place::quote;
use crate::program::uses::{each_asked, each_read, each_written};
use crate::program::{Arm, Expr, Initial, PlaceId, PlaceInfo, Program, Role, Type, Value};
use crate::sorted::Set;

/// How each place is stored.
pub(super) struct Layout {
    pub(super) slots: Vec<Slot>,
    /// The enums of the regions.
    pub(super) regions: Vec<States>,
    /// `encoding flags;`: what is stored instead of states.
    pub(super) flags: Option<Flags>,
    /// Of a search that may have no end: what tells that is a bit above the state of the first region, if no byte is left for it.
    pub(super) mark: Option<Mark>,
    /// The highest number that a place of [`Type::Number`] holds.
    highest: u32,
}

/// Which states an enum has beside the steps of its region.
#[derive(Clone, Copy, Default)]
pub(super) struct States {
    pub(super) empty: bool,
    pub(super) start: Option<Start>,
}

#[derive(Clone, Copy)]
pub(super) struct Mark {
    /// The state is a register wide as long as the search goes on, as no table has it.
    pub(super) is_wide: bool,
}

/// The first cycle is still to come; seen from outside this step is active.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct Start(pub(super) Option<StepId>);

pub(super) struct Slot {
    pub(super) name: Ident,
    pub(super) kind: Kind,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// Nothing reads or writes it, from within or from outside.
    Unused,
    Local,
    /// A local that whoever forces the chart has set.
    Asked,
    /// In the outputs that the cycle returns.
    Result,
    Field,
    /// A field whose initial value is no constant: `None` stands for it.
    Late,
    /// In the recipe.
    Param,
    /// A local like any other in a cycle: the state of a region, which is stored as bits.
    Unpacked,
    /// A bit of the situation, which is not set where the place is true.
    Unset(usize),
    /// A field with the mark above it.
    Marked,
    /// That mark, which is not there where the place is true.
    Mark,
}

impl Layout {
    pub(super) fn of(cx: &Cx<'_>, program: &Program<'_>) -> Self {
        let mut used = Used::of(program);
        let mut taken: [Set<String>; 2] = [Set::new(), Set::new()];
        taken[0].extend(["params", "situation"].map(str::to_owned));
        let mut slots = Vec::new();
        let (regions, has_mark) = (program.regions.len(), program.place(Role::Stable).is_some());
        // Regions that share a place have a byte left for it, and would all have to look past the mark.
        let is_marked = has_mark && regions > 0 && !cx.model.flags && program.united.is_empty();
        for (index, place) in program.places.iter().enumerate() {
            let kind = match place.role {
                Role::State(0) if is_marked => Kind::Marked,
                Role::Stable if is_marked => Kind::Mark,
                Role::State(_) if cx.model.flags => {
                    let asked = cx.plan.one_step || used.places.contains(&PlaceId(index));
                    if asked { Kind::Unpacked } else { Kind::Unused }
                }
                // It follows from the situation.
                Role::Var(id) if !cx.plan.vars.contains(&id) && !used.places.contains(&PlaceId(index)) => Kind::Unused,
                _ => kind(place, used.places.contains(&PlaceId(index))),
            };
            let name = match place.role {
                Role::Param(id) => cx.model.params[id].name.clone(),
                Role::Output(id) if kind == Kind::Result => cx.model.outputs[id].name.clone(),
                Role::State(region) if cx.model.flags => names::region_local(region, cx.plan),
                Role::State(region) => names::region_field(region, cx.plan),
                Role::Asked(region) => force::asked(region),
                _ if kind == Kind::Local => names::local(&free(&place.name, &mut taken[1])),
                _ => names::own(&free(&place.name, &mut taken[0])),
            };
            if let (Initial::Value(value), false) = (place.initial, kind == Kind::Unused) {
                used.state(place.ty, value);
            }
            slots.push(Slot { name, kind });
        }
        let flags = cx.model.flags.then(|| Flags {
            steps: cx.model.steps.len(),
            start: used.regions.iter().any(|states| states.start.is_some()),
            unstable: has_mark,
        });
        for (place, slot) in program.places.iter().zip(&mut slots) {
            if let (Role::Stable, Some(flags)) = (place.role, flags) {
                slot.kind = Kind::Unset(flags.unstable_bit());
            }
        }
        let sizes = (&used.regions[..], number_size(used.highest));
        let is_marked = is_marked && !bytes::is_one_left(cx, program, &slots, sizes);
        if !is_marked {
            for slot in &mut slots {
                if matches!(slot.kind, Kind::Marked | Kind::Mark) {
                    slot.kind = Kind::Field;
                }
            }
        }
        let mark = is_marked.then_some(Mark { is_wide: regions == 1 && !used.has_tables });
        Self { slots, regions: used.regions, flags, mark, highest: used.highest }
    }

    /// Whether a match has an arm for each value.
    pub(super) fn is_complete(&self, program: &Program<'_>, ty: Type<'_>, arms: &[Arm<'_>]) -> bool {
        let mut seen = Set::new();
        for (values, _) in arms {
            seen.extend(values.iter().copied());
        }
        let has = |value: Value| seen.contains(&value);
        match ty {
            Type::Bool => has(Value::Bool(true)) && has(Value::Bool(false)),
            Type::State(region) => {
                let states = self.regions[region];
                let none = !states.empty || has(Value::Step(None));
                let all = program.states(region).iter().all(|state| has(Value::Step(Some(*state))));
                all && none && states.start.is_none_or(|Start(seen)| has(Value::Start(seen)))
            }
            Type::Kind { count, .. } => (0..count).all(|kind| has(Value::Int(kind))),
            Type::Ticks | Type::Number | Type::User(_) => false,
        }
    }

    /// All values of a state, in the order in which the enum of its region has them.
    pub(super) fn states(&self, program: &Program<'_>, ty: Type<'_>) -> Vec<Value> {
        let Type::State(region) = ty else { return Vec::new() };
        let mut all = Vec::new();
        for state in program.states(region) {
            all.push(Value::Step(Some(state)));
        }
        let states = self.regions[region];
        all.push_all(states.empty.then_some(Value::Step(None)));
        all.push_all(states.start.map(|Start(seen)| Value::Start(seen)));
        all
    }

    /// Whether a place is that of the mark above the first region's state.
    pub(super) fn is_mark(&self, place: PlaceId) -> bool {
        self.slot(place).kind == Kind::Mark
    }

    pub(super) fn slot(&self, place: PlaceId) -> &Slot {
        &self.slots[place.0]
    }

    /// Whether a place is declared where the program mentions it.
    pub(super) fn is_local(&self, place: PlaceId) -> bool {
        self.slot(place).kind == Kind::Local
    }

    /// Whether it is one of the outputs that the cycle returns.
    pub(super) fn is_result(&self, place: PlaceId) -> bool {
        self.slot(place).kind == Kind::Result
    }

    /// Whether a place is a field of its own in the chart's struct.
    pub(super) fn is_field(&self, place: PlaceId) -> bool {
        matches!(self.slot(place).kind, Kind::Field | Kind::Late | Kind::Marked)
    }

    /// Whether an output outlives the cycle.
    pub(super) fn is_kept(&self, place: PlaceId) -> bool {
        matches!(self.slot(place).kind, Kind::Field | Kind::Late)
    }

    pub(super) fn name(&self, place: PlaceId) -> &Ident {
        &self.slot(place).name
    }

    /// In bytes.
    pub(super) fn number_size(&self) -> u8 {
        number_size(self.highest)
    }

    pub(super) fn number(&self, p: &TokenStream) -> TokenStream {
        match self.number_size() {
            1 => quote!(#p::u8),
            2 => quote!(#p::u16),
            _ => quote!(#p::u32),
        }
    }
}

fn number_size(highest: u32) -> u8 {
    match highest {
        0..=0xff => 1,
        0x100..=0xffff => 2,
        _ => 4,
    }
}

fn kind(place: &PlaceInfo<'_>, used: bool) -> Kind {
    // What others than the cycle look at.
    let shown = matches!(place.role, Role::State(_) | Role::Stable | Role::Var(_) | Role::Recorded);
    match place.role {
        Role::Param(_) => Kind::Param,
        _ if !used && !shown => Kind::Unused,
        Role::Asked(_) => Kind::Asked,
        Role::Output(_) if !place.is_field => Kind::Result,
        _ if !place.is_field => Kind::Local,
        _ if is_constant(place) => Kind::Field,
        _ => Kind::Late,
    }
}

/// Whether `new` can write what a place begins with.
fn is_constant(place: &PlaceInfo<'_>) -> bool {
    match (place.initial, place.ty) {
        (Initial::Default, Type::User(ty @ Ty::Other(_))) => ty.is_float(),
        _ => true,
    }
}

/// The name of a place as an identifier that no other place has.
fn free(name: &str, taken: &mut Set<String>) -> String {
    let mut own = String::new();
    for c in name.to_lowercase().chars() {
        let c = if c.is_alphanumeric() { c } else { '_' };
        // Two of them beside each other are no snake case.
        if c != '_' || !own.ends_with('_') {
            own.push(c);
        }
    }
    let own = own.trim_end_matches('_');
    // A number at the end is that of a placeholder, and some words are Rust's.
    let reserved = own.ends_with(|c: char| c.is_ascii_digit()) || syn::parse_str::<Ident>(own).is_err();
    let own = format!("{own}{}", if reserved { "_" } else { "" });
    let (mut free, mut number) = (own.clone(), 2);
    while !taken.insert(free.clone()) {
        free = format!("{own}_{number}_");
        number += 1;
    }
    free
}

/// What a program mentions.
#[derive(Default)]
struct Used {
    places: Set<PlaceId>,
    regions: Vec<States>,
    highest: u32,
    /// Something looks up a state in a table.
    has_tables: bool,
}

impl Used {
    fn of(program: &Program<'_>) -> Self {
        let mut used = Self { regions: vec![States::default(); program.regions.len()], ..Self::default() };
        for cycle in program.cycles() {
            each_asked(cycle, &mut |place| _ = used.places.insert(place));
            each_written(cycle, &mut |place| _ = used.places.insert(place));
            constants::each_in(cycle, &mut |constant| used.constant(program, constant));
        }
        if let Some(deadline) = &program.deadline {
            used.places.extend(deadline.waits.iter().map(|wait| wait.from));
            for expr in deadline.asks() {
                used.expr(program, expr);
            }
            for (_, over) in &deadline.late {
                used.expr(program, over);
            }
        }
        used
    }

    fn expr(&mut self, program: &Program<'_>, expr: &Expr<'_>) {
        each_read(expr, &mut |place| _ = self.places.insert(place));
        constants::each_of(expr, &mut |constant| self.constant(program, constant));
    }

    fn constant(&mut self, program: &Program<'_>, constant: Constant) {
        match constant {
            Constant::Elsewhere(Value::Int(number))
            | Constant::Set(_, Value::Int(number))
            | Constant::Arm(_, Value::Int(number)) => {
                self.highest = self.highest.max(u32::try_from(number).unwrap_or(u32::MAX));
            }
            Constant::Set(place, value) | Constant::Arm(place, value) => self.state(program.places[place.0].ty, value),
            Constant::Entry(value) => self.has_tables |= matches!(value, Value::Step(_)),
            Constant::Elsewhere(_) => {}
        }
    }

    /// A place of a type has a value.
    fn state(&mut self, ty: Type<'_>, value: Value) {
        if let Type::State(region) = ty {
            match value {
                Value::Step(None) => self.regions[region].empty = true,
                Value::Start(seen) => self.regions[region].start = Some(Start(seen)),
                _ => {}
            }
        }
    }
}
