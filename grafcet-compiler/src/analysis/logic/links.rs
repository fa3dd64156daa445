//! What atoms have to do with each other: the facts that every valuation obeys.

use std::rc::Rc;

use super::Concurrency;
use super::atoms::{Atoms, Key};
use super::formula::{AtomId, Formula};
use super::read::{Reader, is_constant};
use crate::list::{List, PushAll};
use crate::model::{DelayId, MacroId, Model, Name, PartialId, Read, StepId, TimeRef, Tree};
use crate::sorted::{Map, Set};

/// Step variables of one question that are related to each other pair by pair.
const STEPS: usize = 32;

/// A fact about one atom.
#[derive(Clone)]
pub(super) struct Link {
    pub(super) formula: Rc<Formula>,
    /// It holds in the conditions of actions, too: there `T` and the edges of step variables are about the step before
    /// the evolution (A34).
    pub(super) in_actions: bool,
}

/// What holds of the atoms of a question.
pub(super) struct Fact {
    pub(super) formula: Rc<Formula>,
    pub(super) is_assumed: bool,
}

/// The facts about single atoms, found once each, and the assumptions by atom.
#[derive(Default)]
pub(super) struct Links {
    own: Map<AtomId, Vec<Link>>,
    assumed: Map<AtomId, Vec<Rc<Formula>>>,
    /// The assumptions that compare a value, in this cycle or in the one before.
    compared: Map<(Tree, bool), Vec<Rc<Formula>>>,
}

impl Links {
    /// Valuations in which `formula`, which is about inputs, holds do not count: neither in this cycle nor in the one
    /// before, with which edges compare.
    pub(super) fn assume_never(&mut self, formula: &Formula, atoms: &mut Atoms) {
        self.assume(formula.clone().not(), atoms);
        self.assume(formula.of_others(&mut |atom| atoms.before(atom)).not(), atoms);
    }

    fn assume(&mut self, formula: Formula, of: &Atoms) {
        let formula = Rc::new(formula);
        let mut atoms = Set::new();
        formula.each_atom(&mut |atom| _ = atoms.insert(atom));
        for atom in atoms {
            self.assumed.or_default(atom).push(Rc::clone(&formula));
            for value in of.compared(atom) {
                self.compared.or_default(value).push(Rc::clone(&formula));
            }
        }
    }

    pub(super) fn has_assumptions(&self) -> bool {
        !self.assumed.is_empty()
    }

    /// All facts about the atoms, and about those that these facts bring in.
    pub(super) fn about(
        &mut self,
        model: &Model,
        concurrency: Option<&Concurrency>,
        atoms: &mut Atoms,
        asked: &mut Set<AtomId>,
        in_action: bool,
    ) -> Vec<Fact> {
        let mut found: Vec<Fact> = Vec::new();
        let mut work: Vec<AtomId> = asked.iter().copied().list();
        while let Some(atom) = work.pop() {
            let assuming = self.has_assumptions();
            let own = self.own.or_insert_with(atom, || {
                let mut links = own(model, atoms, atom);
                links.push_all(before(model, atoms, atom, assuming));
                links
            });
            let own = own.iter().filter(|link| link.in_actions || !in_action).map(|link| (&link.formula, false));
            let values = if assuming { atoms.compared(atom) } else { Vec::new() };
            let compared = values.iter().filter_map(|value| self.compared.get(value)).flatten();
            let assumed = self.assumed.get(&atom).into_iter().flatten().and(compared).map(|formula| (formula, true));
            for (formula, is_assumed) in own.and(assumed) {
                if found.iter().any(|known| Rc::ptr_eq(&known.formula, formula)) {
                    continue;
                }
                formula.each_atom(&mut |atom| {
                    if asked.insert(atom) {
                        work.push(atom);
                    }
                });
                found.push(Fact { formula: Rc::clone(formula), is_assumed });
            }
        }
        let between = steps(model, concurrency, atoms, asked).into_iter().and(delays(model, atoms, asked));
        found.push_all(between.map(|formula| Fact { formula: Rc::new(formula), is_assumed: false }));
        found
    }
}

