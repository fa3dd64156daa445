//! A set of situations as a decision diagram: as many bytes as the chart has structure, where a list has as many as there are situations.
//!
//! It is zero-suppressed: a node asks for one step, and what it does not ask for is inactive. So steps that exclude each other are a chain of nodes, and branches
//! that have nothing to do with each other stand one after the other.

use crate::list::PushAll;
use crate::model::{Id, StepId};
use crate::sorted::Map;

/// No situation, and that of no further step.
const NONE: u8 = 0;
const END: u8 = 1;

/// The node of a step: where to go on where it is inactive, and where it is active.
type Node = [u8; 3];

/// The nodes of the situations, each after those to which it leads, from number 2 on; the last one is the first that is asked. None where a byte is not enough for
/// their numbers, or those of the steps. The steps of each situation are ascending.
pub(super) fn diagram(situations: &[&[StepId]]) -> Option<Vec<u8>> {
    let mut nodes = Nodes { numbers: Map::new(), bytes: Vec::new() };
    let first = nodes.of(situations, 0)?;
    // The first one asks for the first step, which no other does.
    (usize::from(first) == nodes.bytes.len() / 3 + 1).then_some(nodes.bytes)
}

struct Nodes {
    numbers: Map<Node, u8>,
    bytes: Vec<u8>,
}

impl Nodes {
    /// Of situations that agree in their steps in front of `depth`.
    fn of(&mut self, situations: &[&[StepId]], depth: usize) -> Option<u8> {
        let Some(first) = situations.iter().filter_map(|steps| steps.get(depth)).min() else {
            return Some(if situations.is_empty() { NONE } else { END });
        };
        let is_active = |steps: &&&[StepId]| steps.get(depth) == Some(first);
        let (mut with, mut without) = (Vec::new(), Vec::new());
        with.push_all(situations.iter().filter(|steps| is_active(steps)).copied());
        without.push_all(situations.iter().filter(|steps| !is_active(steps)).copied());
        let (inactive, active) = (self.of(&without, depth)?, self.of(&with, depth + 1)?);
        let node = [u8::try_from(first.index()).ok()?, inactive, active];
        if let Some(number) = self.numbers.get(&node) {
            return Some(*number);
        }
        let number = u8::try_from(self.bytes.len() / 3 + 2).ok()?;
        self.bytes.push_all(node);
        self.numbers.insert(node, number);
        Some(number)
    }
}

#[cfg(test)]
mod tests {
    use super::diagram;
    use crate::list::List;
    use crate::model::{Id, StepId};

    fn of(situations: &[&[usize]]) -> Option<Vec<u8>> {
        let steps = situations.iter().map(|steps| steps.iter().map(|step| StepId::new(*step)).list()).list();
        diagram(&steps.iter().map(|steps| &steps[..]).list())
    }

    #[test]
    fn what_has_nothing_to_do_with_each_other_stands_one_after_the_other() {
        assert_eq!(of(&[&[0]]), Some(vec![0, 0, 1]));
        assert_eq!(of(&[&[]]), Some(vec![]), "no step, and nothing to ask");
        assert_eq!(of(&[]), None, "there always is a situation");
        // (0 | 1) and (2 | nothing)
        let product = of(&[&[0, 2], &[0], &[1, 2], &[1]]);
        assert_eq!(product, Some(vec![2, 1, 1, 1, 0, 2, 0, 3, 2]));
        // With 1 there is no 2.
        assert_eq!(of(&[&[0, 2], &[0], &[1]]), Some(vec![1, 0, 1, 2, 1, 1, 0, 2, 3]));
        assert_eq!(of(&[&[256]]), None);
    }
}
