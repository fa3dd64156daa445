//! What is only said where it is proved: that something never happens, never comes, or never moves.

use grafcet_compiler::analysis::Question;

use crate::aig::Lit;
use crate::circuit::Circuit;
use crate::limit::Limit;
use crate::task::Invariant;
use crate::verdict::{Internal, never, says_nothing, vacuous};

/// Why it is so; none where it is not, or where that is not found out. Whether a property holds is decided elsewhere.
///
/// # Errors
/// A proof that fails its check.
pub fn is_so(circuit: &Circuit, question: Question, limit: &Limit) -> Result<Option<Invariant>, Internal> {
    match question {
        Question::Holds(_) => Ok(None),
        Question::NeverHappens(number) => vacuous(circuit, number, limit),
        Question::NoCycle => never(circuit, Lit::TRUE, limit),
        Question::NeverComes(number) => never(circuit, circuit.often[number], limit),
        Question::SaysNothing(number) => says_nothing(circuit, number, limit),
        Question::StandsStill(number) => never(circuit, circuit.moves[number], limit),
        Question::Apart(one, other) => {
            let (with, met) = circuit.meeting(one, other);
            never(&alone(&with), met, limit)
        }
        Question::Settles => never(&alone(circuit), circuit.unsettled, limit),
    }
}

/// The rules of a chart do not rely on what is assumed to come one after the other.
fn alone(circuit: &Circuit) -> Circuit {
    Circuit { constraint: circuit.without_orders, ..circuit.clone() }
}
