//! `next_deadline`: "the reading of the clock before which nothing changes unless an input does".

use super::Lower;
use crate::model::{Binary, Blinker, Effect, Expr as Written, Id, Name, Qualifier, Read, TimeRef, Tree};
use crate::program::build::{add, all, any, below, choose, compare, not, sub, ticks};
use crate::program::{Comparison, Deadline, Expr, PlaceId, Value};
use crate::sorted::Set;

/// At which times of a step or macro-step something changes.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Change {
    /// At the time itself.
    At(TimeRef),
    /// One tick after it.
    Behind(TimeRef),
    /// At the ends of both parts of a period.
    Blink(u32, u32),
    /// At every tick: the time is used in another way than in a comparison.
    Always,
}

type Changes = Set<(Blinker, Change)>;

impl<'m> Lower<'_, 'm> {
    /// Of a chart that uses time.
    pub(super) fn deadline(&self) -> Option<Deadline<'m>> {
        let settled = self.settled?;
        let mut waits = Vec::new();
        for (of, change) in self.changes() {
            self.wait(of, change, &mut waits);
        }
        for id in self.model.delays.ids() {
            let (delay, places) = (&self.model.delays[id], self.delay(id));
            let differ = compare(Comparison::Differs, Expr::Place(places.input), Expr::Place(places.output));
            let time = choose(Expr::Place(places.input), self.time_of(delay.on), self.time_of(delay.off));
            waits.push((differ, sub(time, Expr::Place(places.held))));
        }
        for (input, held, time) in &self.timers {
            let waiting = all(vec![Expr::Place(*input), below(Expr::Place(*held), time.clone())]);
            waits.push((waiting, sub(time.clone(), Expr::Place(*held))));
        }
        let mut at_once = self.restless();
        at_once.insert(0, not(Expr::Place(settled)));
        Some(Deadline { at_once: any(at_once), waits })
    }

    /// Where each cycle asks for a call that may have another value each time.
    fn restless(&self) -> Vec<Expr<'m>> {
        let model = self.model;
        let mut found = Vec::new();
        for transition in model.transitions.values() {
            if transition.condition.tree.may_differ() {
                found.push(all(transition.sources.iter().map(|step| self.is(*step)).collect()));
            }
        }
        for association in model.associations.values() {
            let mut asked: Vec<&Written> = association.condition.iter().chain(&association.event).collect();
            if association.qualifier == Qualifier::N {
                asked.extend(association.effect.expressions());
            }
            if asked.iter().any(|expr| expr.tree.may_differ()) {
                found.push(self.is(association.step));
            }
        }
        // Edges and delays are sampled in every cycle.
        let sampled = model.edges.values().map(|edge| &edge.of).chain(model.delays.values().map(|delay| &delay.of));
        for of in sampled {
            if of.tree.may_differ() {
                found.push(Expr::Value(Value::Bool(true)));
            }
        }
        found
    }

    fn wait(&self, of: Blinker, change: Change, waits: &mut Vec<(Expr<'m>, Expr<'m>)>) {
        let (active, time) = match of {
            Blinker::Step(step) => (self.is(step), self.time[self.regions.of_step(step)]),
            Blinker::Macro(id) => {
                let steps = &self.model.macros[id].steps;
                (any(steps.iter().map(|step| self.is(*step)).collect()), self.macro_time[id.index()])
            }
        };
        let mut until = |time: PlaceId, end: Expr<'m>| {
            let waiting = all(vec![active.clone(), below(Expr::Place(time), end.clone())]);
            waits.push((waiting, sub(end, Expr::Place(time))));
        };
        match (change, time) {
            (Change::At(end), Some(time)) => until(time, self.time_of(end)),
            (Change::Behind(end), Some(time)) => until(time, add(self.time_of(end), ticks(1))),
            (Change::Always, _) => waits.push((active, ticks(1))),
            (Change::Blink(on, period), _) => {
                let role = self.phase_role(crate::model::Blink { of, on, off: period.saturating_sub(on) });
                let Some(phases) = self.phases.iter().find(|phases| phases.role == role) else { return };
                let phase = Expr::Place(phases.phase);
                let end = choose(below(phase.clone(), ticks(on)), ticks(on), ticks(period));
                waits.push((active, sub(end, phase)));
            }
            _ => {}
        }
    }

    /// Every time that an expression or a qualifier looks at.
    fn changes(&self) -> Changes {
        let mut found = Set::new();
        for transition in self.model.transitions.values() {
            of_tree(&transition.condition.tree, &mut found);
            transition.clearing.iter().for_each(|effect| of_effect(effect, &mut found));
        }
        for association in self.model.associations.values() {
            association.condition.iter().chain(&association.event).for_each(|one| of_tree(&one.tree, &mut found));
            of_effect(&association.effect, &mut found);
            let compared = self.model.is_grafcet() && matches!(association.qualifier, Qualifier::L | Qualifier::D);
            if let Some(time) = association.time.filter(|_| compared) {
                found.insert((Blinker::Step(association.step), Change::At(time)));
            }
        }
        self.model.edges.values().for_each(|edge| of_tree(&edge.of.tree, &mut found));
        self.model.delays.values().for_each(|delay| of_tree(&delay.of.tree, &mut found));
        found
    }
}

