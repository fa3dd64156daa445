//! Where everything stands from left to right: lines that go on straight are blocks, and blocks stand beside each other
//! as closely as they may (the coordinates of Brandes and Köpf, from the left only: the first branch goes on straight).

use crate::figure::Extent;
use crate::graph::{Graph, Kind};
use crate::order::places;
use crate::sorted::{List, sort, sort_by_key};

/// Between two neighbours in a layer.
const GAP: i32 = 2;
/// How often blocks move towards what they are connected with.
const ROUNDS: usize = 4;

/// The middle of each item.
pub(crate) fn place(graph: &Graph, extents: &[Extent]) -> Vec<i32> {
    let blocks = Blocks::of(graph);
    let mut x = blocks.leftmost(graph, extents);
    for _ in 0..ROUNDS {
        blocks.approach(graph, extents, &mut x);
    }
    blocks.of_item.iter().map(|block| x[*block]).list()
}

/// Items in adjacent layers that stand exactly below each other.
struct Blocks {
    of_item: Vec<usize>,
    /// The blocks, each after all that stand left of it.
    order: Vec<usize>,
}

impl Blocks {
    fn of(graph: &Graph) -> Self {
        let mut of_item = (0..graph.items.len()).list();
        let below = aligned(graph);
        for layer in &graph.layers {
            for id in layer {
                if let Some(lower) = below[*id] {
                    of_item[lower] = of_item[*id];
                }
            }
        }
        let order = Self::order(graph, &of_item);
        Self { of_item, order }
    }

    fn order(graph: &Graph, of_item: &[usize]) -> Vec<usize> {
        let count = graph.items.len();
        let (mut right, mut waiting) = (vec![Vec::new(); count], vec![0_usize; count]);
        for pair in graph.layers.iter().flat_map(|layer| layer.windows(2)) {
            right[of_item[pair[0]]].push(of_item[pair[1]]);
            waiting[of_item[pair[1]]] += 1;
        }
        let mut order = (0..count).filter(|id| of_item[*id] == *id && waiting[*id] == 0).list();
        let mut done = 0;
        while let Some(block) = order.get(done).copied() {
            done += 1;
            for other in &right[block] {
                waiting[*other] -= 1;
                if waiting[*other] == 0 {
                    order.push(*other);
                }
            }
        }
        order
    }

    /// As far left as the neighbours allow.
    fn leftmost(&self, graph: &Graph, extents: &[Extent]) -> Vec<i32> {
        let mut x = vec![0; graph.items.len()];
        let left = self.neighbours(graph, extents, true);
        let mut starts = vec![0; x.len()];
        for (item, block) in self.of_item.iter().enumerate() {
            starts[*block] = starts[*block].max(extents[item].left);
        }
        for block in &self.order {
            let bound = left[*block].iter().map(|(other, gap)| x[*other] + gap).max().unwrap_or(0);
            x[*block] = bound.max(starts[*block]);
        }
        x
    }

    /// The neighbours of each block on one side, with the distance to keep.
    fn neighbours(&self, graph: &Graph, extents: &[Extent], left: bool) -> Vec<Vec<(usize, i32)>> {
        let mut neighbours = vec![Vec::new(); graph.items.len()];
        for pair in graph.layers.iter().flat_map(|layer| layer.windows(2)) {
            let distance = extents[pair[0]].right + GAP + extents[pair[1]].left;
            let (a, b) = (self.of_item[pair[0]], self.of_item[pair[1]]);
            if left {
                neighbours[b].push((a, distance));
            } else {
                neighbours[a].push((b, distance));
            }
        }
        neighbours
    }

    /// Each block, from the right, moves right towards the middle of what it is connected with.
    fn approach(&self, graph: &Graph, extents: &[Extent], x: &mut [i32]) {
        let right = self.neighbours(graph, extents, false);
        let mut pulls = vec![Vec::new(); x.len()];
        for (upper, lower) in &graph.hops {
            let (a, b) = (self.of_item[*upper], self.of_item[*lower]);
            if a != b {
                pulls[a].push(b);
                pulls[b].push(a);
            }
        }
        for block in self.order.iter().rev() {
            // What goes up stays at the side.
            if pulls[*block].is_empty() || graph.items[*block].kind == Kind::Rise {
                continue;
            }
            let mut wanted = pulls[*block].iter().map(|other| x[*other]).list();
            sort(&mut wanted);
            let wanted = wanted[(wanted.len() - 1) / 2];
            let most = right[*block].iter().map(|(other, gap)| x[*other] - gap).min().unwrap_or(i32::MAX);
            x[*block] = wanted.min(most).max(x[*block]);
        }
    }
}

/// For each item the one below that stands straight under it: the main sequence first, then passing lines and other sequences,
/// then what has no other neighbour; never two that would cross.
fn aligned(graph: &Graph) -> Vec<Option<usize>> {
    let places = places(graph);
    let mut degrees = vec![(0_usize, 0_usize); graph.items.len()];
    let mut between: Vec<Vec<(usize, usize)>> = vec![Vec::new(); graph.layers.len()];
    for (upper, lower) in &graph.hops {
        degrees[*upper].1 += 1;
        degrees[*lower].0 += 1;
        between[graph.items[*upper].layer].push((*upper, *lower));
    }
    let line = |id: usize| usize::from(!matches!(graph.items[id].kind, Kind::Pass | Kind::Rise));
    let mut below = vec![None; graph.items.len()];
    for mut hops in between {
        sort_by_key(&mut hops, |(upper, lower)| {
            let branches = degrees[*upper].1 + degrees[*lower].0;
            // The main sequence first, then other lines that pass, then other sequences.
            let sequence = graph.straight.get((*upper, *lower)).copied();
            let passing = match line(*upper) + line(*lower) {
                0 => 0,
                1 => 2,
                _ => 1,
            };
            let other_sequence = usize::from(passing > 0 && sequence.is_none());
            (sequence != Some(0), other_sequence, passing, branches, places[*upper], places[*lower])
        });
        let mut taken: Vec<(usize, usize)> = Vec::new();
        for (upper, lower) in hops {
            let (a, b) = (places[upper], places[lower]);
            let fits = taken.iter().all(|(c, d)| (a < *c && b < *d) || (a > *c && b > *d));
            if fits {
                taken.push((a, b));
                below[upper] = Some(lower);
            }
        }
    }
    below
}
