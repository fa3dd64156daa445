//! Whether the assumptions leave anything that could happen.

use crate::analysis::{Condition, Logic};
use crate::diagnostic::Sink;
use crate::list::List;
use crate::model::{Assumption, Model};

/// Reports assumptions that together exclude every input, and none that could be missing among them. A mistake of notation:
/// under such assumptions every rule and every property would hold.
pub(super) fn check(model: &Model, sink: &mut Sink) {
    let logic = Logic::new(model);
    let read = |assumption: &'_ Assumption| logic.condition(&assumption.never.tree);
    let conditions: Vec<Condition> = model.assumptions.iter().map(read).list();
    let exclude_all = |those: &[usize]| {
        let goals: Vec<_> = those.iter().map(|index| (&conditions[*index], false)).list();
        logic.impossible(&goals)
    };
    let mut culprits: Vec<usize> = (0..conditions.len()).list();
    if culprits.is_empty() || !exclude_all(&culprits) {
        return;
    }
    let mut at = 0;
    while at < culprits.len() {
        let one = culprits.remove(at);
        if !exclude_all(&culprits) {
            culprits.insert(at, one);
            at += 1;
        }
    }
    for index in &culprits {
        let assumption = &model.assumptions[*index];
        let message = match &culprits[..] {
            [_] => format!(
                "`{}` always holds, so that with this assumption nothing is left that could happen",
                assumption.never.text
            ),
            _ => format!(
                "these {} assumptions together exclude every input, so that nothing is left that could happen; correct one of them",
                culprits.len()
            ),
        };
        sink.notation(assumption.mark, message);
    }
}
