//! From the spanned syntax to the model: first all names are declared, then everything that mentions them is resolved.
//!
//! What cannot be resolved is reported and left out, so that the rest of the chart can still be checked.

mod actions;
mod any;
mod blink;
mod chains;
mod code;
mod composed;
mod computed;
mod declare;
mod delay;
mod exclusion;
mod expr;
mod foreign;
mod forgotten;
mod habits;
mod misplaced;
mod modes;
mod named;
mod names;
mod otherwise;
mod properties;
mod pure;
mod ranges;
mod remembered;
mod scope;
mod text;
mod time;
mod variants;

use proc_macro2::{Ident, Span};

use self::blink::Owner;
use self::named::{Named, Scale};
use self::scope::Scope;
use super::{
    Arena, Blinker, Dialect, ForceOrder, Id, InputId, LetId, LevelAttr, MacroId, Mention, Model, Name, PartialId,
    Plants, Step, StepId, TransitionId, Ty,
};
use crate::ast;
use crate::diagnostic::{Mark, Sink, rules};
use crate::list::PushAll;
use crate::sorted::Set;

/// Resolves a chart. Mistakes go to the sink; the model holds all that could be understood.
pub fn resolve(chart: &ast::Chart, sink: &mut Sink) -> Model {
    let mut resolver = Resolver {
        model: empty(chart),
        scope: Scope::beside(&chart.plants),
        sink,
        steps: Vec::new(),
        partials: Vec::new(),
        withins: Vec::new(),
        broken_macros: Vec::new(),
        settings: Vec::new(),
        modes: Vec::new(),
        mode_inputs: None,
        owner: Owner::Chart,
        from: None,
        alone: Vec::new(),
        drawn: Set::new(),
        elses: Vec::new(),
        forgotten: 0,
        unread: chart.incomplete,
        pure: Vec::new(),
        calls: 0,
        lets: Vec::new(),
        defining: None,
        scale: Scale::default(),
    };
    resolver.declare_chart(&chart.body);
    resolver.resolve_withins();
    resolver.check_lets();
    chains::drawn(&chart.body, &mut resolver.drawn);
    resolver.scope.name_the_nameless(&resolver.drawn);
    let mut cursor = Cursor::default();
    resolver.anys(&chart.body, PartialId::new(0));
    resolver.body(&chart.body, PartialId::new(0), &mut cursor);
    resolver.otherwise();
    resolver.hold();
    resolver.guard();
    resolver.unused_pure();
    resolver.connect();
    resolver.model
}

/// What is under construction while a chart is resolved.
pub(super) struct Resolver<'s> {
    model: Model,
    scope: Scope,
    sink: &'s mut Sink,
    /// The ids given while declaring, in source order; resolving meets the items in the same order.
    steps: Vec<StepId>,
    partials: Vec<PartialId>,
    /// What stands after `within`, by step.
    withins: Vec<(StepId, ast::Within)>,
    /// Macro-steps without exactly one entry and one exit step: no transition can be drawn to them.
    broken_macros: Vec<MacroId>,
    /// `clock` and its like, where they stand first.
    settings: Vec<(&'static str, Mark)>,
    /// Where `modes;` stands.
    modes: Vec<(PartialId, Span)>,
    /// What it declares: `semi_automatic`, `manual`, `paused`, `push`.
    mode_inputs: Option<[InputId; 4]>,
    /// To which step the expression belongs that is being resolved.
    owner: Owner,
    /// The first step in front of the condition that is being resolved.
    from: Option<String>,
    /// The names that stand alone in the condition that is being resolved, as parts of it.
    alone: Vec<String>,
    /// Every name in a chain.
    drawn: Set<String>,
    /// The transitions whose condition is `else`.
    elses: Vec<TransitionId>,
    /// How many transitions lack a step in front of them or after.
    forgotten: usize,
    /// Something of the source could not be parsed, and is missing.
    unread: bool,
    /// The functions, methods and macros that the chart says are pure, and whether it calls them.
    pure: Vec<(syn::Path, bool)>,
    /// How many evaluations there are that may have values of their own.
    calls: u32,
    /// By `LetId`.
    lets: Vec<Named>,
    /// The `let` that is being resolved.
    defining: Option<LetId>,
    scale: Scale,
}

/// How far resolving has come in the ids given while declaring.
#[derive(Default)]
struct Cursor {
    step: usize,
    partial: usize,
}

