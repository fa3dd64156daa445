//! How the outputs are cleared when a cycle begins.
//!
//! LLVM clears up to sixteen bytes word by word for the ARM. For more it calls `memclr`, which takes some forty instructions and a hundred
//! bytes. Something else that stands between the zeros makes two pieces of them.

use std::cmp::Reverse;

use super::types;
use crate::model::{Id, Model, OutputId};
use crate::sorted::sort_by_key;

/// So many bytes are cleared at once.
const PIECE: usize = 16;

/// The word between two pieces, so that the next one begins at a word, too.
const BETWEEN: usize = 4;

/// The outputs as they lie in memory, the large ones first, and the bytes of each, where they are cleared in pieces. They stand in this order in the struct, which keeps it, and are
/// written in it.
pub(super) fn in_pieces(model: &Model) -> Option<Vec<(OutputId, usize)>> {
    let (mut fields, mut all) = (Vec::new(), 0);
    for (id, output) in model.outputs.iter() {
        // Of numbers each takes as many bytes as its address is a multiple of.
        let bytes = types::align(&output.ty).filter(|bytes| bytes.is_power_of_two())?;
        fields.push((id, bytes.into()));
        all += usize::from(bytes);
    }
    sort_by_key(&mut fields, |(id, bytes)| (Reverse(*bytes), id.index()));
    (all > PIECE).then_some(fields)
}

/// What a cycle begins with.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Begins {
    /// Zero, which the cycle may put there a second time.
    Cleared,
    /// Zero, with which nothing else can be done.
    Zero,
    /// Something else: it parts what stands around it.
    Other,
}

/// The outputs that stand between the pieces.
pub(super) fn between(model: &Model, begins: &dyn Fn(OutputId) -> Begins) -> Vec<OutputId> {
    let (mut between, mut piece, mut missing) = (Vec::new(), 0, 0);
    for (id, bytes) in in_pieces(model).unwrap_or_default() {
        match begins(id) {
            Begins::Other => (piece, missing) = (0, 0),
            Begins::Cleared if missing > 0 || piece + bytes > PIECE => {
                let all: usize = if missing > 0 { missing } else { BETWEEN };
                (piece, missing) = (0, all.saturating_sub(bytes));
                between.push(id);
            }
            Begins::Cleared | Begins::Zero => (piece, missing) = (piece + bytes, 0),
        }
    }
    between
}

#[cfg(test)]
mod tests {
    use super::{Begins, between, in_pieces};
    use crate::diagnostic::Sink;
    use crate::model::{self, Model, OutputId};
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
        let begins = |id: OutputId| match model.outputs[id].name.to_string().as_str() {
            "x" => Begins::Other,
            "z" => Begins::Zero,
            _ => Begins::Cleared,
        };
        let names: Vec<String> =
            between(&model, &begins).into_iter().map(|id| model.outputs[id].name.to_string()).collect();
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
        assert_eq!(names(&format!("{} output n: u16;", truths(40))), "q14 q15 q16 q17 q34 q35 q36 q37");
        assert_eq!(names(&format!("{} output n: u8; output o: i16;", truths(14))), "n");
        assert_eq!(names(&format!("{} output x: f64;", truths(10))), "");
        // What begins with something else stands between, too.
        assert_eq!(names(&format!("output x: u32; {}", truths(16))), "");
        assert_eq!(names(&format!("output x: bool; {}", truths(16))), "");
        assert_eq!(names(&format!("{} output x: bool; output r, s, t, u: bool;", truths(15))), "");
        assert_eq!(names(&format!("{} output x: bool; output r, s, t, u: bool;", truths(17))), "q16");
        // What is stored elsewhere is zero first, but cannot be cleared a second time.
        assert_eq!(names(&format!("output z: u32; {}", truths(13))), "q12");
        assert_eq!(names(&format!("{} output z: bool; output r, s, t, u: bool;", truths(16))), "r s t u");
        assert_eq!(names(&format!("{} output z: bool; output r: bool;", truths(17))), "q16");
        for unknown in ["usize", "Grams", "[bool; 4]"] {
            assert!(in_pieces(&model(&format!("{} output x: {unknown};", truths(20)))).is_none(), "{unknown}");
        }
    }
}
