//! What is stored, and how it is called.

use super::{Clocks, Lower, Set};
use crate::analysis::{Facts, edge_ends};
use crate::list::List;
use crate::model::{DelayId, EdgeId, Effect, Expr as Written, Id, Model, Name, Read, StepId, TransitionId, Ty};
use crate::program::{Initial, PlaceId, PlaceInfo, Regions, Role, Type, Value};
use crate::raw::plain;
use crate::sorted::sort_by_key;

/// An edge: what it compares with, and what its expression is now.
#[derive(Clone, Copy)]
pub(super) struct Edges {
    pub(super) before: PlaceId,
    pub(super) now: PlaceId,
    pub(super) asked: Asked,
    /// What it compares with has to be found in the first evolution, in which there is no edge (A26).
    pub(super) is_hidden: bool,
}

/// Which edges of an expression are asked for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Asked {
    Rising,
    Falling,
    Both,
}

/// What a delay remembers.
#[derive(Clone, Copy)]
pub(super) struct Delays {
    /// What its expression is now.
    pub(super) now: PlaceId,
    pub(super) followed: Followed,
}

/// How the output of a delay follows its expression.
#[derive(Clone, Copy)]
pub(super) enum Followed {
    /// Its expression and its output in the last cycle, and how long the former has been what it is.
    Counted { input: PlaceId, held: PlaceId, output: PlaceId },
    /// By stages: since when it is in one in which it waits.
    Read { stage: PlaceId, began: PlaceId },
}

impl Phases {
    /// Of which steps it says how far their period is.
    pub(super) fn steps(&self) -> (Role, Vec<(StepId, u32)>) {
        let all = self.periods.iter().flat_map(|(period, steps)| steps.iter().map(|step| (*step, *period)));
        (self.role, all.list())
    }
}

/// The phase of something that blinks since the activation of a region's step or of a macro-step.
pub(super) struct Phases {
    pub(super) role: Role,
    /// With the steps that blink so: beside others of the region the phase means nothing.
    pub(super) periods: Vec<(u32, Vec<StepId>)>,
    pub(super) phase: PlaceId,
    /// `sfc`: before the evolution.
    pub(super) reached: PlaceId,
}

impl<'r, 'm> Lower<'r, 'm> {
    pub(super) fn new(model: &'m Model, regions: &'r Regions, facts: &Facts<'_>, clocks: Clocks) -> Self {
        let mut lower = Self {
            model,
            regions,
            initial: facts.initial.clone(),
            partials: facts.top_down.clone(),
            places: Vec::new(),
            first: PlaceId(0),
            state: Vec::new(),
            was: Vec::new(),
            asked: Vec::new(),
            clocks,
            time: Vec::new(),
            reached: Vec::new(),
            macro_time: Vec::new(),
            macro_reached: Vec::new(),
            phases: Vec::new(),
            common_phase: Vec::new(),
            periods: Vec::new(),
            longest: Vec::new(),
            outlasted: Set::new(),
            passed: Vec::new(),
            elapsed: None,
            reading: None,
            settled: None,
            edge_ends: edge_ends(model, !model.is_grafcet() || facts.left_and_entered(model).is_empty()),
            turned: None,
            opaque_ran: None,
            timers: Vec::new(),
            own: Vec::new(),
            edges: vec![None; model.edges.len()],
            action_edges: vec![None; model.edges.len()],
            delays: Vec::new(),
            outputs: Vec::new(),
            last_outputs: vec![None; model.outputs.len()],
            vars: Vec::new(),
            params: Vec::new(),
            combinational: vec![None; model.vars.len()],
            clears: Vec::new(),
            anys: Vec::new(),
            left: Vec::new(),
            entered: Vec::new(),
            free: vec![None; model.partials.len()],
            evolutions: PlaceId(0),
            comes_back: facts.searches(model).comes_back,
            search_ends: clocks == Clocks::Read && super::ends(model, facts),
            bound: facts.searches(model).bound,
        };
        lower.first = lower.field("first".to_owned(), Role::First, Type::Bool, truth(true));
        lower.situation();
        lower.declared(facts);
        lower.clocks(facts);
        lower.remembered();
        lower.transitions();
        lower
    }

    pub(super) fn field(&mut self, name: String, role: Role, ty: Type<'m>, initial: Initial<'m>) -> PlaceId {
        self.places.push(PlaceInfo { name, role, ty, initial, is_field: true });
        PlaceId(self.places.len() - 1)
    }

    pub(super) fn local(&mut self, name: String, ty: Type<'m>) -> PlaceId {
        let initial = initial_of(ty);
        self.places.push(PlaceInfo::local(name, ty, initial));
        PlaceId(self.places.len() - 1)
    }

    pub(super) fn truth(&mut self, name: String) -> PlaceId {
        self.local(name, Type::Bool)
    }

