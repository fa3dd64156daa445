//! `vacuous_property`, `vacuous_assumption`: what holds only because nothing happens, and what nothing follows from.

use crate::analysis::explore::Answer;
use crate::analysis::{Claims, Logic, Question, Ruling, Rulings};
use crate::diagnostic::{Mark, Sink, rules};
use crate::list::List;
use crate::model::{Claim, Expr, Model, Order, Property, Read};

/// Reports what the conditions alone, the search and the prover show.
pub(super) fn check(model: &Model, claims: &Claims<'_>, told: &Rulings<'_>, sink: &mut Sink) {
    if told.is_so(Question::NoCycle) {
        // Where the conditions alone tell that, it is an error.
        let message = "these assumptions exclude every cycle, so that every property holds; correct one of them";
        let marks = model.assumptions.iter().map(|assumption| assumption.mark);
        let marks = marks.chain(model.orders.iter().map(|order| order.mark));
        let notes = marks.map(|mark| (mark, message.to_owned())).list();
        return sink.rule(&rules::VACUOUS_ASSUMPTION, &[&model.levels], notes);
    }
    orders(model, told, sink);
    if !model.assumptions.is_empty() || !model.often.is_empty() {
        assumptions(model, told, sink);
    }
    for (property, answer) in &claims.triggers {
        let never = match answer {
            Answer::Never => true,
            Answer::Possible(_) => false,
            Answer::Unknown(_) => told.never_happens(property),
        };
        if never && !told_already(claims, property, sink) {
            never_happens(model, property, sink);
        }
    }
}

/// What a prover is asked of a chart with its plants, beside the properties with these numbers.
pub(super) fn questions(model: &Model, properties: &[usize]) -> Vec<Question> {
    let mut all = Question::of_assumptions(model);
    for number in properties {
        if model.properties[*number].claim.trigger().is_some() {
            all.push(Question::NeverHappens(*number));
        }
    }
    all
}

/// The same of a chart with its plants, as far as the prover tells.
pub(super) fn with_plants(model: &Model, asked: &[Question], rulings: &[Ruling], sink: &mut Sink) {
    for (question, _) in asked.iter().zip(rulings).filter(|(_, ruling)| **ruling == Ruling::Holds) {
        match *question {
            Question::NoCycle => {
                let message = "with what is assumed here and by the plants no cycle comes to its end, so that every property                                holds; correct the assumptions";
                let name: Mark = (&model.name).into();
                return assumed(model, name, message.to_owned(), sink);
            }
            Question::StandsStill(number) => {
                let name = &model.plants.list[number].model.name;
                let message = format!(
                    "the plant `{name}` stays where it begins, whatever the chart does, so what is proved says nothing of it; look                      at what its transitions wait for"
                );
                assumed(model, name.into(), message, sink);
            }
            Question::NeverComes(number) => never_comes(model, &model.often[number], sink),
            Question::SaysNothing(number) => excludes_nothing(model, &model.orders[number], sink),
            Question::NeverHappens(number) => never_happens(model, &model.properties[number], sink),
            _ => {}
        }
    }
}

/// What nothing leads to, or comes before.
fn orders(model: &Model, told: &Rulings<'_>, sink: &mut Sink) {
    for (number, order) in model.orders.iter().enumerate() {
        if told.is_so(Question::SaysNothing(number)) {
            excludes_nothing(model, order, sink);
        }
    }
}

fn excludes_nothing(model: &Model, order: &Order, sink: &mut Sink) {
    let Some(trigger) = order.claim.trigger() else { return };
    let message = format!(
        "`{}` holds at the end of no cycle, so this assumption excludes nothing; correct it, or leave it out",
        trigger.text
    );
    assumed(model, order.mark, message, sink);
}

/// What excludes nothing, and what never comes or always does.
fn assumptions(model: &Model, told: &Rulings<'_>, sink: &mut Sink) {
    let alone = Logic::new(model);
    for assumption in model.assumptions.iter().filter(|assumption| assumption.of_range.is_none()) {
        let never = &assumption.never;
        if alone.never(&alone.condition(&never.tree)) {
            let message = format!(
                "`{}` never holds, so this assumption excludes nothing; correct it, or leave it out",
                never.text
            );
            assumed(model, assumption.mark, message, sink);
        }
    }
    let never = model.assumptions.iter().map(|assumption| &assumption.never.tree).list();
    let logic = Logic::assuming(model, &never);
    for (number, often) in model.often.iter().enumerate() {
        let condition = logic.condition(&often.tree);
        if logic.never(&condition) || told.is_so(Question::NeverComes(number)) {
            never_comes(model, often, sink);
        } else if logic.always(&condition) {
            let message =
                format!("`{}` always holds, so nothing follows from this assumption; leave it out", often.text);
            assumed(model, often.mark, message, sink);
        }
    }
}

fn never_comes(model: &Model, often: &Expr, sink: &mut Sink) {
    let message = format!(
        "`{}` never holds, so it cannot come again and again, and under this assumption every `leads_to` would hold; \
         correct it",
        often.text
    );
    assumed(model, often.mark, message, sink);
}

/// It is about a step of which an error tells that it is never active.
fn told_already(claims: &Claims<'_>, property: &Property, sink: &Sink) -> bool {
    let lost = |read: &Read| matches!(read, Read::Active(step) if !claims.exploration.reachable(*step));
    sink.has_dead_ends() && property.claim.trigger().is_some_and(|trigger| trigger.reads.iter().any(lost))
}

fn never_happens(model: &Model, property: &Property, sink: &mut Sink) {
    let Some(trigger) = property.claim.trigger() else { return };
    let nothing = match &property.claim {
        Claim::Before { .. } => "nothing has to come before it",
        _ => "nothing follows from it",
    };
    let message = format!(
        "`{}` holds at the end of no cycle: {nothing}, so this property says nothing; correct it, or leave it out",
        trigger.text
    );
    sink.rule(&rules::VACUOUS_PROPERTY, &[&property.levels, &model.levels], vec![(trigger.mark, message)]);
}

fn assumed(model: &Model, mark: Mark, message: String, sink: &mut Sink) {
    sink.rule(&rules::VACUOUS_ASSUMPTION, &[&model.levels], vec![(mark, message)]);
}
