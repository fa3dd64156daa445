//! What the macro asks: what of a chart's properties the exploration of its situations has left open.

use grafcet_compiler::analysis::{Facts, Question, Ruling};
use grafcet_compiler::model::Model;
use grafcet_compiler::program::{Encoding, Program, counted};

use crate::aig::Lit;
use crate::circuit::Circuit;
use crate::home::decide_home;
use crate::live::decide_live;
use crate::replay::Shown;
use crate::sat::Limit;
use crate::table::table;
use crate::task::Invariant;
use crate::verdict::{Internal, Verdict, decide, never, says_nothing, vacuous};

/// So many gates and no more: a macro is built without optimisation.
const GATES: usize = 400_000;

/// So many steps of the solver for each property, and for each way home, of which a step is shorter.
const STEPS: u64 = 200_000;
const STEPS_HOME: u64 = 400_000;

/// Answers what is `asked` of a chart: one answer for each question.
///
/// It is limited in steps, not in time, so that every machine says the same.
#[must_use]
pub fn rule(model: &Model, facts: &Facts<'_>, asked: &[Question]) -> Vec<Ruling> {
    let all = |why: &dyn std::fmt::Display| asked.iter().map(|_| Ruling::Open(why.to_string())).collect();
    let program = match counted(model, facts, Encoding::Regions) {
        Ok(program) => program,
        Err(refused) => return all(&refused),
    };
    let circuit = match Circuit::within(&program, GATES) {
        Ok(circuit) => circuit,
        Err(refused) => return all(&format!("the solver does not model {refused}")),
    };
    let limit = || Limit::work(STEPS);
    let is_home = |property: usize| circuit.homes.iter().any(|home| home.property == property);
    let answer = |question: &Question| match *question {
        Question::Holds(property) if is_home(property) => holds(&program, &circuit, property, &Limit::work(STEPS_HOME)),
        Question::Holds(property) => holds(&program, &circuit, property, &limit()),
        Question::NeverHappens(property) => proved(vacuous(&circuit, property, &limit())),
        Question::NoCycle => proved(never(&circuit, Lit::TRUE, &limit())),
        Question::SaysNothing(number) => proved(says_nothing(&circuit, number, &limit())),
        Question::Apart(one, other) => {
            let (with, met) = circuit.meeting(one, other);
            proved(never(&alone(&with), met, &limit()))
        }
        Question::Settles => proved(never(&alone(&circuit), circuit.unsettled, &limit())),
        Question::NeverComes(number) => proved(never(&circuit, circuit.often[number], &limit())),
    };
    asked.iter().map(answer).collect()
}

/// The rules of a chart do not rely on what is assumed to come one behind the other.
fn alone(circuit: &Circuit) -> Circuit {
    Circuit { constraint: circuit.without_orders, ..circuit.clone() }
}

/// Of what is only said where it is proved.
fn proved(proof: Result<Option<Invariant>, Internal>) -> Ruling {
    match proof {
        Ok(Some(_)) => Ruling::Holds,
        Ok(None) => Ruling::Open("it is not proved".to_owned()),
        Err(internal) => Ruling::Open(internal.to_string()),
    }
}

fn holds(program: &Program<'_>, circuit: &Circuit, property: usize, limit: &Limit) -> Ruling {
    let refused = circuit.refused.iter().find(|(number, _)| *number == property);
    if let Some((_, refused)) = refused {
        return Ruling::Open(format!("the solver does not model {refused}"));
    }
    let bad = circuit.bad.iter().find(|bad| bad.property == property);
    let live = circuit.live.iter().find(|live| live.property == property);
    let home = circuit.homes.iter().find(|home| home.property == property);
    let verdict = match (bad, live, home) {
        (Some(bad), ..) => decide(program, circuit, *bad, limit),
        (_, Some(live), _) => decide_live(program, circuit, *live, limit),
        (.., Some(home)) => decide_home(program, circuit, home, limit),
        (None, None, None) => return Ruling::Open("it is not about the ends of cycles".to_owned()),
    };
    let table = |way: &[Shown]| table(program.model, way);
    match verdict {
        Ok(Verdict::Proved(_)) => Ruling::Holds,
        Ok(Verdict::Violated(way)) => Ruling::Broken { cycles: way.len(), again: None, way: table(&way) },
        Ok(Verdict::Endless { way, again }) => {
            Ruling::Broken { cycles: way.len(), again: Some(again + 1), way: table(&way) }
        }
        Ok(Verdict::Undecided(why)) => Ruling::Open(why),
        Err(internal) => Ruling::Open(internal.to_string()),
    }
}
