//! What the macro asks: what of a chart's properties the exploration of its situations has left open.

use grafcet_compiler::analysis::{Facts, Ruling};
use grafcet_compiler::model::Model;
use grafcet_compiler::program::{Encoding, counted};

use crate::circuit::Circuit;
use crate::live::decide_live;
use crate::sat::Limit;
use crate::table::table;
use crate::verdict::{Verdict, decide};

/// So many gates and no more: a macro is built without optimisation.
const GATES: usize = 400_000;

/// So many steps of the solver for each property.
const STEPS: u64 = 200_000;

/// Decides the `open` properties of a chart, by their numbers: one answer for each.
///
/// It is limited in steps, not in time, so that every machine says the same.
#[must_use]
pub fn rule(model: &Model, facts: &Facts<'_>, open: &[usize]) -> Vec<Ruling> {
    let all = |why: &dyn std::fmt::Display| open.iter().map(|_| Ruling::Open(why.to_string())).collect();
    let program = match counted(model, facts, Encoding::Regions) {
        Ok(program) => program,
        Err(refused) => return all(&refused),
    };
    let circuit = match Circuit::within(&program, GATES) {
        Ok(circuit) => circuit,
        Err(refused) => return all(&format!("the solver does not model {refused}")),
    };
    let ruling = |property: &usize| {
        let refused = circuit.refused.iter().find(|(number, _)| number == property);
        if let Some((_, refused)) = refused {
            return Ruling::Open(format!("the solver does not model {refused}"));
        }
        let limit = Limit::work(STEPS);
        let bad = circuit.bad.iter().find(|bad| bad.property == *property);
        let live = circuit.live.iter().find(|live| live.property == *property);
        let verdict = match (bad, live) {
            (Some(bad), _) => decide(&program, &circuit, *bad, &limit),
            (None, Some(live)) => decide_live(&program, &circuit, *live, &limit),
            (None, None) => return Ruling::Open("it is not about the ends of cycles".to_owned()),
        };
        match verdict {
            Ok(Verdict::Proved(_)) => Ruling::Holds,
            Ok(Verdict::Violated(way)) => Ruling::Broken { cycles: way.len(), again: None, way: table(model, &way) },
            Ok(Verdict::Endless { way, again }) => {
                Ruling::Broken { cycles: way.len(), again: Some(again + 1), way: table(model, &way) }
            }
            Ok(Verdict::Undecided(why)) => Ruling::Open(why),
            Err(internal) => Ruling::Open(internal.to_string()),
        }
    };
    open.iter().map(ruling).collect()
}