fn empty(chart: &ast::Chart) -> Model {
    let mut levels = chart.attrs.levels.clone();
    levels.push_all(chart.body.levels.iter().cloned());
    Model {
        dialect: chart.dialect,
        name: chart.name.clone(),
        vis: chart.vis.clone(),
        attrs: chart.attrs.passed_on.clone(),
        derives: chart.attrs.derives.clone(),
        levels,
        is_plant: chart.is_plant,
        clock_nanos: time::MILLISECOND,
        incomplete: false,
        max_evolutions: None,
        optimize_size: false,
        forceable: false,
        modes: None,
        flags: false,
        inputs: Arena::default(),
        outputs: Arena::default(),
        vars: Arena::default(),
        params: Arena::default(),
        variants: Vec::new(),
        lets: Arena::default(),
        actions: Arena::default(),
        partials: Arena::default(),
        steps: Arena::default(),
        macros: Arena::default(),
        transitions: Arena::default(),
        leaving: Vec::new(),
        entering: Vec::new(),
        anys: Arena::default(),
        associations: Arena::default(),
        forces: Arena::default(),
        edges: Arena::default(),
        delays: Arena::default(),
        budget: None,
        assumptions: Vec::new(),
        often: Vec::new(),
        orders: Vec::new(),
        longest_cycle: None,
        properties: Vec::new(),
        memories: Arena::default(),
        plants: Plants::default(),
        mentions: Vec::new(),
    }
}

