//! Expression trees become formulas over numbered atoms.

mod numbers;

use crate::analysis::combinational;
use crate::analysis::explore::net::formula::{Atom, AtomId, Formula, Kind, SharedId};
use crate::analysis::explore::net::links::Difference;
use crate::analysis::explore::net::slots::SlotId;
use crate::list::List;
use crate::model::{
    Arena, Binary, Blinker, DelayId, EdgeId, Model, Name, OutputId, Place, Qualifier, Read, StepId, TimeRef, Tree, Ty,
    Unary, VarId,
};
use crate::sorted::{Map, Set};

/// Numbers the atoms of a chart.
pub(crate) struct Compiler<'m> {
    model: &'m Model,
    /// The number of each place that is followed from cycle to cycle.
    slots: &'m Map<Place, SlotId>,
    /// Places with actions of two kinds.
    mixed: &'m Set<Place>,
    pub(crate) atoms: Arena<AtomId, Atom>,
    pub(crate) numbers: Map<Tree, AtomId>,
    pub(crate) differences: Vec<Difference>,
    differences_of: Map<(Tree, Tree), AtomId>,
    /// What the edges look at, where they are used.
    pub(crate) edges: Arena<EdgeId, Option<Formula>>,
    pub(crate) shared: Arena<SharedId, Formula>,
    /// How many parts each of them has, written out.
    sizes: Arena<SharedId, usize>,
    combinational: Map<Place, Option<SharedId>>,
    /// Inside the expression of an edge.
    in_edge: bool,
    /// What is compiled is what held when the cycle began.
    was: bool,
    /// Inside an action: of an `sfc`, its edges compare what two evolutions have led to.
    pub(crate) in_action: bool,
    /// Something is taken as unknown that is not, or only partly.
    pub(crate) approximate: bool,
}

/// How many parts a formula has by itself.
fn own_parts(formula: &Formula) -> usize {
    match formula {
        Formula::Not(inner) => 1 + own_parts(inner),
        Formula::And(a, b) | Formula::Or(a, b) | Formula::Same(a, b) => 1 + own_parts(a) + own_parts(b),
        _ => 1,
    }
}

/// What a variable is made of is looked into if what it shares with others has no more parts, written out: it is walked through as if it stood there.
const LARGE: usize = 10_000;

impl<'m> Compiler<'m> {
    pub(crate) fn new(model: &'m Model, slots: &'m Map<Place, SlotId>, mixed: &'m Set<Place>) -> Self {
        Self {
            model,
            slots,
            mixed,
            atoms: Arena::default(),
            numbers: Map::new(),
            differences: Vec::new(),
            differences_of: Map::new(),
            edges: Arena::of(&model.edges, |_, _| None),
            shared: Arena::default(),
            sizes: Arena::default(),
            combinational: Map::new(),
            in_edge: false,
            was: false,
            in_action: false,
            approximate: false,
        }
    }

    /// A boolean expression.
    pub(crate) fn formula(&mut self, tree: &Tree) -> Formula {
        match tree {
            Tree::Bool(value) => Formula::Const(*value),
            Tree::Unary(Unary::Not, inner) => self.formula(inner).negate(),
            Tree::Binary(operator, a, b) => self.binary(tree, *operator, a, b),
            Tree::Elapsed(time, step) => {
                let since = Tree::Read(Read::Since(*step));
                let active = Formula::Is(self.atom(&Tree::Read(Read::Active(*step)), Kind::Step(*step)));
                let elapsed = self.elapsed(tree, *time, &since, Kind::Since(*step));
                active.and(elapsed)
            }
            Tree::MacroElapsed(time, id) => {
                let since = Tree::Read(Read::MacroSince(*id));
                let active = Formula::Is(self.atom(&Tree::Read(Read::MacroActive(*id)), Kind::Macro(*id)));
                let elapsed = self.elapsed(tree, *time, &since, Kind::MacroSince(*id));
                active.and(elapsed)
            }
            Tree::Read(read) => self.read(tree, *read),
            Tree::Int(_) | Tree::Unary(..) | Tree::Opaque { .. } => self.unknown(tree),
        }
    }

