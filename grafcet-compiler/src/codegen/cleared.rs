//! How the outputs are cleared when a cycle begins.
//!
//! LLVM clears bytes for the ARM by four stores at most: sixteen bytes are four words, fifteen would be three words and two smaller ones. For more it calls `memclr`, which
//! takes some forty instructions and a hundred bytes. Something else that stands between the zeros makes two pieces of them.

use std::cmp::Reverse;

use super::types;
use crate::model::{Id, Model, OutputId, Tree};
use crate::program::Fence;
use crate::sorted::sort_by_key;

/// So many bytes are cleared at once,
const PIECE: usize = 16;

/// but not so many.
const ODD: usize = 15;

/// The word between two pieces, so that the next one begins at a word, too.
const BETWEEN: usize = 4;

/// The outputs as they lie in memory, and the bytes of each, where they are cleared in pieces: those first that begin with zero, so that these lie together from a word on, and of
/// them the large ones first. They stand in this order in the struct, which keeps it, and are written in it.
pub(super) fn in_pieces(model: &Model) -> Option<Vec<(OutputId, usize)>> {
    let (mut fields, mut all) = (Vec::new(), 0);
    for (id, output) in model.outputs.iter() {
        // Of numbers each takes as many bytes as its address is a multiple of.
        let bytes = types::align(&output.ty).filter(|bytes| bytes.is_power_of_two())?;
        fields.push((id, bytes.into()));
        all += usize::from(bytes);
    }
    let is_zero = |id: OutputId| {
        model.outputs[id].init.as_ref().is_none_or(|init| matches!(init.tree, Tree::Bool(false) | Tree::Int(0)))
    };
    sort_by_key(&mut fields, |(id, bytes)| (!is_zero(*id), Reverse(*bytes), id.index()));
    (all >= ODD).then_some(fields)
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

/// The outputs that stand between the pieces, and where they have to: only processors without unaligned stores need more than four for fifteen bytes, or for those that begin within a word.
pub(super) fn between(model: &Model, begins: &dyn Fn(OutputId) -> Begins) -> (Vec<OutputId>, Option<Fence>) {
    let mut fields = Vec::new();
    for (id, bytes) in in_pieces(model).unwrap_or_default() {
        fields.push((id, bytes, begins(id)));
    }
    let (mut between, mut unaligned) = (Vec::new(), Vec::new());
    let (mut offset, mut piece, mut missing) = (0, 0, 0);
    for (at, (id, bytes, begins)) in fields.iter().enumerate() {
        let run = run(&fields[at..]);
        match begins {
            Begins::Other => (piece, missing) = (0, 0),
            Begins::Cleared if missing > 0 || piece + bytes > PIECE => {
                let all: usize = if missing > 0 { missing } else { BETWEEN };
                (piece, missing) = (0, all.saturating_sub(*bytes));
                between.push(*id);
            }
            // Until the next word, or the last of fifteen.
            Begins::Cleared if piece == 0 && offset % BETWEEN > 0 && run > BETWEEN || piece + 1 == ODD && run == 1 => {
                unaligned.push(*id);
            }
            Begins::Cleared | Begins::Zero => (piece, missing) = (piece + bytes, 0),
        }
        offset += bytes;
    }
    let fence = if between.is_empty() { (!unaligned.is_empty()).then_some(Fence::Armv6m) } else { Some(Fence::Memory) };
    between.extend(unaligned);
    (between, fence)
}

/// So many bytes are zero from here on.
fn run(fields: &[(OutputId, usize, Begins)]) -> usize {
    let mut all = 0;
    for (_, bytes, begins) in fields {
        if *begins == Begins::Other {
            break;
        }
        all += bytes;
    }
    all
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
            between(&model, &begins).0.into_iter().map(|id| model.outputs[id].name.to_string()).collect();
        names.join(" ")
    }

    #[test]
    fn a_word_stands_between_two_pieces_of_sixteen_bytes() {
        let truths = |count: usize| {
            let names: Vec<String> = (0..count).map(|number| format!("q{number}")).collect();
            format!("output {}: bool;", names.join(", "))
        };
        assert_eq!(names(&truths(16)), "");
        // Fifteen take five stores.
        assert_eq!(names(&truths(14)), "");
        assert_eq!(names(&truths(15)), "q14");
        assert_eq!(names(&truths(35)), "q16 q17 q18 q19 q34");
        assert_eq!(names(&format!("{} output n: u8 = 0;", truths(14))), "n");
        assert_eq!(names(&format!("{} output n: u16;", truths(13))), "q12");
        assert_eq!(names(&truths(17)), "q16");
        assert_eq!(names(&truths(30)), "q16 q17 q18 q19");
        // The large ones come first, wherever they are declared.
        assert_eq!(names(&format!("{} output n: u32;", truths(14))), "q12 q13");
        assert_eq!(names(&format!("{} output n: u16;", truths(40))), "q14 q15 q16 q17 q34 q35 q36 q37");
        assert_eq!(names(&format!("{} output n: u8; output o: i16;", truths(14))), "n");
        assert_eq!(names(&format!("{} output x: f64;", truths(10))), "");
        // What begins with something else comes last, so that the zeros begin at a word.
        assert_eq!(names(&format!("output x: u32 = 7; {}", truths(16))), "");
        assert_eq!(names(&format!("output x: u8 = 7; {}", truths(16))), "");
        assert_eq!(names(&format!("output x: u8 = 7; {}", truths(15))), "q14");
        assert_eq!(names(&format!("output x: u8 = 7; {}", truths(14))), "");
        // Nobody knows whether it is the same to the cycle: it stands between, too.
        assert_eq!(names(&format!("{} output x: bool; output r, s, t, u: bool;", truths(15))), "q14");
        assert_eq!(names(&format!("{} output x: bool; output r, s, t, u: bool;", truths(16))), "");
        // After it the next ones until a word begins.
        assert_eq!(names(&format!("output r, s, x: bool; {}", truths(16))), "q0 q15");
        assert_eq!(names(&format!("output x: bool; {}", truths(20))), "q19 q0 q1 q2");
        assert_eq!(names(&format!("{} output x: bool; output r, s, t, u: bool;", truths(14))), "");
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
