//! What the prover says about small random charts with plants, beside a naive exploration of all of them together.

use std::time::Duration;

use grafcet_compiler::analysis::Facts;
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::Model;
use grafcet_compiler::plant;
use grafcet_compiler::program::{Program, counted};
use grafcet_prove::circuit::Circuit;
use grafcet_prove::{Limit, Verdict, decide, decide_live, vacuous};

use crate::brute::closed::Closed;
use crate::brute::machines::{LONGEST, Machines, machines};
use crate::brute::responses::Broken;
use crate::prove::{Bounds, Counts};

/// Compares the chart of a number; false where there is nothing to compare.
///
/// # Errors
/// A difference, with the chart.
pub fn number(number: u64, grafcet: bool, bounds: Bounds, counts: &mut Counts) -> Result<bool, String> {
    let Some(Machines { asked, plain }) = machines(number, grafcet) else { return Ok(false) };
    let of_chart = |error: String| format!("{number}: {error}\n{asked}");
    let (Some(judged), Some(model)) = (read(&asked), read(&plain)) else { return Ok(false) };
    let Some(closed) = Closed::of(&model, LONGEST, bounds.cycles).map_err(of_chart)? else { return Ok(false) };
    counts.charts += 1;
    counts.states += closed.states();
    compare((&model, &judged), &closed, (number, bounds.time), counts).map_err(of_chart)?;
    Ok(true)
}

/// None for a chart that is not one: made at random, it may break a rule of drawing.
fn read(text: &str) -> Option<Model> {
    let mut sink = Sink::new();
    let model = plant::model(text.parse().ok()?, &mut sink);
    let is_whole = sink.finish().iter().all(|one| one.rule.is_some());
    model.filter(|model| is_whole && !model.incomplete)
}

fn compare(
    (model, judged): (&Model, &Model),
    closed: &Closed,
    (number, time): (u64, Duration),
    counts: &mut Counts,
) -> Result<(), String> {
    let program = counted(judged, &Facts::of(judged)).map_err(|refused| refused.to_string())?;
    let Ok(circuit) = Circuit::of(&program) else {
        counts.refused += 1;
        return Ok(());
    };
    for (property, one) in model.properties.iter().enumerate() {
        let Some(verdict) = verdict(&program, &circuit, property, time)? else {
            counts.undecided.push((number, format!("property {property}: not modelled")));
            continue;
        };
        let naive = closed.broken(property, &one.claim);
        let same = match (&verdict, &naive) {
            (Verdict::Undecided(why), _) => {
                counts.undecided.push((number, format!("property {property}: {why}")));
                true
            }
            (Verdict::Proved(_), None) | (Verdict::Endless { .. }, Some(Broken::Endless)) => true,
            (Verdict::Violated(way), Some(Broken::In(cycles))) => way.len() == *cycles,
            _ => false,
        };
        if !same {
            return Err(format!("property {property}: {verdict:?}, by brute force {naive:?}"));
        }
        match verdict {
            Verdict::Proved(_) => counts.proved += 1,
            Verdict::Violated(_) | Verdict::Endless { .. } => counts.broken += 1,
            Verdict::Undecided(_) => {}
        }
        if circuit.triggers.iter().any(|(of, _)| *of == property) {
            let never = vacuous(&circuit, property, &Limit::time(time)).map_err(|error| error.to_string())?.is_some();
            counts.vacuous += usize::from(never);
            match (never, closed.happens(property)) {
                (true, true) => return Err(format!("property {property} says something by brute force")),
                // Nothing is said where it is not found in time.
                (false, false) => {
                    counts.undecided.push((number, format!("property {property}: whether it says something")));
                }
                _ => {}
            }
        }
    }
    Ok(())
}

fn verdict(
    program: &Program<'_>,
    circuit: &Circuit,
    property: usize,
    time: Duration,
) -> Result<Option<Verdict>, String> {
    let bad = circuit.bad.iter().find(|bad| bad.property == property);
    let live = circuit.live.iter().find(|live| live.property == property);
    let verdict = match (bad, live) {
        (Some(bad), _) => decide(program, circuit, *bad, &Limit::time(time)),
        (_, Some(live)) => decide_live(program, circuit, *live, &Limit::time(time)),
        (None, None) => return Ok(None),
    };
    verdict.map(Some).map_err(|error| error.to_string())
}