    fn elapsed(&mut self, tree: &Tree, time: TimeRef, since: &Tree, kind: Kind) -> Formula {
        self.approximate = true;
        match time {
            TimeRef::Ticks(ticks) => Formula::Below(self.atom(since, kind), i128::from(ticks)).negate(),
            TimeRef::Param(_) | TimeRef::Var(_) => self.unknown(tree),
        }
    }

    fn binary(&mut self, tree: &Tree, operator: Binary, a: &Tree, b: &Tree) -> Formula {
        match operator {
            Binary::And => return self.formula(a).and(self.formula(b)),
            Binary::Or => return self.formula(a).or(self.formula(b)),
            _ => {}
        }
        if self.is_boolean(a) && self.is_boolean(b) {
            match operator {
                Binary::BitAnd => return self.formula(a).and(self.formula(b)),
                Binary::BitOr => return self.formula(a).or(self.formula(b)),
                Binary::Eq => return self.formula(a).same(self.formula(b)),
                Binary::BitXor | Binary::Ne => return self.formula(a).same(self.formula(b)).negate(),
                _ => {}
            }
        }
        let found = self.float_comparison(operator, a, b).or_else(|| self.comparison(operator, a, b));
        found.unwrap_or_else(|| self.unknown(tree))
    }

    fn ty(&self, name: Name) -> &'m Ty {
        match name {
            Name::Input(id) => &self.model.inputs[id].ty,
            Name::Output(id) => &self.model.outputs[id].ty,
            Name::Var(id) => &self.model.vars[id].ty,
            Name::Param(id) => &self.model.params[id].ty,
        }
    }

    fn read(&mut self, tree: &Tree, read: Read) -> Formula {
        match read {
            Read::Active(step) if self.was => self.was_active(step),
            Read::MacroActive(id) if self.was => {
                any(self.model.macros[id].steps.iter().map(|step| self.was_active(*step)).list())
            }
            Read::Active(step) => Formula::Is(self.atom(tree, Kind::Step(step))),
            Read::MacroActive(id) => Formula::Is(self.atom(tree, Kind::Macro(id))),
            Read::Name(Name::Input(_) | Name::Param(_)) => Formula::Is(self.atom(tree, Kind::Free)),
            Read::Name(Name::Var(id)) => self.place(tree, Place::Var(id)),
            Read::Name(Name::Output(id)) => self.place(tree, Place::Output(id)),
            Read::Rising(id) => self.edge(tree, id, true),
            Read::Falling(id) => self.edge(tree, id, false),
            Read::Delay(id) => self.delay(tree, id),
            Read::Blink(blink) => {
                self.approximate = true;
                let phase = match blink.of {
                    Blinker::Step(step) => Kind::Phase(step),
                    Blinker::Macro(_) => Kind::Free,
                };
                let active = self.formula(&Tree::Read(blink.of.active()));
                active.and(Formula::Is(self.atom(tree, phase)))
            }
            _ => self.unknown(tree),
        }
    }

    fn edge(&mut self, tree: &Tree, id: EdgeId, rises: bool) -> Formula {
        let late = self.in_action && self.model.is_late(id);
        if self.in_edge || late && !is_of_steps(&self.model.edges[id].of.tree) {
            // What an edge of an edge looks at lies two cycles back.
            return self.unknown(tree);
        }
        if late {
            return self.late_edge(id, rises);
        }
        if self.edges[id].is_none() {
            self.in_edge = true;
            let of = self.formula(&self.model.edges[id].of.tree);
            self.in_edge = false;
            self.edges[id] = Some(of);
        }
        if rises { Formula::Rising(id) } else { Formula::Falling(id) }
    }

    /// `sfc`: an edge of steps in an action compares what the evolution has led to with what that of the cycle before has: this
    /// one has begun there. In the first cycle both are the initial situation.
    fn late_edge(&mut self, id: EdgeId, rises: bool) -> Formula {
        let model = self.model;
        let now = self.formula(&model.edges[id].of.tree);
        self.was = true;
        let before = self.formula(&model.edges[id].of.tree);
        self.was = false;
        if rises { now.and(before.negate()) } else { before.and(now.negate()) }
    }

    fn was_active(&mut self, step: StepId) -> Formula {
        let text = format!("{} at the begin of the cycle", self.model.steps[step].name);
        let tree =
            Tree::Opaque { text, reads: vec![Read::Active(step)], call: None, whole: false, open: false, of: None };
        Formula::Is(self.atom(&tree, Kind::Was(step)))
    }

    /// Whether the time of an action control's qualifier has come: unknown, and of nothing else that is unknown.
    pub(crate) fn time_of(&mut self, qualifier: Qualifier, place: Place) -> Formula {
        let text = format!("{} {}", format!("{qualifier:?}").to_uppercase(), self.model.place_name(place));
        let time =
            self.unknown(&Tree::Opaque { text, reads: Vec::new(), call: None, whole: false, open: false, of: None });
        if let Formula::Is(atom) = time {
            self.atoms[atom].is_time = true;
        }
        time
    }

    /// `t/e` is true with `e` only; when, is open.
    fn delay(&mut self, tree: &Tree, id: DelayId) -> Formula {
        let delay = &self.model.delays[id];
        let stands_still = |read: &Read| matches!(read, Read::Name(Name::Input(_) | Name::Param(_)) | Read::Ticks(_));
        let late = self.unknown(tree);
        if delay.off == TimeRef::Ticks(0) && delay.of.reads.iter().all(stands_still) {
            return self.formula(&delay.of.tree).and(late);
        }
        late
    }

    fn place(&mut self, tree: &Tree, place: Place) -> Formula {
        if let Some(slot) = self.slots.get(&place) {
            return Formula::Is(self.atom(tree, Kind::Slot(*slot)));
        }
        let shared = match self.combinational.get(&place) {
            Some(shared) => *shared,
            None => {
                // While it is being compiled it is unknown to itself: a circle is refused elsewhere.
                self.combinational.insert(place, None);
                let formula = self.continuous(place).filter(|formula| self.shares(formula) <= LARGE);
                let shared = formula.map(|formula| self.share(formula));
                self.combinational.insert(place, shared);
                shared
            }
        };
        shared.map_or_else(|| self.unknown(tree), Formula::Shared)
    }

    /// What continuous actions of a `grafcet` make of a boolean variable (A22) or output (A9, A10, A35).
    fn continuous(&mut self, place: Place) -> Option<Formula> {
        let model = self.model;
        if !model.is_grafcet() || self.mixed.contains(&place) {
            return None;
        }
        let (init, boolean) = match place {
            Place::Var(id) => (&model.vars[id].init, var_is_continuous(model, id)),
            Place::Output(id) => (&model.outputs[id].init, output_is_continuous(model, id)),
        };
        if !boolean {
            return None;
        }
        let mut assignments = 0;
        let mut value = match init.as_ref().map(|init| &init.tree) {
            None => Formula::Const(false),
            Some(Tree::Bool(value)) => Formula::Const(*value),
            Some(other) => self.unknown(other),
        };
        let mut asserted = Vec::new();
        for association in model.associations.values() {
            if !association.qualifier.is_continuous() {
                continue;
            }
            let Some(assigned) = association.effect.continuous_value(place) else { continue };
            let active = Tree::Read(Read::Active(association.step));
            let mut asserts = self.formula(&active);
            if let Some(time) = association.time {
                let elapsed = self.formula(&Tree::Elapsed(time, association.step));
                let limit = association.qualifier.limits();
                asserts = asserts.and(if limit { elapsed.negate() } else { elapsed });
            }
            if let Some(condition) = &association.condition {
                asserts = asserts.and(self.formula(&condition.tree));
            }
            match assigned {
                None => asserted.push(asserts),
                Some(tree) => {
                    // The last in the source wins: `asserts && tree || !asserts && value`.
                    let asserts = self.share(asserts);
                    let on = Formula::Shared(asserts).and(self.formula(tree));
                    value = on.or(Formula::Shared(asserts).negate().and(value));
                    assignments += 1;
                }
            }
        }
        // Each assignment lies a level deeper.
        (assignments < 200).then(|| value.or(any(asserted)))
    }

    fn share(&mut self, formula: Formula) -> SharedId {
        self.sizes.push(self.shares(&formula).saturating_add(own_parts(&formula)));
        self.shared.push(formula)
    }

    /// How many parts what a formula shares with others has, written out wherever it stands.
    fn shares(&self, formula: &Formula) -> usize {
        match formula {
            Formula::Not(inner) => self.shares(inner),
            Formula::And(a, b) | Formula::Or(a, b) | Formula::Same(a, b) => {
                self.shares(a).saturating_add(self.shares(b))
            }
            Formula::Rising(edge) | Formula::Falling(edge) => {
                self.edges[*edge].as_ref().map_or(0, |of| self.shares(of).saturating_add(own_parts(of)))
            }
            Formula::Shared(index) => self.sizes[*index],
            Formula::Const(_) | Formula::Is(_) | Formula::Below(..) | Formula::Equals(..) => 0,
        }
    }

    /// A boolean about which nothing is known.
    fn unknown(&mut self, tree: &Tree) -> Formula {
        self.approximate = true;
        Formula::Is(self.atom(tree, Kind::Free))
    }

    fn atom(&mut self, tree: &Tree, kind: Kind) -> AtomId {
        if let Some(number) = self.numbers.get(tree) {
            return *number;
        }
        let number = self.atoms.push(Atom { kind, what: tree.clone(), volatile: is_volatile(tree), is_time: false });
        self.numbers.insert(tree.clone(), number);
        number
    }

    fn is_boolean(&self, tree: &Tree) -> bool {
        match tree {
            Tree::Bool(_) | Tree::Elapsed(..) | Tree::MacroElapsed(..) => true,
            Tree::Read(Read::Name(name)) => matches!(self.ty(*name), Ty::Bool(_)),
            Tree::Read(read) => !matches!(read, Read::Since(_) | Read::MacroSince(_) | Read::Ticks(_)),
            Tree::Unary(operator, inner) => *operator == Unary::Not && self.is_boolean(inner),
            Tree::Binary(Binary::BitAnd | Binary::BitOr | Binary::BitXor, a, b) => {
                self.is_boolean(a) && self.is_boolean(b)
            }
            Tree::Binary(operator, ..) => matches!(
                operator,
                Binary::And | Binary::Or | Binary::Eq | Binary::Ne | Binary::Lt | Binary::Le | Binary::Gt | Binary::Ge
            ),
            Tree::Int(_) | Tree::Opaque { .. } => false,
        }
    }
}

