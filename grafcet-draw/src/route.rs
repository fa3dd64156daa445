//! The lines between two layers.
//!
//! Between the layers lie rows for horizontal lines, first those that an item above spreads out (a divergence), then those
//! that an item below collects (a convergence). Lines of different nets never share a row where they would touch.

use crate::graph::{Graph, Kind};
use crate::shape::Drawing;

/// What a horizontal line is for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Purpose {
    /// One above, several below, or one aside.
    Spread,
    /// Several above, one below.
    Collect,
    /// From below a layer to what goes up.
    Turn,
}

/// What is connected by one horizontal line.
struct Net {
    /// Where lines from above end at it.
    uppers: Vec<i32>,
    /// Where lines down begin.
    lowers: Vec<i32>,
    /// Parallel branches.
    double: bool,
    /// What it is for.
    kind: Purpose,
    /// Its row below the upper layer, once it has one.
    row: i32,
}

impl Net {
    fn span(&self) -> (i32, i32) {
        let ends = || self.uppers.iter().chain(&self.lowers).copied();
        let over = i32::from(self.double);
        (ends().min().unwrap_or(0) - over, ends().max().unwrap_or(0) + over)
    }
}

/// A way from an item to one below; its nets by number.
struct Way {
    from: i32,
    port: i32,
    to: i32,
    spread: Option<usize>,
    collected: Option<usize>,
}

/// All between two layers.
pub(crate) struct Channel {
    nets: Vec<Net>,
    ways: Vec<Way>,
    /// How many rows it takes.
    pub(crate) height: i32,
}

/// The channel above a layer; that above layer 0 and that below the last hold only what goes up.
/// `hops` are those that end in it.
pub(crate) fn channel(graph: &Graph, x: &[i32], below: usize, hops: &[(usize, usize)]) -> Channel {
    let from_above: Vec<_> = graph.loops.iter().filter(|l| graph.items[l.to].layer == below).collect();
    let mut ends: Vec<usize> = hops.iter().map(|hop| hop.1).chain(from_above.iter().map(|l| l.to)).collect();
    ends.sort_by_key(|id| x[*id]);
    ends.dedup();
    let mut channel = Channel { nets: Vec::new(), ways: Vec::new(), height: 0 };
    channel.spread(graph, x, hops, &from_above);
    let spreads = channel.nets.len();
    for end in ends {
        let rises = from_above.iter().filter(|l| l.to == end).filter_map(|l| l.rises.first());
        channel.collect(graph, x, end, rises.map(|id| x[*id]).collect(), hops);
    }
    for turning in graph.loops.iter().filter(|l| l.from.iter().any(|id| graph.items[*id].layer + 1 == below)) {
        let uppers = turning.from.iter().chain(turning.rises.last()).map(|id| x[*id]).collect();
        channel.nets.push(Net { uppers, lowers: Vec::new(), double: false, kind: Purpose::Turn, row: 0 });
    }
    channel.rows(spreads, below > 0, below < graph.layers.len());
    channel
}

impl Channel {
    /// The ways, and the nets of what has several below it or has it aside.
    fn spread(&mut self, graph: &Graph, x: &[i32], hops: &[(usize, usize)], rising: &[&crate::graph::Loop]) {
        let mut starts: Vec<usize> = hops.iter().map(|hop| hop.0).collect();
        starts.sort_by_key(|id| x[*id]);
        starts.dedup();
        let mut shared: Vec<i32> = Vec::new();
        for start in starts {
            let mine: Vec<usize> = hops.iter().filter(|hop| hop.0 == start).map(|hop| hop.1).collect();
            let mut ports = Vec::new();
            for end in &mine {
                let others = hops.iter().filter(|hop| hop.1 == *end).count();
                let alone = others == 1 && !rising.iter().any(|l| l.to == *end);
                let port = match (alone, mine.len()) {
                    (true, _) => x[*end],
                    (false, 1) => x[start],
                    (false, _) => free(x[*end], &shared),
                };
                if !alone && mine.len() > 1 {
                    shared.push(port);
                }
                ports.push((port, *end));
            }
            let needed = mine.len() > 1 || ports.iter().any(|(port, _)| *port != x[start]);
            let spread = needed.then_some(self.nets.len());
            if needed {
                let double = mine.len() > 1 && matches!(graph.items[start].kind, Kind::Transition(_));
                let lowers = ports.iter().map(|(port, _)| *port).collect();
                self.nets.push(Net { uppers: vec![x[start]], lowers, double, kind: Purpose::Spread, row: 0 });
            }
            let ways = ports.iter().map(|(port, end)| Way {
                from: x[start],
                port: *port,
                to: x[*end],
                spread,
                collected: None,
            });
            self.ways.extend(ways);
        }
    }

