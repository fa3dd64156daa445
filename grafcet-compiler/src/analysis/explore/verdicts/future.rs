//! What can still happen from each state on.

use crate::analysis::explore::net::Net;
use crate::analysis::explore::net::units::UnitId;
use crate::analysis::explore::search::graph::Graph;
use crate::analysis::explore::semantics;
use crate::list::List;
use crate::model::{Id, StepId, TransitionId};
use crate::sorted::sort_unstable;

/// Per strongly connected group of states, what can still happen: which pieces of the chart move, which sources of
/// AND-convergences are left, which AND-convergences are enabled.
pub(crate) struct Future {
    group_of: Vec<usize>,
    /// One row a group.
    rows: Vec<Vec<u64>>,
    units: usize,
    /// Sources of AND-convergences, ascending.
    pub(crate) waiting: Vec<StepId>,
    /// AND-convergences, ascending.
    pub(crate) joins: Vec<TransitionId>,
}

impl Future {
    pub(crate) fn of(net: &Net, graph: &Graph) -> Self {
        let joins: Vec<TransitionId> = net
            .arcs
            .ids()
            .filter(|t| net.arcs[*t].sources.len() > 1 && graph.unit.is_none_or(|unit| net.unit_of_arc(*t) == unit))
            .list();
        let mut waiting: Vec<StepId> = joins.iter().flat(|join| &net.arcs[*join].sources).copied().list();
        sort_unstable(&mut waiting);
        waiting.dedup();
        let (group_of, groups) = groups(graph);
        let mut future = Self { group_of, rows: Vec::new(), units: net.has_arcs.len(), waiting, joins };
        // The groups come in such an order that those to which one leads stand before it.
        for members in &groups {
            let row = future.row(net, graph, members);
            future.rows.push(row);
        }
        // What others do to the piece can happen at any time.
        for entry in &graph.entries {
            let row = future.rows[future.group_of[*entry]].clone();
            for other in &mut future.rows {
                unite(other, &row);
            }
        }
        future
    }

    fn row(&self, net: &Net, graph: &Graph, members: &[usize]) -> Vec<u64> {
        let mut row = vec![0; (self.units + self.waiting.len() + self.joins.len()).div_ceil(64)];
        for member in members {
            let state = &graph.states[*member];
            if !self.joins.is_empty() {
                for transition in semantics::enabled(net, graph.unit, &state.active) {
                    mark(&mut row, self.join(transition));
                }
            }
            for edge in &graph.edges[*member] {
                if self.is_full(&row) {
                    return row;
                }
                self.note_changes(net, &mut row, &state.active, &graph.states[edge.to].active);
                for transition in &edge.cleared {
                    set(&mut row, net.unit_of_arc(*transition).index());
                    for source in &net.arcs[*transition].sources {
                        mark(&mut row, self.wait(*source));
                    }
                }
                for step in &edge.changed {
                    set(&mut row, net.unit_of[*step].index());
                    mark(&mut row, self.wait(*step));
                }
                for join in &edge.joins {
                    mark(&mut row, self.join(*join));
                }
                if let Some(other) = self.rows.get(self.group_of[edge.to]) {
                    unite(&mut row, other);
                }
            }
        }
        row
    }

    /// Whether all can happen: what cleared in thousands of evolutions says nothing more then.
    fn is_full(&self, row: &[u64]) -> bool {
        let bits: u32 = row.iter().map(|word| word.count_ones()).sum();
        bits as usize == self.units + self.waiting.len() + self.joins.len()
    }

    fn note_changes(&self, net: &Net, row: &mut [u64], before: &[StepId], after: &[StepId]) {
        for step in before.iter().filter(|step| after.binary_search(step).is_err()) {
            set(row, net.unit_of[*step].index());
            mark(row, self.wait(*step));
        }
        for step in after.iter().filter(|step| before.binary_search(step).is_err()) {
            set(row, net.unit_of[*step].index());
        }
    }