/// The facts about one atom.
fn own(model: &Model, atoms: &mut Atoms, atom: AtomId) -> Vec<Link> {
    let Some(key) = atoms.get(atom).map(|atom| atom.key.clone()) else { return Vec::new() };
    let mut reader = Reader { model, atoms };
    let link = |formula: Formula, in_actions: bool| vec![Link { formula: Rc::new(formula), in_actions }];
    match key {
        // On a rising edge of `e`, `e` is true; on a falling one it is false.
        Key::Boolean(Tree::Read(Read::Rising(id))) => {
            let of = &model.edges[id].of.tree;
            link(Formula::is_true(atom).implies(reader.formula(of)), is_constant(of))
        }
        Key::Boolean(Tree::Read(Read::Falling(id))) => {
            let of = &model.edges[id].of.tree;
            link(Formula::is_true(atom).implies(reader.formula(of).not()), is_constant(of))
        }
        // `t/e` ends with `e`.
        Key::Boolean(Tree::Read(Read::Delay(id))) => {
            let delay = &model.delays[id];
            if delay.off == TimeRef::Ticks(0) && is_constant(&delay.of.tree) {
                return link(Formula::is_true(atom).implies(reader.formula(&delay.of.tree)), true);
            }
            Vec::new()
        }
        // The time of a step that is not active is zero.
        Key::Number(Tree::Read(Read::Since(step))) => {
            let zero = Formula::Leaf { atom, low: 0, high: 0 };
            link(reader.read(Read::Active(step)).or(zero), false)
        }
        Key::Number(Tree::Read(Read::MacroSince(id))) => {
            let zero = Formula::Leaf { atom, low: 0, high: 0 };
            link(reader.read(Read::MacroActive(id)).or(zero), false)
        }
        Key::Order(a, b) => {
            let since = |tree: &Tree| match tree {
                Tree::Read(Read::Since(step)) => Some(Read::Active(*step)),
                Tree::Read(Read::MacroSince(id)) => Some(Read::MacroActive(*id)),
                _ => None,
            };
            let mut links = Vec::new();
            for tree in [&a, &b] {
                let Some(active) = since(tree) else { continue };
                let zero = Formula::Leaf { atom: reader.atoms.number(model, tree), low: 0, high: 0 };
                links.push_all(link(reader.read(active).or(zero), false));
            }
            links
        }
        _ => Vec::new(),
    }
}

/// On an edge of inputs, their values in the cycle before were others. Of a single one only assumptions say anything more.
fn before(model: &Model, atoms: &mut Atoms, atom: AtomId, assuming: bool) -> Option<Link> {
    let (id, rising) = match atoms.get(atom)?.key {
        Key::Boolean(Tree::Read(Read::Rising(id))) => (id, true),
        Key::Boolean(Tree::Read(Read::Falling(id))) => (id, false),
        _ => return None,
    };
    let of = &model.edges[id].of.tree;
    if !assuming && matches!(of, Tree::Read(_)) {
        return None;
    }
    let mut inputs = true;
    of.each_read(&mut |read| inputs &= matches!(read, Read::Name(Name::Input(_)) | Read::Ticks(_)));
    if !inputs {
        return None;
    }
    let of = Reader { model, atoms }.formula(of).of_others(&mut |atom| atoms.before(atom));
    let was = if rising { of.not() } else { of };
    Some(Link { formula: Rc::new(Formula::is_true(atom).implies(was)), in_actions: true })
}

/// A step variable, or that of a macro-step, and the steps of which one is active then.
struct Activity<'m> {
    atom: AtomId,
    steps: &'m [StepId],
}

/// Steps that are never active together, and partial grafcets in which one always is.
fn steps(model: &Model, concurrency: Option<&Concurrency>, atoms: &Atoms, asked: &Set<AtomId>) -> Vec<Formula> {
    let mut single: Vec<(AtomId, [StepId; 1])> = Vec::new();
    let mut macros: Vec<(AtomId, MacroId)> = Vec::new();
    for atom in asked {
        match atoms.get(*atom).map(|atom| &atom.key) {
            Some(Key::Boolean(Tree::Read(Read::Active(step)))) => single.push((*atom, [*step])),
            Some(Key::Boolean(Tree::Read(Read::MacroActive(id)))) => macros.push((*atom, *id)),
            _ => {}
        }
    }
    if single.len() + macros.len() < 2 || single.len() + macros.len() > STEPS {
        return Vec::new();
    }
    let single = single.iter().map(|(atom, steps)| Activity { atom: *atom, steps });
    let macros = macros.iter().map(|(atom, id)| Activity { atom: *atom, steps: &model.macros[*id].steps });
    let all: Vec<Activity<'_>> = single.and(macros).list();
    let mut found = Vec::new();
    for (i, a) in all.iter().enumerate() {
        for b in &all[i + 1..] {
            found.push_all(pair(model, concurrency, a, b));
        }
        if a.steps.len() > 1 {
            let inside: Vec<&Activity<'_>> = all.iter().filter(|b| b.atom != a.atom && is_inside(b, a)).list();
            if a.steps.iter().all(|step| inside.iter().any(|b| b.steps.contains(step))) {
                let any = inside.iter().map(|b| Formula::is_true(b.atom)).list();
                found.push(Formula::is_true(a.atom).implies(Formula::Any(any)));
            }
        }
    }
    let partials: Set<PartialId> =
        all.iter().filter_map(|a| a.steps.first()).map(|step| model.steps[*step].partial).collect();
    for partial in partials {
        let steps = &model.partials[partial].steps;
        let covered = steps.iter().all(|step| all.iter().any(|a| a.steps.contains(step)));
        if covered && is_never_empty(model, partial) {
            found.push(Formula::Any(all.iter().map(|a| Formula::is_true(a.atom)).list()));
        }
    }
    found
}

