//! How the outputs are cleared when a cycle begins.
//!
//! LLVM clears up to sixteen bytes word by word for the ARM. For more it calls `memclr`, which takes some forty instructions and a hundred
//! bytes. Something else that stands between the zeros makes two pieces of them.

use std::cmp::Reverse;

use crate::model::{Id, Model, OutputId, Ty};
use crate::sorted::sort_by_key;

/// So many bytes are cleared at once.
const PIECE: usize = 16;

/// The word between two pieces, so that the next one begins at a word, too.
const BETWEEN: usize = 4;

/// The outputs as rustc lays them out, the large ones first, and the bytes of each, where they are cleared in pieces. They stand in this
/// order in the struct, too, as that is the order in which they are written.
pub(super) fn in_pieces(model: &Model) -> Option<Vec<(OutputId, usize)>> {
    let (mut fields, mut all) = (Vec::new(), 0);
    for (id, output) in model.outputs.iter() {
        let bytes = match output.ty {
            Ty::Bool(_) => 1,
            Ty::Int { bits, .. } => bits as usize / 8,
            Ty::Time(_) => 4,
            // Nobody knows what it takes.
            Ty::Other(_) => return None,
        };
        fields.push((id, bytes));
        all += bytes;
    }
    sort_by_key(&mut fields, |(id, bytes)| (Reverse(*bytes), id.index()));
    (all > PIECE).then_some(fields)
}

/// The outputs that stand between the pieces.
pub(super) fn between(model: &Model) -> Vec<OutputId> {
    let (mut between, mut at) = (Vec::new(), 0);
    for (id, bytes) in in_pieces(model).unwrap_or_default() {
        if at % (PIECE + BETWEEN) >= PIECE {
            between.push(id);
        }
        at += bytes;
    }
    between
}

#[cfg(test)]
mod tests {
    use super::{between, in_pieces};
    use crate::diagnostic::Sink;
    use crate::model::{self, Model};
    use crate::parse;

    fn model(outputs: &str) -> Model {
        let text = format!("grafcet C {{ {outputs} initial step A; }}");
        let mut sink = Sink::new();
        let chart = parse::chart(text.parse().expect("tokens"), &mut sink).expect("a chart");
        model::resolve(&chart, &mut sink)
    }

    /// The names of what stands between the pieces.
    fn names(outputs: &str) -> String {
        let model = model(outputs);
        let names: Vec<String> = between(&model).into_iter().map(|id| model.outputs[id].name.to_string()).collect();
        names.join(" ")
    }

    #[test]
    fn a_word_stands_between_two_pieces_of_sixteen_bytes() {
        let truths = |count: usize| {
            let names: Vec<String> = (0..count).map(|number| format!("q{number}")).collect();
            format!("output {}: bool;", names.join(", "))
        };
        assert_eq!(names(&truths(16)), "");
        assert_eq!(names(&truths(17)), "q16");
        assert_eq!(names(&truths(30)), "q16 q17 q18 q19");
        // The large ones come first, wherever they are declared.
        assert_eq!(names(&format!("{} output n: u32;", truths(14))), "q12 q13");
        assert!(in_pieces(&model(&format!("{} output x: f32;", truths(20)))).is_none());
    }
}
