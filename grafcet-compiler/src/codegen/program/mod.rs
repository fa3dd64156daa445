//! A program printed as Rust. It knows Rust and nothing of charts: what happens when, the program says.
//!
//! - `layout`: how each place is stored
//! - `flags`: a situation that is stored as bits
//! - `scope`: where each local is declared
//! - `statement`, `expr`: what their names say
//! - `user`: Rust of the user, after bindings of what it reads
//! - `constants`: those in statements and expressions

mod bytes;
mod constants;
mod expr;
mod flags;
mod layout;
mod outputs;
mod places;
mod scope;
mod statement;
mod user;

use proc_macro2::TokenStream;

pub(super) use self::flags::{Flags, bit};
use self::layout::{Kind, Layout, Mark, Start};
use self::scope::Scope;
use super::machine::{Deadline, Machine};
use super::state::StateEnum;
use super::{Cx, meaning, names, state};
use crate::held::Held;
use crate::list::List;
use crate::model::StepId;
use crate::place::quote;
use crate::program::{self, PlaceId, Program, Role, Statement, Wait};

/// What the fields of a program's state hold, by their names.
pub(super) fn meanings(cx: &Cx<'_>, program: &Program<'_>) -> Vec<(String, Held)> {
    let layout = Layout::of(cx, program);
    let mut held = Vec::new();
    if let Some(flags) = layout.flags {
        let steps = cx.model.steps.ids().list();
        held.push((flags::field().to_string(), Held::Flags { steps, has_start: flags.start }));
    }
    for (index, place) in program.places.iter().enumerate() {
        if let (true, Some(what)) = (layout.is_field(PlaceId(index)), meaning::of_role(program, place.role)) {
            held.push((layout.name(PlaceId(index)).to_string(), what));
        }
    }
    held
}

/// What is printed, and what is known about it meanwhile.
struct Printer<'p, 'm> {
    cx: &'p Cx<'m>,
    program: &'p Program<'m>,
    layout: &'p Layout,
    /// What is printed is a cycle.
    within: bool,
}

/// The state and the cycle of a chart as its program says.
pub(super) fn machine<'m>(cx: &Cx<'m>, program: &Program<'m>) -> Machine<'m> {
    let layout = Layout::of(cx, program);
    let cycle = &program.cycle;
    let printer = Printer { cx, program, layout: &layout, within: false };
    let cycles = Printer { cx, program, layout: &layout, within: true };
    Machine {
        types: printer.types(),
        regions: printer.regions(),
        flags: layout.flags,
        clock: program.place(Role::Recorded).map(|reading| printer.layout.name(reading).clone()),
        began: printer.began(),
        fields: printer.fields(),
        stored: printer.stored(),
        cycle: cycles.cycle(cycle),
        forced: program.forced.as_deref().map(|forced| cycles.cycle(forced)),
        active: cx.model.steps.ids().map(|step| printer.is_active(step)).list(),
        homes: cx.model.steps.ids().map(|step| program.home(step)).list(),
        situation: printer.situation(),
        stable: program.place(Role::Stable).map_or_else(|| quote!(true), |stable| printer.get(stable)),
        deadline: program.deadline.as_ref().map(|deadline| printer.deadline(deadline)),
        late: printer.late(),
        vars: printer.vars(),
    }
}