impl Resolver<'_> {
    /// Which transitions leave each step, and which lead to it.
    fn connect(&mut self) {
        let model = &mut self.model;
        (model.leaving, model.entering) = (vec![Vec::new(); model.steps.len()], vec![Vec::new(); model.steps.len()]);
        for (id, transition) in model.transitions.iter() {
            for step in &transition.sources {
                model.leaving[step.index()].push(id);
            }
            for step in &transition.targets {
                model.entering[step.index()].push(id);
            }
        }
    }

    /// The second pass over a body, in source order.
    fn body(&mut self, body: &ast::Body, partial: PartialId, cursor: &mut Cursor) {
        self.lost_items(body);
        let forgotten = self.forgotten;
        for item in &body.items {
            match item {
                ast::Item::Decl(decl) => {
                    self.initial_value(decl);
                    self.range(decl);
                }
                ast::Item::Setting(ast::Setting::AssumeOften { condition, .. }) => self.recurrence(condition),
                ast::Item::Setting(ast::Setting::AssumeCycle { keyword, longest }) => {
                    self.cycle_time(*keyword, longest);
                }
                ast::Item::Setting(ast::Setting::AssumeOrder { keyword, order }) => self.order(*keyword, order),
                ast::Item::Setting(ast::Setting::AssumeNever { keyword, condition }) => {
                    self.assumption(*keyword, condition);
                }
                ast::Item::Let(_) | ast::Item::Action(_) | ast::Item::Setting(_) => {}
                ast::Item::Property(property) => self.property(property),
                ast::Item::Step(step) => self.step(step, partial, cursor),
                ast::Item::Chain(chain) => self.chain(chain, partial),
                ast::Item::Partial(inner) => self.partial(inner, cursor),
            }
        }
        self.touched_by_forgotten(partial, self.forgotten - forgotten);
    }

    fn partial(&mut self, partial: &ast::Partial, cursor: &mut Cursor) {
        let id = self.partials[cursor.partial];
        cursor.partial += 1;
        self.anys(&partial.body, id);
        self.body(&partial.body, id, cursor);
    }

    fn step(&mut self, step: &ast::Step, partial: PartialId, cursor: &mut Cursor) {
        if let ast::StepKind::Macro(_, body) = &step.kind {
            return self.body(body, partial, cursor);
        }
        let id = self.steps[cursor.step];
        cursor.step += 1;
        match &step.kind {
            ast::StepKind::Plain(body) => self.step_body(id, body),
            ast::StepKind::Enclosing(_, body, partials) => {
                self.step_body(id, body);
                for inner in partials {
                    self.partial(inner, cursor);
                }
            }
            ast::StepKind::Macro(..) => {}
        }
    }

    fn step_body(&mut self, step: StepId, body: &ast::StepBody) {
        self.owner = Owner::One(Blinker::Step(step));
        self.from = Some(self.model.steps[step].name.to_string());
        for association in &body.associations {
            self.association(step, association);
        }
        self.from = None;
        self.owner = Owner::Chart;
        for force in &body.forces {
            self.force(step, force);
        }
    }

    fn force(&mut self, step: StepId, force: &ast::Force) {
        self.only_in_grafcet(force.mark, "forcing orders");
        if self.model.dialect == Dialect::Sfc {
            // It has no partial grafcets either.
            return self.lose();
        }
        let Some(target) = self.find_partial(&force.partial) else { return self.lose() };
        let order = match &force.order {
            ast::ForceOrder::Steps(names) => ForceOrder::Steps(self.forced_steps(names, target)),
            ast::ForceOrder::Hold => ForceOrder::Hold,
            ast::ForceOrder::Empty => ForceOrder::Steps(Vec::new()),
            ast::ForceOrder::Init => ForceOrder::Init,
        };
        let id = self.model.forces.push(super::Force { step, target, order, mark: force.mark });
        self.model.steps[step].forces.push(id);
        self.model.partials[target].forced_by.push(id);
    }

    /// The steps of a forced situation; only real steps of the forced partial grafcet can be listed.
    fn forced_steps(&mut self, names: &[Ident], target: PartialId) -> Vec<StepId> {
        let mut steps = Vec::new();
        for name in names {
            self.mention(name);
            match self.scope.step(name, self.sink) {
                Some(scope::Meaning::Step(step)) => {
                    self.forced_step(name, step, target);
                    match names.iter().find(|first| *first == name) {
                        Some(first) if steps.contains(&step) => self.repeated_step(first, name),
                        _ => steps.push(step),
                    }
                }
                Some(_) => {
                    let message = format!("`{name}` is a macro-step; name the step of its expansion that is meant");
                    self.sink.notation(name, message);
                    self.lose();
                }
                None => self.lose(),
            }
        }
        steps
    }

    /// Takes note that a step or macro-step is named here.
    fn mention(&mut self, name: &Ident) {
        let mention = match self.scope.get(name) {
            Some(scope::Meaning::Step(step)) => Mention::Step(step),
            Some(scope::Meaning::Macro(id)) => Mention::Macro(id),
            _ => return,
        };
        self.model.mentions.push((mention, name.span()));
    }

    /// The partial grafcet of that name, which is taken note of; none is reported.
    fn find_partial(&mut self, name: &Ident) -> Option<PartialId> {
        let id = self.scope.partial(name, self.sink)?;
        self.model.mentions.push((Mention::Partial(id), name.span()));
        Some(id)
    }

    /// Reports a step of a forced situation that belongs to another partial grafcet.
    fn forced_step(&mut self, name: &Ident, step: StepId, forced: PartialId) {
        let home = self.model.steps[step].partial;
        if home != forced {
            let (home, forced) = (self.partial_name(home), self.partial_name(forced));
            let message = format!("step `{name}` belongs to {home}, the order forces {forced}; name steps of {forced}");
            self.sink.rule(&rules::FORCED_STEP_OUTSIDE, &[], vec![(name.into(), message)]);
        }
    }

    /// Reports `Production::Ready` where `Ready` is a step of another partial grafcet.
    fn step_of_partial(&mut self, name: &Ident, step: StepId, partial: PartialId) {
        let home = self.model.steps[step].partial;
        if home != partial {
            let mend = match &self.model.partials[home].name {
                Some(home) => format!("`{home}::{name}`"),
                None => format!("`{name}` alone"),
            };
            let message = format!("step `{name}` does not belong to {}; write {mend}", self.partial_name(partial));
            self.sink.rule(&rules::UNKNOWN_STEP, &[], vec![(name.into(), message)]);
        }
    }

    fn partial_name(&self, partial: PartialId) -> String {
        match &self.model.partials[partial].name {
            Some(name) => format!("`{name}`"),
            None => "the chart itself".to_owned(),
        }
    }

    /// Whether a value is a number or a `bool`, which has no fields.
    fn is_plain(&self, value: Name) -> bool {
        let ty = match value {
            Name::Input(id) => &self.model.inputs[id].ty,
            Name::Output(id) => &self.model.outputs[id].ty,
            Name::Var(id) => &self.model.vars[id].ty,
            Name::Param(id) => &self.model.params[id].ty,
        };
        !matches!(ty, Ty::Other(_))
    }

    /// Something could not be resolved and is missing from the model.
    fn lose(&mut self) {
        self.model.incomplete = true;
    }
}

/// The lint attributes of a step or transition and of the chart around it, the innermost first.
impl Model {
    /// The scopes in which levels for a step are looked up.
    #[must_use]
    pub(crate) fn levels_of<'m>(&'m self, step: &'m Step) -> Vec<&'m [LevelAttr]> {
        vec![&step.levels, &self.partials[step.partial].levels, &self.levels]
    }

    /// Whether the chart evolves by IEC 60848.
    #[must_use]
    pub fn is_grafcet(&self) -> bool {
        self.dialect == Dialect::Grafcet
    }
}