    /// The net of an item with several above it.
    fn collect(&mut self, graph: &Graph, x: &[i32], end: usize, rises: Vec<i32>, hops: &[(usize, usize)]) {
        let count = hops.iter().filter(|hop| hop.1 == end).count();
        if count < 2 && rises.is_empty() {
            return;
        }
        let double = count > 1 && matches!(graph.items[end].kind, Kind::Transition(_));
        let number = self.nets.len();
        let mut uppers = Vec::new();
        for way in self.ways.iter_mut().filter(|way| way.to == x[end]) {
            way.collected = Some(number);
            uppers.push(way.port);
        }
        let mut lowers = rises;
        lowers.push(x[end]);
        self.nets.push(Net { uppers, lowers, double, kind: Purpose::Collect, row: 0 });
    }

    /// Gives every net a row: no two touch, and a line that comes down on a place ends above one that goes on from there.
    fn rows(&mut self, spreads: usize, above: bool, beneath: bool) {
        // A row is left free beside each layer.
        let mut row = 1 + i32::from(above);
        for range in [0..spreads, spreads..self.nets.len()] {
            let mut waiting: Vec<usize> = range.collect();
            waiting.sort_by_key(|id| self.nets[*id].span());
            while !waiting.is_empty() {
                let chosen = self.choose(&waiting);
                for id in &chosen {
                    self.nets[*id].row = row;
                }
                waiting.retain(|id| !chosen.contains(id));
                row += 1;
            }
        }
        self.height = if self.nets.is_empty() { i32::from(above && beneath) } else { row - i32::from(!beneath) };
    }

    /// What can share the next row.
    fn choose(&self, waiting: &[usize]) -> Vec<usize> {
        let held = |id: &usize| {
            let lowers = &self.nets[*id].lowers;
            waiting.iter().any(|other| other != id && self.nets[*other].uppers.iter().any(|x| lowers.contains(x)))
        };
        let mut chosen: Vec<usize> = Vec::new();
        for id in waiting.iter().filter(|id| !held(id)) {
            let (left, right) = self.nets[*id].span();
            let free = chosen.iter().all(|other| {
                let (from, to) = self.nets[*other].span();
                to + 2 < left || right + 2 < from
            });
            if free {
                chosen.push(*id);
            }
        }
        if chosen.is_empty() {
            // They hold each other: one line will touch another.
            chosen.extend(waiting.first());
        }
        chosen
    }

    /// Draws all lines: `above` is the last row of the upper layer, `below` the first of the lower one.
    pub(crate) fn draw(&self, above: i32, below: i32, to: &mut Drawing) {
        for way in &self.ways {
            let mut y = above;
            for (net, x) in [(way.spread, way.from), (way.collected, way.port)] {
                if let Some(net) = net {
                    let row = above + self.nets[net].row;
                    to.line((x, y), (x, row), false);
                    y = row;
                }
            }
            let last = if way.collected.is_some() { way.to } else { way.port };
            to.line((last, y), (last, below), false);
        }
        for net in &self.nets {
            let (row, (left, right)) = (above + net.row, net.span());
            to.line((left, row), (right, row), net.double);
            match net.kind {
                Purpose::Spread => {}
                Purpose::Collect => net.lowers.iter().for_each(|x| to.line((*x, row), (*x, below), false)),
                Purpose::Turn => net.uppers.iter().for_each(|x| to.line((*x, above), (*x, row), false)),
            }
        }
    }
}

/// A place at or beside `x` that no other line uses.
fn free(x: i32, taken: &[i32]) -> i32 {
    let beside = (0..).flat_map(|d| [x - 2 * d, x + 2 * d]);
    beside.take(64).find(|place| !taken.contains(place)).unwrap_or(x)
}