impl<'m> Printer<'_, 'm> {
    fn cycle(&self, cycle: &[Statement<'m>]) -> TokenStream {
        let scope = Scope::of(self.program, self.layout, cycle);
        let body = self.block(cycle, &scope);
        let (unpack, pack) = self.layout.flags.map(|flags| self.around(flags, cycle)).unwrap_or_default();
        let first = self.first_outputs();
        let mut last = TokenStream::new();
        for (id, output) in self.cx.model.outputs.iter() {
            let Some(place) = self.program.place(Role::Output(id)).filter(|place| self.layout.is_kept(*place)) else {
                continue;
            };
            let (name, value) = (&output.name, self.get(place));
            last.extend(quote!(outputs_.#name = #value;));
        }
        quote!(#first #unpack #body #pack #last outputs_)
    }

    fn deadline(&self, deadline: &program::Deadline<'m>) -> Deadline {
        let p = &self.cx.p;
        let mut waits = TokenStream::new();
        let is_one = deadline.has_one_clock();
        for Wait { condition, from, time } in &deadline.waits {
            let (condition, from, time) = (self.condition(condition), self.get(*from), self.value(time));
            waits.extend(if is_one {
                quote!(if #condition { soonest_ = #p::sooner(soonest_, #p::Option::Some(#time)); })
            } else {
                quote!(if #condition { soonest_ = #p::earlier(soonest_, #from.after(#time)); })
            });
        }
        let reading = self.value(&deadline.reading);
        let from = is_one.then(|| deadline.waits.first().map_or(reading.clone(), |wait| self.get(wait.from)));
        Deadline { at_once: self.condition(&deadline.at_once), waits, reading, from }
    }

    fn late(&self) -> Vec<(StepId, TokenStream)> {
        let late = self.program.deadline.iter().flat(|deadline| &deadline.late);
        late.map(|(step, over)| (*step, self.condition(over))).list()
    }

    /// The private enums of the regions.
    fn types(&self) -> TokenStream {
        let enums = self.regions().iter().map(|states| state::region_enum(self.cx, states)).tokens();
        let methods = self.layout.flags.and_then(|flags| self.unpacking(flags));
        quote!(#enums #methods)
    }

    fn regions(&self) -> Vec<StateEnum> {
        let (mut regions, mark) = (Vec::new(), self.layout.mark);
        for (region, states) in self.layout.regions.iter().enumerate() {
            let place = self.program.place(Role::State(region));
            if place.is_none_or(|place| self.layout.slot(place).kind == Kind::Unused) {
                continue;
            }
            regions.push(StateEnum {
                region,
                states: self.program.states(region),
                empty: states.empty,
                start: states.start.is_some(),
                marked: region == 0 && mark.is_some(),
                wide: region == 0 && mark.is_some_and(|Mark { is_wide }| is_wide),
            });
        }
        regions
    }

    fn is_active(&self, step: StepId) -> TokenStream {
        if let Some(flags) = self.layout.flags {
            return self.is_active_by_flags(flags, step);
        }
        let (region, states) = self.program.home(step);
        let Some(place) = self.program.place(Role::State(region)) else { return quote!(false) };
        let starts = matches!(self.layout.regions[region].start, Some(Start(Some(seen))) if states.contains(&seen));
        let start = starts.then(|| self.start(region));
        let states = states.iter().map(|state| self.cx.variant_of(*state, region)).list();
        self.cx.is_one_of(&self.get(place), &states, start)
    }

    /// The body of `situation`.
    fn situation(&self) -> TokenStream {
        let cx = self.cx;
        if let (Some(flags), false) = (self.layout.flags, cx.plan.one_step) {
            return self.situation_of_flags(flags);
        }
        let state = |region| self.program.place(Role::State(region)).map(|place| self.get(place));
        if !cx.plan.one_step {
            let name = &cx.names.situation;
            let regions = self.regions().into_iter().map(|StateEnum { region, .. }| {
                let (field, state) = (names::region_field(region, cx.plan), state(region));
                let Some(Start(seen)) = self.layout.regions[region].start else { return quote!(#field: #state,) };
                let (start, seen) = (self.start(region), self.variant(seen, region));
                quote!(#field: match #state { #start => #seen, entered_ => entered_ },)
            });
            return quote!(#name { #(#regions)* });
        }
        let arms = cx.plan.regions.all()[0].steps.iter().enumerate().map(|(index, id)| {
            let (variant, name) = (cx.variant(*id), state::step_name(cx, *id));
            let states = self.layout.regions[0];
            let start = (states.start == Some(Start(Some(*id)))).then(|| self.start(0));
            // There is always an active step.
            let none = (states.empty && index == 0).then(|| cx.empty(0));
            let others = start.into_iter().and(none).map(|other| quote!(| #other));
            quote!(#variant #(#others)* => #name,)
        });
        let (arms, state) = (arms.tokens(), state(0));
        quote!(match #state { #arms })
    }

    /// The values of the stored variables.
    fn vars(&self) -> Vec<TokenStream> {
        let vars = self.cx.plan.vars.iter();
        let places = vars.filter_map(|id| self.program.place(Role::Var(*id)));
        places.map(|place| self.get(place)).list()
    }
}