fn is_inside(inner: &Activity<'_>, outer: &Activity<'_>) -> bool {
    inner.steps.iter().all(|step| outer.steps.contains(step))
}

/// How two step variables are related.
fn pair(model: &Model, concurrency: Option<&Concurrency>, a: &Activity<'_>, b: &Activity<'_>) -> Option<Formula> {
    if a.steps.len() * b.steps.len() > 1000 {
        return None;
    }
    let (first, second) = (Formula::is_true(a.atom), Formula::is_true(b.atom));
    if is_inside(a, b) {
        return Some(first.implies(second));
    }
    if is_inside(b, a) {
        return Some(second.implies(first));
    }
    if let ([inner], [outer]) = (a.steps, b.steps) {
        if is_enclosed(model, *inner, *outer) {
            return Some(first.implies(second));
        }
        if is_enclosed(model, *outer, *inner) {
            return Some(second.implies(first));
        }
    }
    let concurrency = concurrency?;
    // Of a step that is never active nothing follows: that is a mistake of its own.
    let meet = |x: &StepId, y: &StepId| {
        x == y || !concurrency.reachable(*x) || !concurrency.reachable(*y) || concurrency.together(*x, *y)
    };
    let never_meet = !a.steps.iter().any(|x| b.steps.iter().any(|y| meet(x, y)));
    never_meet.then(|| first.and(second).not())
}

/// Whether `inner` sits, at any depth, in an enclosure of `outer`.
fn is_enclosed(model: &Model, inner: StepId, outer: StepId) -> bool {
    let mut at = inner;
    // A circle of enclosures is refused elsewhere.
    for _ in 0..model.partials.len() {
        match model.partials[model.steps[at].partial].enclosed_by {
            Some(around) if around == outer => return true,
            Some(around) => at = around,
            None => return false,
        }
    }
    false
}

/// Whether at least one step of a partial grafcet is active at any time.
fn is_never_empty(model: &Model, id: PartialId) -> bool {
    let partial = &model.partials[id];
    partial.enclosed_by.is_none()
        && partial.steps.iter().any(|step| model.steps[*step].initial)
        && partial.transitions.iter().all(|transition| !model.transitions[*transition].targets.is_empty())
        && partial.forced_by.is_empty()
}

/// Of two delays of one expression the longer one comes later, and both end with it.
fn delays(model: &Model, atoms: &Atoms, asked: &Set<AtomId>) -> Vec<Formula> {
    let delays: Vec<(AtomId, DelayId)> = asked
        .iter()
        .filter_map(|atom| match atoms.get(*atom)?.key {
            Key::Boolean(Tree::Read(Read::Delay(id))) => Some((*atom, id)),
            _ => None,
        })
        .take(STEPS)
        .list();
    let mut found = Vec::new();
    for (long, a) in &delays {
        for (short, b) in &delays {
            let (a, b) = (&model.delays[*a], &model.delays[*b]);
            let zero = TimeRef::Ticks(0);
            let longer = matches!((a.on, b.on), (TimeRef::Ticks(a), TimeRef::Ticks(b)) if a > b);
            if longer && a.off == zero && b.off == zero && a.of.tree == b.of.tree {
                found.push(Formula::is_true(*long).implies(Formula::is_true(*short)));
            }
        }
    }
    found
}
