//! Where a search ends without another look: with the activation of a step that nothing can leave in the same cycle.
//!
//! ```text
//! loop                             loop
//!   match state                      match state
//!     Bright:                          Bright:
//!       if !on: state = Off   ->         if !on: state = Off
//!       else: leave                      else: leave
//!                                    if state is Off: leave
//! ```

use super::super::{Expr, PlaceId, Statement, Value};
use super::engine::{End, Leaf, Tree};
use super::sparse::States;
use super::uses::same_block;
use crate::model::StepId;
use crate::sorted::Set;

/// The steps with which a search ends.
pub(super) struct Early<'e> {
    pub(super) state: PlaceId,
    pub(super) points: &'e States,
    pub(super) ends: &'e Set<StepId>,
    /// By place: no other round looks at it.
    pub(super) assumed: &'e [bool],
}

impl Early<'_> {
    /// What stands at the end of each round, if all these steps do the same where they rest. Where all ways lead to such steps, each does at once
    /// what its step does there, and leaves the loop.
    pub(super) fn apply<'m>(&self, trees: &mut [Option<Tree<'m>>]) -> Vec<Statement<'m>> {
        let mut rests: Vec<Option<Vec<Statement<'m>>>> = vec![None; trees.len()];
        let mut steps = Vec::new();
        for ((rest, tree), point) in rests.iter_mut().zip(&*trees).zip(&self.points.all) {
            if let Value::Step(Some(step)) = point {
                *rest = tree
                    .as_ref()
                    .filter(|_| self.ends.contains(step))
                    .and_then(|tree| at_rest(tree, *point, self.assumed));
                steps.extend(rest.as_ref().map(|_| *step));
            }
        }
        let to = |leaf: &Leaf<'m>| self.points.point(leaf.state).filter(|_| !leaf.breaks);
        let mut all_end = true;
        for tree in trees.iter().flatten() {
            tree.each_leaf(&mut |leaf| all_end &= to(leaf).is_none_or(|to| rests[to].is_some()));
        }
        if !all_end {
            let mut alike = rests.into_iter().flatten();
            let Some(mut rest) = alike.next() else { return Vec::new() };
            if !alike.all(|other| same_block(&rest, &other)) {
                return Vec::new();
            }
            rest.push(Statement::Break);
            return vec![Statement::If(Expr::Is(self.state, steps), rest, Vec::new())];
        }
        for tree in trees.iter_mut().flatten() {
            tree.each_leaf_mut(&mut |leaf| {
                if let Some(rest) = to(leaf).and_then(|to| rests[to].as_ref()) {
                    leaf.body.extend(rest.iter().cloned());
                    leaf.breaks = true;
                }
            });
        }
        Vec::new()
    }
}

/// What is done where the loop is left in a state, if that is the same on all ways. What stays in the state and goes on all the same would
/// be left out.
fn at_rest<'m>(tree: &Tree<'m>, state: Value, assumed: &[bool]) -> Option<Vec<Statement<'m>>> {
    let (mut rest, mut is_one) = (None, true);
    each_way(tree, &mut Vec::new(), &mut |way, leaf| {
        if !leaf.breaks {
            return is_one &= leaf.state != state;
        }
        // What no other round looks at.
        let mut way = way.to_vec();
        way.retain(|one| !matches!(one, Statement::Set(place, _) if assumed[place.0]));
        match &rest {
            None => rest = Some(way),
            Some(rest) => is_one &= same_block(rest, &way),
        }
    });
    rest.filter(|_| is_one)
}

/// Each way to a leaf, with all that is done on it.
fn each_way<'m>(tree: &Tree<'m>, way: &mut Vec<Statement<'m>>, each: &mut dyn FnMut(&[Statement<'m>], &Leaf<'m>)) {
    let begun = way.len();
    way.extend(tree.body.iter().cloned());
    match &tree.end {
        End::Leaf(leaf) => {
            way.extend(leaf.body.iter().cloned());
            each(way, leaf);
        }
        End::Fork(_, ways) => ways.iter().for_each(|one| each_way(one, way, each)),
    }
    way.truncate(begun);
}
