//! What the macro asks: what of a chart's properties the exploration of its situations has left open.

use grafcet_compiler::analysis::explore::Limits;
use grafcet_compiler::analysis::{Facts, Question, Ruling};
use grafcet_compiler::model::{Claim, Model};
use grafcet_compiler::program::{Program, counted};

use crate::circuit::Circuit;
use crate::home::decide_home;
use crate::limit::{Effort, Limit};
use crate::live::decide_live;
use crate::questions::is_so;
use crate::replay::Shown;
use crate::table::table;
use crate::task::Invariant;
use crate::verdict::{Internal, OVER, Verdict, decide};

/// So many gates and no more: a macro is built without optimisation.
const GATES: usize = 400_000;

/// So many steps of the solver for each question, of which a step in a small circuit finds next to nothing.
const STEPS: u64 = 2_000_000;

/// What all of a chart may take together, as a step of a large circuit takes a hundred times as long as one of a small circuit: in a macro
/// without optimisation some four seconds.
const EFFORT: u64 = 6_000_000;

/// Where it is decided for which this does not suffice.
const MORE: &str = "`cargo grafcet prove` searches as long as you let it, and a larger `budget` of the chart lets the macro search longer";

/// Answers what is `asked` of a chart: one answer for each question.
///
/// It is limited in steps and in what they find, not in time, so that every machine says the same. A `budget` of the chart above what the
/// exploration has without one moves these limits as far.
#[must_use]
pub fn rule(model: &Model, facts: &Facts<'_>, asked: &[Question]) -> Vec<Ruling> {
    let all = |why: &dyn std::fmt::Display| asked.iter().map(|_| Ruling::Open(why.to_string())).collect();
    let program = match counted(model, facts) {
        Ok(program) => program,
        Err(refused) => return all(&refused),
    };
    let circuit = match Circuit::within(&program, GATES) {
        Ok(circuit) => circuit,
        Err(refused) => return all(&format!("the solver does not model {refused}")),
    };
    let times = model.budget.map_or(1, |count| (Limits::situations(count).work / Limits::default().work).max(1));
    let answer = |question: &Question, share: &Effort| {
        let limit = Limit::work(STEPS.saturating_mul(times)).within(share);
        match *question {
            Question::Holds(number) => holds(&program, &circuit, number, &limit),
            question => proved(is_so(&circuit, question, &limit)),
        }
    };
    // What is about one cycle is mostly easier than what comes after another, or a way home.
    let is_later = |question: &Question| match *question {
        Question::Holds(number) => !matches!(model.properties[number].claim, Claim::Never(_) | Claim::Always { .. }),
        _ => true,
    };
    shared(asked, is_later, &Effort::new(EFFORT.saturating_mul(times)), answer)
}

/// Each question is asked with a small share first, and what that does not decide once more with half of what is left: nothing that is hard is in
/// the way of what is easy.
fn shared(
    asked: &[Question],
    is_later: impl Fn(&Question) -> bool,
    whole: &Effort,
    answer: impl Fn(&Question, &Effort) -> Ruling,
) -> Vec<Ruling> {
    let ask = |question: &Question, part: u64| {
        let share = whole.part(part);
        let ruling = answer(question, &share);
        let was_stopped = share.is_spent();
        whole.take_back(&share);
        (ruling, was_stopped)
    };
    let small = if asked.len() == 1 { whole.left() } else { whole.left() / (4 * asked.len().max(1) as u64) };
    let mut rulings: Vec<(Ruling, bool)> = asked.iter().map(|question| ask(question, small)).collect();
    for later in [false, true] {
        for (question, (ruling, was_stopped)) in asked.iter().zip(&mut rulings) {
            if *was_stopped && matches!(ruling, Ruling::Open(_)) && is_later(question) == later {
                *ruling = ask(question, whole.left() / 2).0;
            }
        }
    }
    rulings.into_iter().map(|(ruling, _)| ruling).collect()
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
        Ok(Verdict::Undecided(why)) if why == OVER => Ruling::Open(format!("{why}: {MORE}")),
        Ok(Verdict::Undecided(why)) => Ruling::Open(why),
        Err(internal) => Ruling::Open(internal.to_string()),
    }
}
