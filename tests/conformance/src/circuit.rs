//! The circuit of a chart beside its program, cycle by cycle, without rustc.

use grafcet_compiler::analysis::Facts;
use grafcet_compiler::model::Model;
use grafcet_compiler::program::run::{Machine, Nothing};
use grafcet_compiler::program::{Role, Value, counted};
use grafcet_prove::circuit::{Circuit, Source};
use grafcet_prove::play::{Player, clipped, passed, stored};

use crate::program::{given, plain, value};
use crate::reader::{Kind, Line};

/// How a comparison ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Outcome {
    /// All cycles are the same; so many.
    Same(usize),
    /// The circuit does not know something in the chart.
    Refused,
}

/// Plays a timeline on the circuit of a chart and on its program.
///
/// # Errors
/// The first difference.
pub fn compare(model: &Model, lines: &[Line]) -> Result<Outcome, String> {
    let program = counted(model, &Facts::of(model)).map_err(|refused| refused.to_string())?;
    let Ok(circuit) = Circuit::of(&program) else { return Ok(Outcome::Refused) };
    let Ok(mut machine) = Machine::new(&program, &mut Nothing) else { return Ok(Outcome::Refused) };
    let mut player = Player::new(&circuit);
    let (mut last, mut cycles) = (0, 0);
    let mut params: Vec<Value> = Vec::new();
    for (id, _) in model.params.iter() {
        params.extend(program.place(Role::Param(id)).map(|place| machine.value(place)));
    }
    for line in lines {
        match &line.kind {
            Kind::Init => {
                machine.init();
                player = Player::new(&circuit);
            }
            Kind::Params(changed) => {
                for ((id, param), now) in model.params.iter().zip(&mut params) {
                    let (Some(new), Some(place)) = (changed.get(&plain(&param.name)), program.place(Role::Param(id)))
                    else {
                        continue;
                    };
                    *now = value(*new, &param.ty);
                    machine.set(place, *now);
                }
            }
            Kind::Shows(_) | Kind::Wakes(_) | Kind::Refuses(_) => {}
            // A program knows nothing of forcing: it makes a cycle as any other, beside an interpreter that does so.
            Kind::Cycle { inputs, now, .. } | Kind::Force { inputs, now, .. } => {
                let given: Vec<Value> =
                    model.inputs.values().map(|i| value(given(inputs, &plain(&i.name)), &i.ty)).collect();
                let elapsed = now.wrapping_sub(last);
                last = *now;
                player.cycle(|source| match source {
                    Source::Input(id) => number(&given[grafcet_compiler::model::Id::index(*id)], circuit.time_bits),
                    Source::Param(id) => number(&params[grafcet_compiler::model::Id::index(*id)], circuit.time_bits),
                    Source::Elapsed => passed(elapsed, &circuit),
                    Source::Rust(_) | Source::Again | Source::Plant(..) => 0,
                });
                let at = |what: String| format!("line {}: {}\n  {what}", line.number, line.text());
                let in_range = !player.holds(circuit.overflow) && player.holds(circuit.constraint);
                if let Err(error) = machine.cycle(&given, *now, &mut Nothing) {
                    // What an assumption excludes may be anything.
                    let known = !in_range || matches!(error, grafcet_compiler::program::run::Error::NotUnderstood(_));
                    return if known { Ok(Outcome::Same(cycles)) } else { Err(at(error.to_string())) };
                }
                if player.holds(circuit.overflow) {
                    return Err(at("the circuit says that arithmetic leaves its type".to_owned()));
                }
                for field in &circuit.fields {
                    let Some(place) = field.place else { continue };
                    let (expected, found) = (machine.value(place), player.field(field));
                    let role = program.places[place.0].role;
                    let alike = |time: i128| match expected {
                        Value::Ticks(_) if !matches!(role, Role::Phase { .. } | Role::MacroPhase { .. }) => {
                            time.min(circuit.long())
                        }
                        _ => time,
                    };
                    if stored(&program, expected, circuit.time_bits).map(alike) != Some(alike(found)) {
                        return Err(at(format!("{}: program {expected:?}, circuit {found}", field.name)));
                    }
                }
                cycles += 1;
            }
        }
    }
    Ok(Outcome::Same(cycles))
}

fn number(value: &Value, time_bits: usize) -> i128 {
    match value {
        Value::Bool(value) => i128::from(*value),
        Value::Int(value) => *value,
        Value::Ticks(ticks) => clipped(*ticks, time_bits),
        _ => 0,
    }
}