/// Whether the expression looks at nothing but which steps are active.
fn is_of_steps(tree: &Tree) -> bool {
    match tree {
        Tree::Bool(_) | Tree::Read(Read::Active(_) | Read::MacroActive(_)) => true,
        Tree::Unary(Unary::Not, inner) => is_of_steps(inner),
        Tree::Binary(operator, a, b) => {
            let boolean = matches!(
                operator,
                Binary::And | Binary::Or | Binary::BitAnd | Binary::BitOr | Binary::BitXor | Binary::Eq | Binary::Ne
            );
            boolean && is_of_steps(a) && is_of_steps(b)
        }
        _ => false,
    }
}

/// One of these holds. Halves, so that a long list lies not deep.
fn any(mut all: Vec<Formula>) -> Formula {
    if all.len() < 2 {
        return all.pop().unwrap_or(Formula::Const(false));
    }
    let rest = all.split_off(all.len() / 2);
    any(all).or(any(rest))
}

fn var_is_continuous(model: &Model, id: VarId) -> bool {
    combinational::asserted(model, id).next().is_some()
}

fn output_is_continuous(model: &Model, id: OutputId) -> bool {
    let mut of_place =
        model.associations.values().filter(|a| a.effect.continuous_value(Place::Output(id)).is_some()).peekable();
    matches!(model.outputs[id].ty, Ty::Bool(_))
        && of_place.peek().is_some()
        && of_place.all(|association| association.qualifier.is_continuous())
}

/// Whether actions that are not followed can change the value within a cycle.
fn is_volatile(tree: &Tree) -> bool {
    let volatile = |read: &Read| matches!(read, Read::Name(Name::Var(_) | Name::Output(_)));
    match tree {
        Tree::Read(read) => volatile(read),
        Tree::Unary(_, inner) => is_volatile(inner),
        Tree::Binary(_, a, b) => is_volatile(a) || is_volatile(b),
        Tree::Opaque { reads, call, .. } => call.is_some() || reads.iter().any(volatile),
        Tree::Bool(_) | Tree::Int(_) | Tree::Elapsed(..) | Tree::MacroElapsed(..) => false,
    }
}