    /// A local of the type of another place.
    pub(super) fn like(&mut self, name: String, other: PlaceId) -> PlaceId {
        let PlaceInfo { ty, initial, .. } = self.places[other.0];
        let like = self.local(name, ty);
        // A type of the program need not have a default value.
        if let (Type::User(Ty::Other(_)), Initial::Constant(_)) = (ty, initial) {
            self.places[like.0].initial = initial;
        }
        like
    }

    pub(super) fn name(&self, place: PlaceId) -> &str {
        &self.places[place.0].name
    }

    pub(super) fn step_name(&self, step: StepId) -> String {
        plain(&self.model.steps[step].name)
    }

    /// The situation and its copy.
    fn situation(&mut self) {
        for region in 0..self.regions.all().len() {
            let active = self.regions.all()[region].initial;
            let name = self.region_name("state", region);
            let was = format!("was.{name}");
            let initial = Initial::Value(Value::Step(active));
            let state = self.field(name, Role::State(region), Type::State(region), initial);
            self.state.push(state);
            let was = self.situation_like(was, state);
            self.was.push(was);
            if self.model.forceable {
                let name = format!("asked.{}", self.name(state));
                let asked = self.situation_like(name, state);
                self.places[asked.0].role = Role::Asked(region);
                self.asked.push(asked);
            }
        }
    }

    /// A local that holds what a state may be; no other value is ever seen in it.
    fn situation_like(&mut self, name: String, state: PlaceId) -> PlaceId {
        let like = self.like(name, state);
        self.places[like.0].initial = self.places[state.0].initial;
        like
    }

    /// `state`, or with the first step of the region where there are several.
    pub(super) fn region_name(&self, what: &str, region: usize) -> String {
        match self.regions.all() {
            [_] => what.to_owned(),
            regions => format!("{what}.{}", self.step_name(regions[region].steps[0])),
        }
    }

    /// Outputs, variables and parameters.
    fn declared(&mut self, facts: &Facts<'_>) {
        let model = self.model;
        for (id, output) in model.outputs.iter() {
            let initial = constant(output.init.as_ref());
            let place = self.field(plain(&output.name), Role::Output(id), declared(&output.ty), initial);
            self.outputs.push(place);
        }
        for (id, var) in model.vars.iter() {
            let place = self.field(plain(&var.name), Role::Var(id), declared(&var.ty), constant(var.init.as_ref()));
            self.vars.push(place);
        }
        for (id, param) in model.params.iter() {
            let initial = constant(param.init.as_ref());
            let place = self.field(plain(&param.name), Role::Param(id), declared(&param.ty), initial);
            self.params.push(place);
        }
        for var in facts.combinational(model) {
            let name = format!("now.{}", plain(&model.vars[*var].name));
            self.combinational[var.index()] = Some(self.truth(name));
        }
        if model.is_grafcet() {
            return;
        }
        for association in model.associations.values() {
            for read in association.reads().concat() {
                if let Read::Name(Name::Output(id)) = read {
                    if self.last_outputs[id.index()].is_none() {
                        let (name, output) = (plain(&model.outputs[id].name), self.outputs[id.index()]);
                        self.last_outputs[id.index()] = Some(self.like(format!("last.{name}"), output));
                    }
                }
            }
        }
    }

    /// Edges and delays.
    fn remembered(&mut self) {
        let model = self.model;
        for (id, delay) in model.delays.iter() {
            let name = format!("delay{}", id.index());
            let is_read = self.reads(delay);
            let mut field = |part: &str, role, ty, initial| self.field(format!("{name}.{part}"), role, ty, initial);
            let followed = if is_read {
                Followed::Read {
                    began: field("since", Role::DelayBegan(id), Type::Ticks, time()),
                    stage: field("stage", Role::DelayStage(id), Type::Number, Initial::Value(Value::Int(0))),
                }
            } else {
                Followed::Counted {
                    held: field("held", Role::DelayHeld(id), Type::Ticks, time()),
                    input: field("in", Role::DelayInput(id), Type::Bool, truth(false)),
                    output: field("out", Role::DelayOutput(id), Type::Bool, truth(false)),
                }
            };
            let now = self.truth(format!("{name}.now"));
            self.delays.push(Delays { now, followed });
        }
        let (early, late) = self.asked_edges();
        let reads = model.expressions().concat();
        for id in model.edges.ids() {
            let name = format!("edge{}", id.index());
            let asked = match (reads.contains(&Read::Rising(id)), reads.contains(&Read::Falling(id))) {
                (true, true) => Asked::Both,
                (true, false) => Asked::Rising,
                (false, _) => Asked::Falling,
            };
            if early.contains(&id) {
                self.edges[id.index()] = Some(self.edge_of(id, &name, asked, Role::Edge(id)));
            }
            if late.contains(&id) {
                let name = format!("action.{name}");
                self.action_edges[id.index()] = Some(self.edge_of(id, &name, asked, Role::ActionEdge(id)));
            }
        }
    }

