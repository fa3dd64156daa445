//! The cycle of `sfc`: one evolution, then the actions.

use super::{Done, evolve, note_doubled, tried};
use crate::analysis::explore::net::actions::{Action, Command, Target, TargetId, Timed};
use crate::analysis::explore::net::formula::Formula;
use crate::analysis::explore::net::slots::{Bit, SlotId};
use crate::analysis::explore::valuation::{State, Valuation, When};
use crate::list::{List, PushAll};
use crate::model::{Dialect, Id, Qualifier, StepId, TransitionId, Trigger};
use crate::sorted::{sort_by_key, sort_unstable};

/// How the evolution changed the situation.
struct Change {
    left: Vec<StepId>,
    entered: Vec<StepId>,
    before: Vec<StepId>,
}

/// A29: where in the cycle an action runs.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Moment {
    Leaving,
    Entering,
    Rest,
}

/// What an action does to the followed values.
#[derive(Clone)]
enum Effect<'n> {
    Put(SlotId, Bit),
    Run(&'n [Command]),
}

pub(crate) fn cycle(valuation: &mut Valuation<'_>, state: &State, enabled: &[TransitionId], done: &mut Done) -> When {
    let net = valuation.net;
    let (mut left, mut targets): (Vec<StepId>, Vec<StepId>) = (Vec::new(), Vec::new());
    if !state.first {
        for transition in tried(valuation, enabled) {
            let arc = &net.arcs[transition];
            // A28: a step is left by the first transition in the source.
            let free = arc.sources.iter().all(|source| !left.contains(source));
            if free && valuation.decide(&arc.condition, When::Now) {
                done.able.push(transition);
                done.cleared.push(transition);
                left.extend(&arc.sources);
                targets.extend(&arc.targets);
            }
        }
        let cleared = done.cleared.clone();
        note_doubled(net, &state.active, &left, &cleared, done);
    }
    let stayed: Vec<StepId> = state.active.iter().filter(|step| !left.contains(step)).copied().list();
    let entered: Vec<StepId> = if state.first {
        state.active.to_vec()
    } else {
        targets.iter().filter(|step| !stayed.contains(step)).copied().list()
    };
    let after = evolve(&state.active, &left, &targets);
    valuation.start = Some(valuation.now.clone());
    valuation.now.active = after;
    valuation.just_entered.extend(&entered);
    if net.actions.is_empty() {
        // Nothing reads the situation before the evolution any more but edges, which look at the sample.
        return When::Sample;
    }
    valuation.forget_volatile();
    let before = if state.first { Vec::new() } else { state.active.to_vec() };
    act(valuation, &Change { left, entered, before });
    When::Sample
}