    fn wait(&self, step: StepId) -> Option<usize> {
        self.waiting.binary_search(&step).ok().map(|position| self.units + position)
    }

    fn join(&self, transition: TransitionId) -> Option<usize> {
        let position = self.joins.binary_search(&transition).ok()?;
        Some(self.units + self.waiting.len() + position)
    }

    /// Whether anything in the piece of the chart changes from the state on.
    pub(crate) fn moves(&self, state: usize, unit: UnitId) -> bool {
        self.get(state, Some(unit.index()))
    }

    /// Whether the source of an AND-convergence is left from the state on.
    pub(crate) fn leaves(&self, state: usize, step: StepId) -> bool {
        self.get(state, self.wait(step))
    }

    /// Whether the AND-convergence is enabled from the state on.
    pub(crate) fn enables(&self, state: usize, join: TransitionId) -> bool {
        self.get(state, self.join(join))
    }

    fn get(&self, state: usize, bit: Option<usize>) -> bool {
        let row = &self.rows[self.group_of[state]];
        bit.is_some_and(|bit| row[bit / 64] & (1 << (bit % 64)) != 0)
    }
}

/// Per state those from which a cycle leads to it.
pub(crate) fn backwards(graph: &Graph) -> Vec<Vec<usize>> {
    let mut back = vec![Vec::new(); graph.states.len()];
    for (from, edges) in graph.edges.iter().enumerate() {
        for edge in edges {
            back[edge.to].push(from);
        }
    }
    back
}

fn mark(row: &mut [u64], bit: Option<usize>) {
    if let Some(bit) = bit {
        set(row, bit);
    }
}

fn set(row: &mut [u64], bit: usize) {
    row[bit / 64] |= 1 << (bit % 64);
}

fn unite(row: &mut [u64], other: &[u64]) {
    for (word, other) in row.iter_mut().zip(other) {
        *word |= other;
    }
}

/// A state of each group of states that lead to each other and to no others. All of them must have been looked at.
pub(crate) fn ends(graph: &Graph, looked_at: &[bool]) -> Vec<usize> {
    let (group_of, groups) = groups(graph);
    let ends = groups.iter().enumerate().filter(|(number, members)| {
        let stays = |member: &usize| graph.edges[*member].iter().all(|edge| group_of[edge.to] == *number);
        members.iter().all(|member| looked_at[*member] && stays(member))
    });
    ends.map(|(_, members)| members[0]).list()
}

/// The strongly connected groups of states (Tarjan), each after those to which it leads; with an explicit stack.
fn groups(graph: &Graph) -> (Vec<usize>, Vec<Vec<usize>>) {
    const NONE: usize = usize::MAX;
    let size = graph.states.len();
    let (mut group_of, mut groups) = (vec![NONE; size], Vec::new());
    let (mut found, mut low) = (vec![NONE; size], vec![NONE; size]);
    let (mut counter, mut open) = (0, Vec::new());
    for root in 0..size {
        if found[root] != NONE {
            continue;
        }
        let mut path: Vec<(usize, usize)> = vec![(root, 0)];
        while let Some((at, next)) = path.last_mut() {
            let at = *at;
            if *next == 0 {
                found[at] = counter;
                low[at] = counter;
                counter += 1;
                open.push(at);
            }
            let edge = graph.edges[at].get(*next);
            *next += 1;
            match edge.map(|edge| edge.to) {
                Some(to) if found[to] == NONE => path.push((to, 0)),
                Some(to) if group_of[to] == NONE => low[at] = low[at].min(found[to]),
                Some(_) => {}
                None => {
                    path.pop();
                    if let Some((parent, _)) = path.last() {
                        low[*parent] = low[*parent].min(low[at]);
                    }
                    if low[at] == found[at] {
                        let start = open.iter().rposition(|state| *state == at).unwrap_or(0);
                        let members = open.split_off(start);
                        for member in &members {
                            group_of[*member] = groups.len();
                        }
                        groups.push(members);
                    }
                }
            }
        }
    }
    (group_of, groups)
}
