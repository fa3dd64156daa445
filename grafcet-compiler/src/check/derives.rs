//! What the types of a chart are to derive, beside how its situation is stored.

use crate::ast::is_of;
use crate::diagnostic::{Mark, Sink};
use crate::list::List;
use crate::model::Model;

/// `serde` derives for arrays of up to 32 bytes. Beside a bit for each step there may be two: for the first cycle and for a
/// search that did not become stable.
const MOST: usize = 32 * 8 - 2;

/// Reports where `serde` would refuse the array of `encoding flags;`: what it says names neither.
pub(super) fn check(model: &Model, sink: &mut Sink) {
    let steps = model.steps.len();
    if !model.flags || steps <= MOST {
        return;
    }
    for path in model.derives.iter().flat(|derive| &derive.traits).filter(|path| is_of(path, "serde", "Serialize")) {
        let message = format!(
            "serde stores arrays of up to 32 bytes, and with `encoding flags;` {steps} steps take more: up to {MOST} steps \
             go together with serde; leave out `encoding flags;`, or this derive"
        );
        sink.notation(Mark::of(path), message);
    }
}
