//! What is dead and of which nobody has said anything yet.
//!
//! The other rules leave out what follows from something else. Here it is made sure that this something was said: what is dead
//! is explained by a transition or a step of which something was said, step by step backwards. What is not explained so, as where
//! two things wait for each other, is said.

use super::reach;
use crate::analysis::explore::Exploration;
use crate::analysis::{Dead, Explained};
use crate::diagnostic::{Mark, Sink, rules};
use crate::model::{Model, TransitionId};

/// Says what is dead and not explained, one cause after the other.
pub(super) fn check(model: &Model, exploration: &Exploration, dead: &Dead<'_>, mut told: Explained, sink: &mut Sink) {
    loop {
        dead.explain(&mut told);
        if let Some(id) = dead.cause(&told) {
            reach::dead_transition(model, exploration, id, sink);
            // What leaves every step is one arrow to its author.
            let any = model.transitions[id].any;
            let same = |other: &&TransitionId| any.is_some() && model.transitions[**other].any == any;
            told.transitions.extend(dead.idle.iter().filter(same));
            told.transitions.insert(id);
        } else if let Some(id) = dead.lost.iter().find(|step| !told.steps.contains(step)) {
            let step = &model.steps[*id];
            let message = format!("step `{}` is never active: nothing that leads to it ever happens", step.name);
            sink.rule(&rules::UNREACHABLE_STEP, &model.levels_of(step), vec![(Mark::from(&step.name), message)]);
            told.steps.insert(*id);
        } else {
            return;
        }
    }
}
