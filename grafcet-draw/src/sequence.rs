//! The main sequence of a net: what goes on straight, whichever branch is written first.
//!
//! Of the branches behind a step, the one with the longest way of its own leads on: of steps that are reached through it alone.

use crate::search::Search;

/// What leads on straight.
pub(crate) struct Sequence {
    /// Behind each node, the transition of the main branch.
    pub(crate) main: Vec<Option<usize>>,
    /// From a node to a transition, and from a transition to a node, with the number of the sequence they belong to: the main one
    /// of the net is the first.
    pub(crate) down: Vec<(usize, usize, usize)>,
    pub(crate) on: Vec<(usize, usize, usize)>,
}

/// Steps and transitions of a net as one graph, without what leads back.
struct Ways<'s> {
    search: &'s Search<'s>,
    nodes: usize,
    /// The layer of each, from which all that lead to it are above.
    layer: Vec<usize>,
    /// What each way to it goes through; the last one of all is where everything begins.
    through: Vec<usize>,
    /// How many steps are on the longest way behind it, and on the longest of which all go through it.
    long: Vec<usize>,
    own: Vec<usize>,
}

/// The sequences of a net whose arcs back are known; `layers` are those of nodes and transitions.
pub(crate) fn sequence(search: &Search<'_>, layers: &(Vec<usize>, Vec<usize>)) -> Sequence {
    let ways = Ways::of(search, layers);
    let main: Vec<Option<usize>> = (0..ways.nodes).map(|node| ways.main(node)).collect();
    let mut sequence = Sequence { main, down: Vec::new(), on: Vec::new() };
    let mut starts: Vec<usize> = (0..ways.nodes).collect();
    starts.sort_by_key(|node| search.node_key[*node]);
    let (mut nodes, mut links) = (vec![false; ways.nodes], vec![false; search.sources.len()]);
    for (number, start) in starts.into_iter().enumerate() {
        let mut node = start;
        // What comes before has another sequence, which ends here or goes through.
        while let Some(link) = sequence.main[node].filter(|link| !nodes[node] && !links[*link]) {
            (nodes[node], links[link]) = (true, true);
            sequence.down.push((node, link, number));
            let Some(next) = ways.behind(link).find(|next| !nodes[*next]) else { break };
            sequence.on.push((link, next, number));
            node = next;
        }
    }
    sequence
}

impl<'s> Ways<'s> {
    fn of(search: &'s Search<'s>, (node_layers, link_layers): &(Vec<usize>, Vec<usize>)) -> Self {
        let layer: Vec<usize> = node_layers.iter().chain(link_layers).copied().collect();
        let (nodes, all) = (node_layers.len(), layer.len());
        let mut ways = Self { search, nodes, layer, through: vec![all; all], long: vec![0; all], own: vec![0; all] };
        let mut order: Vec<usize> = (0..all).collect();
        order.sort_by_key(|id| (ways.layer[*id], *id));
        let mut before = vec![Vec::new(); all];
        for id in 0..all {
            ways.after(id).into_iter().for_each(|next| before[next].push(id));
        }
        for id in &order {
            let common = before[*id].iter().copied().reduce(|a, b| ways.common(a, b));
            ways.through[*id] = common.unwrap_or(all);
        }
        for id in order.into_iter().rev() {
            let step = usize::from(id < nodes);
            ways.long[id] = step + ways.after(id).into_iter().map(|next| ways.long[next]).max().unwrap_or(0);
            ways.own[id] += step;
            let (up, own) = (ways.through[id], ways.own[id]);
            if let Some(most) = ways.own.get_mut(up) {
                *most = own.max(*most);
            }
        }
        ways
    }

    /// The nodes to which a transition leads down.
    fn behind(&self, link: usize) -> impl Iterator<Item = usize> + '_ {
        self.search.forward[link].iter().copied()
    }

    fn after(&self, id: usize) -> Vec<usize> {
        match id.checked_sub(self.nodes) {
            None => self.search.out[id].iter().map(|link| link + self.nodes).collect(),
            Some(link) => self.behind(link).collect(),
        }
    }

    /// What all ways to both go through.
    fn common(&self, mut a: usize, mut b: usize) -> usize {
        let end = self.layer.len();
        while a != b {
            let higher = |id: usize| self.layer.get(id).map(|layer| (*layer, id));
            if higher(a) > higher(b) {
                a = self.through[a];
            } else {
                b = self.through[b];
            }
            if a == end || b == end {
                return end;
            }
        }
        a
    }

    /// The nearest selection that all ways to a node go through.
    fn selection(&self, node: usize) -> usize {
        let mut up = self.through[node];
        while up < self.layer.len() && (up >= self.nodes || self.search.out[up].len() < 2) {
            up = self.through[up];
        }
        up
    }

    /// The main branch behind a node: the longest of its own. Where none has a step of its own, one that ends the selection from
    /// which this branch comes; then one that begins anew.
    fn main(&self, node: usize) -> Option<usize> {
        let selection = self.selection(node);
        let merit = |link: &usize| {
            let id = link + self.nodes;
            let joins = self.behind(*link).any(|next| self.through[next] == selection && selection < self.nodes);
            let anew = self.search.targets[*link].iter().any(|next| self.search.top[*next]);
            let kind = if joins { 2 } else { usize::from(anew) };
            (self.own[id], kind, self.long[id])
        };
        // The first of those that are equal.
        self.search.out[node].iter().rev().max_by_key(|link| merit(link)).copied()
    }
}