    /// What is true already does not rise: what the field begins with says so. Of steps alone it is known in the first evolution, and asks nothing then.
    fn edge_of(&mut self, id: EdgeId, name: &str, asked: Asked, role: Role) -> Edges {
        let is_step = |read: &Read| matches!(read, Read::Active(_) | Read::MacroActive(_));
        let is_hidden = asked == Asked::Both || self.model.edges[id].of.reads.iter().all(is_step);
        let begins = truth(asked == Asked::Rising && !is_hidden);
        let before = self.field(format!("{name}.before"), role, Type::Bool, begins);
        Edges { before, now: self.truth(format!("{name}.now")), asked, is_hidden }
    }

    /// The edges that conditions and delays ask for, and those that the actions of an `sfc` ask for.
    fn asked_edges(&self) -> (Set<EdgeId>, Set<EdgeId>) {
        let model = self.model;
        let (mut early, mut late) = (Set::new(), Set::new());
        for transition in model.transitions.values() {
            self.edges_in(&transition.condition.reads, &mut early);
            for reads in transition.clearing.iter().flat(Effect::reads) {
                self.edges_in(reads, &mut early);
            }
        }
        for delay in model.delays.values() {
            self.edges_in(&delay.of.reads, &mut early);
        }
        for association in model.associations.values() {
            for reads in association.reads() {
                self.edges_in(reads, if model.is_grafcet() { &mut early } else { &mut late });
            }
        }
        (early, late)
    }

    fn edges_in(&self, reads: &[Read], found: &mut Set<EdgeId>) {
        for read in reads {
            if let Read::Rising(id) | Read::Falling(id) = read {
                if found.insert(*id) {
                    self.edges_in(&self.model.edges[*id].of.reads, found);
                }
            }
        }
    }

    /// What is decided in an evolution.
    fn transitions(&mut self) {
        let model = self.model;
        for (id, any) in model.anys.iter() {
            let place = self.truth(format!("any{}.{}", id.index(), self.arrow(any.first)));
            self.anys.push(place);
        }
        let names = model.transitions.ids().map(|id| format!("clears.{}", self.arrow(id))).list();
        for (name, number) in numbered(names) {
            let place = self.truth(if number > 1 { format!("{name}#{number}") } else { name });
            self.clears.push(place);
        }
        if !model.is_grafcet() {
            for step in model.steps.ids() {
                let name = self.step_name(step);
                let (left, entered) = (self.truth(format!("left.{name}")), self.truth(format!("entered.{name}")));
                self.left.push(left);
                self.entered.push(entered);
            }
            return;
        }
        self.evolutions = self.local("evolutions".to_owned(), Type::Number);
        self.places[self.evolutions.0].role = Role::Evolutions;
        for (id, partial) in model.partials.iter() {
            if partial.enclosed_by.is_some() || !partial.forced_by.is_empty() {
                let name = partial.name.as_ref().map_or_else(|| "chart".to_owned(), plain);
                self.free[id.index()] = Some(self.truth(format!("free.{name}")));
            }
        }
    }

    /// `Off→On`, or the transition's name.
    fn arrow(&self, id: TransitionId) -> String {
        let transition = &self.model.transitions[id];
        if let (Some(name), None) = (&transition.name, transition.any) {
            return plain(name);
        }
        let side = |steps: &[StepId]| {
            let names: Vec<String> = steps.iter().map(|step| self.step_name(*step)).list();
            if names.len() == 1 { names.concat() } else { format!("({})", names.join(",")) }
        };
        format!("{}→{}", side(&transition.sources), side(&transition.targets))
    }

    pub(super) fn delay(&self, id: DelayId) -> Delays {
        self.delays[id.index()]
    }
}

/// Each name with how many there have been of it so far.
fn numbered(names: Vec<String>) -> Vec<(String, usize)> {
    let mut order = (0..names.len()).list();
    sort_by_key(&mut order, |place| &names[*place]);
    let mut numbers = vec![1; names.len()];
    for pair in order.windows(2) {
        if names[pair[0]] == names[pair[1]] {
            numbers[pair[1]] = numbers[pair[0]] + 1;
        }
    }
    names.into_iter().zip(numbers).list()
}

pub(super) fn truth<'m>(value: bool) -> Initial<'m> {
    Initial::Value(Value::Bool(value))
}

pub(super) fn time<'m>() -> Initial<'m> {
    Initial::Value(Value::Ticks(0))
}

fn constant(init: Option<&Written>) -> Initial<'_> {
    init.map_or(Initial::Default, Initial::Constant)
}

fn declared(ty: &Ty) -> Type<'_> {
    match ty {
        Ty::Bool(_) => Type::Bool,
        Ty::Time(_) => Type::Ticks,
        Ty::Int { .. } | Ty::Other(_) => Type::User(ty),
    }
}

fn initial_of(ty: Type<'_>) -> Initial<'_> {
    Initial::Value(match ty {
        Type::Bool => Value::Bool(false),
        Type::Ticks => Value::Ticks(0),
        Type::State(_) => Value::Step(None),
        Type::Number | Type::Kind { .. } => Value::Int(0),
        Type::User(_) => return Initial::Default,
    })
}
