//! Sequences of cycles that show all that can be shown.

use std::collections::{BTreeMap, BTreeSet};

use grafcet_sim::Error;

use super::goals::Goal;
use super::proof::{self, Told};
use super::search::{Ended, Node, Search};

pub(crate) struct Plan<'c> {
    /// Each from the start of the chart on.
    pub(crate) sequences: Vec<Vec<Node<'c>>>,
    /// All there is to show.
    pub(crate) goals: BTreeSet<Goal>,
    /// What could not be shown, and why not.
    pub(crate) open: BTreeMap<Goal, String>,
    /// What is proved that it cannot be.
    pub(crate) never: BTreeSet<Goal>,
}

impl<'c> Plan<'c> {
    /// Goes on from where it is to the nearest goal, and begins anew where none is left in that direction.
    ///
    /// # Errors
    /// The chart cannot be run.
    pub(crate) fn of(search: &Search<'c>, effort: usize) -> Result<Self, Error> {
        let goals = search.goals();
        let mut open = goals.clone();
        let start = search.start()?;
        let mut sequences = Vec::new();
        let mut sequence: Vec<Node<'c>> = Vec::new();
        let mut why = String::new();
        while !open.is_empty() {
            match search.next(sequence.last().unwrap_or(&start), &open) {
                Ended::Found(way, shown) => {
                    sequence.extend(way);
                    open.retain(|goal| !shown.contains(goal));
                }
                _ if !sequence.is_empty() => sequences.push(std::mem::take(&mut sequence)),
                Ended::Exhausted(states) => {
                    why = format!("in none of the {states} states that the tried values and times lead to");
                    break;
                }
                Ended::GivenUp => {
                    why = format!("not found in {effort} cycles, which is the effort that was allowed");
                    break;
                }
            }
        }
        if !sequence.is_empty() {
            sequences.push(sequence);
        }
        Ok(Self {
            sequences,
            goals,
            open: open.into_iter().map(|goal| (goal, why.clone())).collect(),
            never: BTreeSet::new(),
        })
    }

    /// With what the prover says of what is open. A way of its counts where the simulation goes it: to its end, and from there on by searching.
    ///
    /// # Errors
    /// The chart cannot be run.
    pub(crate) fn told(&mut self, search: &Search<'c>, told: BTreeMap<Goal, Vec<Told>>) -> Result<(), Error> {
        self.never = proof::impossible(&told, &self.open);
        self.open.retain(|goal, _| !self.never.contains(goal));
        let ways = told.into_iter().flat_map(|(goal, all)| all.into_iter().map(move |one| (goal, one)));
        for (goal, one) in ways {
            let Told::Way(way) = one else { continue };
            if !self.open.contains_key(&goal) {
                continue;
            }
            let Some((mut sequence, mut shown)) = search.along(&way)? else { continue };
            if !shown.contains(&goal)
                && let Some(last) = sequence.last()
                && let Ended::Found(more, new) = search.next(last, &BTreeSet::from([goal]))
            {
                sequence.extend(more);
                shown.extend(new);
            }
            if shown.contains(&goal) {
                self.open.retain(|goal, _| !shown.contains(goal));
                self.sequences.push(sequence);
            } else if let Some(why) = self.open.get_mut(&goal) {
                "the prover leads to where it could be, and the search finds no way on from there".clone_into(why);
            }
        }
        Ok(())
    }

    pub(crate) fn cycles(&self) -> usize {
        self.sequences.iter().map(Vec::len).sum()
    }
}