fn of_effect(effect: &Effect, found: &mut Changes) {
    let of_expr = |expr: &Written, found: &mut Changes| of_tree(&expr.tree, found);
    match effect {
        Effect::Control(_) => {}
        Effect::Assign(_, value) => of_expr(value, found),
        Effect::Call(_, args) => args.iter().for_each(|arg| of_expr(arg, found)),
        Effect::Block(code) => code.reads.iter().for_each(|read| of_read(*read, found)),
    }
}

fn of_tree(tree: &Tree, found: &mut Changes) {
    match tree {
        Tree::Binary(operator, a, b) => {
            if !comparison(*operator, a, b, found) && !comparison(mirrored(*operator), b, a, found) {
                of_tree(a, found);
                of_tree(b, found);
            }
        }
        Tree::Unary(_, inner) => of_tree(inner, found),
        other => other.each_read(&mut |read| of_read(read, found)),
    }
}

fn of_read(read: Read, found: &mut Changes) {
    let Some(of) = read.about() else { return };
    let change = match read {
        Read::Since(_) | Read::MacroSince(_) => Change::Always,
        Read::Elapsed(time, _) | Read::MacroElapsed(time, _) => Change::At(time),
        Read::Blink(blink) => Change::Blink(blink.on, blink.period()),
        _ => return,
    };
    found.insert((of, change));
}

/// `Step.T < 5s`: when its truth can change.
fn comparison(operator: Binary, a: &Tree, b: &Tree, found: &mut Changes) -> bool {
    let of = match a {
        Tree::Read(read @ (Read::Since(_) | Read::MacroSince(_))) => read.about(),
        _ => None,
    };
    let time = match b {
        Tree::Read(Read::Ticks(ticks)) => TimeRef::Ticks(*ticks),
        Tree::Read(Read::Name(Name::Param(id))) => TimeRef::Param(*id),
        Tree::Read(Read::Name(Name::Var(id))) => TimeRef::Var(*id),
        _ => return false,
    };
    let Some(of) = of else { return false };
    match operator {
        Binary::Lt | Binary::Ge => _ = found.insert((of, Change::At(time))),
        Binary::Gt | Binary::Le => _ = found.insert((of, Change::Behind(time))),
        Binary::Eq | Binary::Ne => {
            found.insert((of, Change::At(time)));
            found.insert((of, Change::Behind(time)));
        }
        _ => return false,
    }
    true
}

fn mirrored(operator: Binary) -> Binary {
    match operator {
        Binary::Lt => Binary::Gt,
        Binary::Le => Binary::Ge,
        Binary::Gt => Binary::Lt,
        Binary::Ge => Binary::Le,
        other => other,
    }
}