/// Rules 4 and 5: every action control, then the actions in their order.
fn act(valuation: &mut Valuation<'_>, change: &Change) {
    let net = valuation.net;
    let steps = change.before.iter().and(&valuation.now.active);
    let mut numbers: Vec<TargetId> =
        steps.filter_map(|step| net.actions.targets_of.get(step)).flatten().copied().list();
    let lasting = net.actions.lasting.iter().filter(|(slot, _)| valuation.now.slots[slot.index()] != Bit::False);
    numbers.push_all(lasting.map(|(_, target)| *target));
    sort_unstable(&mut numbers);
    numbers.dedup();
    let mut runs: Vec<(Moment, usize, Effect<'_>)> = Vec::new();
    for number in numbers {
        match &net.actions.targets[number] {
            Target::Control { slot, timed, by } => {
                let q = control(valuation, change, (*slot, timed), by);
                runs.push((Moment::Rest, by[0].position, Effect::Put(*slot, q)));
            }
            Target::Assigned { slot, initial, by } => {
                let active = by.iter().rfind(|action| is_on(valuation, change, action));
                let effect = match active {
                    Some(action) => Effect::Run(&action.program),
                    None => Effect::Put(*slot, *initial),
                };
                runs.push((Moment::Rest, by[0].position, effect));
            }
            Target::Own(action) => {
                use Qualifier::{D, Ds, L, N, On, P, P0, P1, R, S, Sd, Sl};
                let on = is_on(valuation, change, action);
                let moment = match action.qualifier {
                    P0 if on => Moment::Leaving,
                    P1 if on => Moment::Entering,
                    N if on => Moment::Rest,
                    // The final scan.
                    N if action.is_of(&change.before) => Moment::Leaving,
                    // What runs under others is not followed.
                    N | P1 | P0 | S | R | L | D | P | Sd | Ds | Sl | On => continue,
                };
                runs.push((moment, action.position, Effect::Run(&action.program)));
            }
        }
    }
    sort_by_key(&mut runs, |(moment, position, _)| (*moment, *position));
    // Outputs are read as the previous cycle returned them.
    let mut outputs: Vec<(SlotId, Bit)> = Vec::new();
    for (_, _, effect) in runs {
        match effect {
            Effect::Put(slot, bit) => write(valuation, slot, bit, &mut outputs),
            Effect::Run(program) => {
                valuation.own.clear();
                perform(valuation, program);
                let written = std::mem::take(&mut valuation.own);
                for (slot, bit) in written {
                    write(valuation, slot, bit, &mut outputs);
                }
            }
        }
    }
    for (slot, bit) in outputs {
        valuation.now.slots[slot.index()] = bit;
    }
}

fn write(valuation: &mut Valuation<'_>, slot: SlotId, bit: Bit, outputs: &mut Vec<(SlotId, Bit)>) {
    if valuation.net.actions.is_output[slot] {
        outputs.push((slot, bit));
    } else {
        valuation.now.slots[slot.index()] = bit;
    }
}

/// `Q = !R && (N || S_FF || (L && !L_TMR) || D_TMR || P || SD_TMR || DS_FF || (SL_FF && !SL_TMR))`, with unknown times.
fn control(valuation: &mut Valuation<'_>, change: &Change, (slot, timed): (SlotId, &Timed), by: &[Action]) -> Bit {
    let mut on: Vec<Qualifier> = Vec::new();
    for action in by {
        if !on.contains(&action.qualifier) && is_on(valuation, change, action) {
            on.push(action.qualifier);
        }
    }
    let reset = on.contains(&Qualifier::R);
    if by.iter().all(|action| action.qualifier.sets_or_resets()) {
        return kept(valuation.now.slots[slot.index()], on.contains(&Qualifier::S), reset);
    }
    let mut q = Bit::from(on.iter().any(|qualifier| qualifier.drives_q_at_once()));
    for (qualifier, flip_flop) in &timed.flip_flops {
        let set =
            on.contains(qualifier) && (!qualifier.stores_when_time_is_over() || has_come(valuation, timed, *qualifier));
        let stays = kept(valuation.now.slots[flip_flop.index()], set, reset);
        valuation.now.slots[flip_flop.index()] = stays;
        let late = qualifier.times_its_flip_flop();
        if stays != Bit::False && (!late || has_come(valuation, timed, *qualifier)) && q != Bit::True {
            q = stays;
        }
    }
    let timed_alone = |qualifier: &Qualifier| qualifier.shows_with_its_step() && qualifier.has_time();
    for qualifier in Qualifier::ALL.into_iter().filter(timed_alone) {
        if on.contains(&qualifier) && has_come(valuation, timed, qualifier) {
            q = Bit::True;
        }
    }
    if reset { Bit::False } else { q }
}

/// RS, where R dominates.
fn kept(was: Bit, set: bool, reset: bool) -> Bit {
    match (reset, set) {
        (true, _) => Bit::False,
        (false, true) => Bit::True,
        (false, false) => was,
    }
}

fn has_come(valuation: &mut Valuation<'_>, timed: &Timed, qualifier: Qualifier) -> bool {
    timed.times.iter().any(|(of, time)| *of == qualifier && valuation.decide(time, When::Now))
}

/// Whether the step flag or the event of an association is true, and its condition.
fn is_on(valuation: &mut Valuation<'_>, change: &Change, action: &Action) -> bool {
    let steps = match action.qualifier.trigger(Dialect::Sfc) {
        Trigger::Activation => &change.entered,
        Trigger::Deactivation => &change.left,
        Trigger::Active | Trigger::Event => &valuation.now.active,
    };
    action.is_of(steps) && action.condition.as_ref().is_none_or(|condition| evaluate(valuation, condition))
}

fn evaluate(valuation: &mut Valuation<'_>, formula: &Formula) -> bool {
    // An action that depends on anything may depend on what stands still in this run.
    valuation.spoilt |= valuation.is_waited() && !matches!(formula, Formula::Const(_));
    valuation.decide(formula, When::Now)
}

/// Runs a program; what it writes stands in `valuation.own`.
pub(crate) fn perform(valuation: &mut Valuation<'_>, program: &[Command]) {
    for command in program {
        match command {
            Command::Set(slot, value) => {
                let value = evaluate(valuation, value);
                valuation.own.push((*slot, Bit::from(value)));
            }
            Command::If(condition, then, otherwise) => {
                let branch = if evaluate(valuation, condition) { then } else { otherwise };
                perform(valuation, branch);
            }
        }
    }
}
