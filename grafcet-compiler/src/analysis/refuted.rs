//! Alarms of a `grafcet` that need values: what the exploration does not follow from cycle to cycle, a prover may exclude.

use super::{Change, Facts, Meet, Prover, Question, Races, Ruling, Writer};
use crate::list::List;
use crate::model::{Dialect, Model, Name, Place, Read, Trigger, Ty};
use crate::sorted::Set;

/// Whoever is asked, and what it needs.
pub(crate) type Asked<'a, 'm> = Option<(&'a Prover, &'a Facts<'m>)>;

/// With more races than these nobody is asked: that would take too long, and a chart with so many has others to mend first.
const MOST: usize = 8;

/// The races of which it is not proved that they never happen.
pub(crate) fn left(model: &Model, races: &Races, mixed: &Set<Place>, asked: Asked<'_, '_>) -> Races {
    let all = races.all.clone();
    let Some((prover, facts)) = asked.filter(|_| model.is_grafcet() && needs_values(model)) else {
        return Races { all };
    };
    let question = |meet: &Meet| {
        let (first, second) = (change(model, meet.first)?, change(model, meet.second)?);
        // Both act when the chart begins, which is no evolution.
        let starts = |change: Change| matches!(change, Change::Activates(step) if model.steps[step].initial || model.steps[step].linked);
        (!(starts(first) && starts(second))).then_some(Question::Apart(first, second))
    };
    let questions: Vec<Option<Question>> =
        all.iter().map(|meet| question(meet).filter(|_| !mixed.contains(&meet.place))).list();
    let some = questions.iter().flatten().copied().list();
    if some.is_empty() || some.len() > MOST {
        return Races { all };
    }
    let answers = prover(model, facts, &some);
    let never_meet = |question: &Question| {
        some.iter().zip(&answers).any(|(other, answer)| other == question && *answer == Ruling::Holds)
    };
    let left = all.into_iter().zip(questions).filter(|(_, question)| !question.as_ref().is_some_and(never_meet));
    Races { all: left.map(|(meet, _)| meet).list() }
}

/// Whether it is proved that every search ends.
pub(crate) fn settles(model: &Model, asked: Asked<'_, '_>) -> bool {
    let Some((prover, facts)) = asked.filter(|_| needs_values(model)) else { return false };
    prover(model, facts, &[Question::Settles]) == [Ruling::Holds]
}

/// When it writes; none for what does so by an event.
fn change(model: &Model, writer: Writer) -> Option<Change> {
    match writer {
        Writer::Clearing(id) => Some(Change::Clears(id)),
        Writer::Action(id) => {
            let association = &model.associations[id];
            match association.qualifier.trigger(Dialect::Grafcet) {
                Trigger::Deactivation => Some(Change::Deactivates(association.step)),
                Trigger::Activation | Trigger::Active => Some(Change::Activates(association.step)),
                Trigger::Event => None,
            }
        }
    }
}

/// Whether a transition waits for what only a solver follows: a stored value that is no boolean, or a time.
fn needs_values(model: &Model) -> bool {
    let is_stored = |name: Name| matches!(name, Name::Output(_) | Name::Var(_));
    let is_value = |read: &Read| match *read {
        Read::Name(name) => is_stored(name) && !matches!(model.ty(name), Ty::Bool(_)),
        Read::Since(_) | Read::MacroSince(_) | Read::Elapsed(..) | Read::MacroElapsed(..) | Read::Delay(_) => true,
        _ => false,
    };
    model.transitions.values().any(|transition| transition.condition.reads.iter().any(is_value))
}
