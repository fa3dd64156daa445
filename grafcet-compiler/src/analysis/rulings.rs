//! What a prover says of what the exploration leaves open. It is asked once for a chart, as it looks at all of it.

use super::explore::Answer;
use super::{Claims, Facts, Prover, Question, Ruling};
use crate::list::{List, PushAll};
use crate::model::{Model, Property};

/// The questions and their answers.
pub(crate) struct Rulings<'m> {
    model: &'m Model,
    all: Vec<(Question, Ruling)>,
}

impl<'m> Rulings<'m> {
    /// None where there is no prover, or nothing to ask.
    pub(crate) fn of(model: &'m Model, claims: &Claims<'_>, prover: Option<&Prover>, facts: &Facts<'_>) -> Self {
        let questions = questions(model, claims);
        let asked = prover.filter(|_| !questions.is_empty());
        let rulings = asked.map(|prover| prover(model, facts, &questions)).unwrap_or_default();
        Self { model, all: questions.into_iter().zip(rulings).list() }
    }

    /// Whether a property holds.
    pub(crate) fn about(&self, property: &Property) -> Option<&Ruling> {
        self.ruling(Question::Holds(number(self.model, property)?))
    }

    /// What a property is about never happens.
    pub(crate) fn never_happens(&self, property: &Property) -> bool {
        number(self.model, property).is_some_and(|number| self.is_so(Question::NeverHappens(number)))
    }

    pub(crate) fn is_so(&self, question: Question) -> bool {
        self.ruling(question) == Some(&Ruling::Holds)
    }

    fn ruling(&self, question: Question) -> Option<&Ruling> {
        self.all.iter().find(|(asked, _)| *asked == question).map(|(_, ruling)| ruling)
    }
}

fn number(model: &Model, property: &Property) -> Option<usize> {
    model.properties.iter().position(|other| std::ptr::eq(other, property))
}

/// What is left open. What the assumptions leave is asked where anything relies on it.
fn questions(model: &Model, claims: &Claims<'_>) -> Vec<Question> {
    let mut all = Vec::new();
    for (of, question) in [
        (&claims.open, Question::Holds as fn(usize) -> Question),
        (&claims.away, Question::Holds),
        (&claims.triggers, Question::NeverHappens),
    ] {
        for (property, answer) in of {
            if let (Answer::Unknown(_), Some(number)) = (answer, number(model, property)) {
                all.push(question(number));
            }
        }
    }
    if !all.is_empty() {
        all.push_all(Question::of_assumptions(model));
    }
    all
}
