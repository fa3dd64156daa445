//! `modes;`, A39: read from what the chart says, not from the conditions that the compiler made of it.
//!
//! "Paused: nothing that is held clears. By hand: the push button clears what is enabled, of transitions that leave a step together the first in the source;
//! what is written in the brackets is not asked. Semi-automatic: what is written in the brackets and the push button. Else what is written in the brackets."

use super::any;
use super::value::Error;
use super::view::View;
use grafcet_compiler::model::{InputId, Model, Modes, Name, Read, TransitionId, Tree};

/// How a chart that says `modes;` is run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Mode {
    /// As if nothing were said.
    Automatic,
    /// A transition needs its condition and the push button.
    SemiAutomatic {
        /// The button has just gone down.
        pushed: bool,
    },
    /// The push button alone clears.
    Manual {
        /// The button has just gone down.
        pushed: bool,
    },
    /// Nothing clears.
    Paused,
}

pub(super) fn mode(modes: &Modes, view: &View<'_>) -> Result<Mode, Error> {
    let is = |input: InputId| view.holds(&Tree::Read(Read::Name(Name::Input(input))));
    let pushed = view.holds(&Tree::Read(Read::Rising(modes.pushed)))?;
    Ok(match (is(modes.paused)?, is(modes.manual)?, is(modes.semi_automatic)?) {
        (true, ..) => Mode::Paused,
        (false, true, _) => Mode::Manual { pushed },
        (false, false, true) => Mode::SemiAutomatic { pushed },
        (false, false, false) => Mode::Automatic,
    })
}

/// Whether a transition may clear as far as its condition and the mode are concerned.
pub(super) fn holds(id: TransitionId, view: &View<'_>) -> Result<bool, Error> {
    let model = view.model;
    let (Some(inputs), Some(written)) = (&model.modes, &model.transitions[id].held) else {
        return view.holds(any::condition(id, model));
    };
    match mode(inputs, view)? {
        Mode::Paused | Mode::Manual { pushed: false } | Mode::SemiAutomatic { pushed: false } => Ok(false),
        Mode::Manual { pushed: true } => Ok(is_first(id, view)),
        Mode::SemiAutomatic { pushed: true } | Mode::Automatic => view.holds(written),
    }
}

/// Whether a transition's own condition decides about it now.
pub(super) fn asks(id: TransitionId, view: &View<'_>) -> bool {
    let model = view.model;
    let (Some(inputs), Some(_)) = (&model.modes, &model.transitions[id].held) else { return true };
    matches!(mode(inputs, view), Ok(Mode::Automatic | Mode::SemiAutomatic { pushed: true }))
}

/// Whether no earlier transition that is held and shares a step with this one is enabled. What an `sfc` adds by priority is its own matter: there an earlier one
/// that does not clear itself is in nobody's way.
fn is_first(id: TransitionId, view: &View<'_>) -> bool {
    !view.model.is_grafcet() || goes_before(id, view).is_none()
}

/// The transition that clears by hand in place of this one.
pub(super) fn goes_before(id: TransitionId, view: &View<'_>) -> Option<TransitionId> {
    let model = view.model;
    let before = model.transitions.iter().filter(|(other, _)| *other < id);
    let mut rivals = before.filter(|(other, transition)| transition.held.is_some() && shares(*other, id, model));
    let all_active =
        |other: TransitionId| model.transitions[other].sources.iter().all(|step| view.situation.contains(step));
    rivals.find(|(other, _)| all_active(*other)).map(|(other, _)| other)
}

fn shares(one: TransitionId, other: TransitionId, model: &Model) -> bool {
    model.transitions[one].sources.iter().any(|step| model.transitions[other].sources.contains(step))
}
