//! The lines between two layers.
//!
//! Between the layers lie rows for horizontal lines, first those that an item above spreads out (a divergence), then those
//! that an item below collects (a convergence). Lines of different nets never share a row where they would touch.

use crate::graph::{Graph, Kind};
use crate::shape::{Drawing, Shape};
use crate::sorted::{List, sort_by_key};

/// Lines that go down beside each other are so far apart: there is room for a number between them.
const APART: i32 = 3;

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
    /// Where nets held each other, this one has two rows: the place of the line between them, and the upper row. The lines
    /// from above end there, those down begin in `row`.
    bend: Option<(i32, i32)>,
}

impl Net {
    fn new(uppers: Vec<i32>, lowers: Vec<i32>, double: bool, kind: Purpose) -> Self {
        Self { uppers, lowers, double, kind, row: 0, bend: None }
    }

    /// The row in which lines from above end.
    fn top(&self) -> i32 {
        self.bend.map_or(self.row, |(_, row)| row)
    }

    /// The places of the lines from above to the row that is not given yet.
    fn arriving(&self) -> &[i32] {
        match &self.bend {
            Some((place, _)) => std::slice::from_ref(place),
            None => &self.uppers,
        }
    }

    /// From where to where a line reaches that connects these places.
    fn reach(places: impl Iterator<Item = i32> + Clone, double: bool) -> (i32, i32) {
        let over = i32::from(double);
        (places.clone().min().unwrap_or(0) - over, places.max().unwrap_or(0) + over)
    }

    /// Of the row that is not given yet.
    fn span(&self) -> (i32, i32) {
        Self::reach(self.arriving().iter().chain(&self.lowers).copied(), self.double && self.doubles_below())
    }

    /// Of the upper of two rows.
    fn upper_span(&self) -> Option<(i32, i32)> {
        let (place, _) = self.bend?;
        Some(Self::reach(self.uppers.iter().copied().chain([place]), self.double && !self.doubles_below()))
    }

    /// Where a line goes on across and another goes through, a dot says that they are connected.
    fn dots(&self, above: i32, to: &mut Drawing) {
        let mut row = |row: i32, double: bool, arriving: &[i32], leaving: &[i32], (left, right): (i32, i32)| {
            let joined = arriving.iter().filter(|x| leaving.contains(x) && left < **x && **x < right);
            if !double {
                to.shapes.extend(joined.map(|x| Shape::Dot { at: (*x, above + row) }));
            }
        };
        row(self.row, self.double && self.doubles_below(), self.arriving(), &self.lowers, self.span());
        if let (Some((place, top)), Some(span)) = (self.bend, self.upper_span()) {
            row(top, self.double && !self.doubles_below(), &self.uppers, &[place], span);
        }
    }

    /// Of two rows, the double line is the one with the branches.
    fn doubles_below(&self) -> bool {
        self.bend.is_none() || self.kind == Purpose::Spread
    }
}

/// A way from an item to one below; its nets by number.
struct Connection {
    from: i32,
    port: i32,
    to: i32,
    spread: Option<usize>,
    collected: Option<usize>,
}

/// All between two layers.
pub(crate) struct Channel {
    nets: Vec<Net>,
    ways: Vec<Connection>,
    /// The numbers of branches beside their lines: place and number; and their row, in which no line goes across.
    ranks: Vec<(i32, usize)>,
    rank_row: i32,
    /// How many rows it takes.
    pub(crate) height: i32,
}

/// The channel above a layer; that above layer 0 and that below the last hold only what goes up.
/// `hops` are those that end in it.
pub(crate) fn channel(graph: &Graph, x: &[i32], below: usize, hops: &[(usize, usize)]) -> Channel {
    let from_above = graph.loops.iter().filter(|l| graph.items[l.to].layer == below).list();
    let mut ends = hops.iter().map(|hop| hop.1).chain(from_above.iter().map(|l| l.to)).list();
    sort_by_key(&mut ends, |id| x[*id]);
    ends.dedup();
    let mut channel = Channel { nets: Vec::new(), ways: Vec::new(), ranks: Vec::new(), rank_row: 0, height: 0 };
    // Where a line stands in this channel, whichever it is.
    let beside = |item: &crate::graph::Item| item.layer + 1 == below || item.layer == below;
    let taken = (0..x.len()).filter(|id| beside(&graph.items[*id])).map(|id| x[id]).list();
    let turns = graph
        .loops
        .iter()
        .filter(|l| l.from.iter().any(|id| graph.items[*id].layer + 1 == below))
        .map(|l| l.from.iter().chain(l.rises.last()).map(|id| x[*id]).list())
        .list();
    // What has one line from above, and above it nothing that comes down further than where that line starts.
    let alone = |end: usize| {
        let hops = hops.iter().filter(|hop| hop.1 == end).count();
        hops == 1 && !from_above.iter().any(|l| l.to == end) && !turns.iter().flatten().any(|turn| *turn == x[end])
    };
    channel.spread(graph, x, hops, alone, taken);
    let spreads = channel.nets.len();
    for end in ends.into_iter().filter(|end| !alone(*end)) {
        let rises = from_above.iter().filter(|l| l.to == end).filter_map(|l| l.rises.first());
        channel.collect(graph, x, end, rises.map(|id| x[*id]).list(), hops);
    }
    for uppers in turns {
        channel.nets.push(Net::new(uppers, Vec::new(), false, Purpose::Turn));
    }
    channel.rows(spreads, below > 0, below < graph.layers.len());
    channel
}

impl Channel {
    /// The ways, and the nets of what has several below it or has it aside; `taken` are the places of other lines.
    fn spread(
        &mut self,
        graph: &Graph,
        x: &[i32],
        hops: &[(usize, usize)],
        alone: impl Fn(usize) -> bool,
        mut taken: Vec<i32>,
    ) {
        let mut starts = hops.iter().map(|hop| hop.0).list();
        sort_by_key(&mut starts, |id| x[*id]);
        starts.dedup();
        for start in starts {
            let mut mine = hops.iter().filter(|hop| hop.0 == start).map(|hop| hop.1).list();
            sort_by_key(&mut mine, |id| x[*id]);
            let mut ports = Vec::new();
            for end in &mine {
                // Below here, or close to it, something else stands, to which a line comes down from aside.
                let close = |id: usize| (x[id] - x[start]).abs() < APART;
                let over = || hops.iter().any(|hop| hop.0 != start && close(hop.1) && alone(hop.1));
                let port = match (alone(*end), mine.len()) {
                    (true, _) => x[*end],
                    (false, 1) if !over() => x[start],
                    // Straight on, or where no other line is: a line of its own between the two it leads to.
                    (false, _) if x[*end] == x[start] && !over() => x[start],
                    (false, _) => free(x[*end], &taken),
                };
                taken.push(port);
                ports.push((port, *end));
                if let Some(rank) = graph.ranks.get((start, *end)) {
                    self.ranks.push((port, *rank));
                }
            }
            let needed = mine.len() > 1 || ports.iter().any(|(port, _)| *port != x[start]);
            let spread = needed.then_some(self.nets.len());
            if needed {
                let double = mine.len() > 1 && matches!(graph.items[start].kind, Kind::Transition(_));
                let lowers = ports.iter().map(|(port, _)| *port).list();
                self.nets.push(Net::new(vec![x[start]], lowers, double, Purpose::Spread));
            }
            let ways = ports.iter().map(|(port, end)| Connection {
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
        let double = count > 1 && matches!(graph.items[end].kind, Kind::Transition(_));
        let number = self.nets.len();
        let mut uppers = Vec::new();
        for way in self.ways.iter_mut().filter(|way| way.to == x[end]) {
            way.collected = Some(number);
            uppers.push(way.port);
        }
        let mut lowers = rises;
        lowers.push(x[end]);
        self.nets.push(Net::new(uppers, lowers, double, Purpose::Collect));
    }

    /// Gives every net a row: no two touch, and a line that comes down on a place ends above one that goes on from there.
    fn rows(&mut self, spreads: usize, above: bool, beneath: bool) {
        // A row is left free beside each layer.
        let mut row = 1 + i32::from(above);
        for range in [0..spreads, spreads..self.nets.len()] {
            let mut waiting = range.clone().list();
            sort_by_key(&mut waiting, |id| self.nets[*id].span());
            while !waiting.is_empty() {
                let chosen = self.choose(&waiting);
                if chosen.is_empty() {
                    self.bend(&waiting, row);
                }
                for id in &chosen {
                    self.nets[*id].row = row;
                }
                waiting.retain(|id| !chosen.contains(id));
                row += 1;
            }
            if range.start == 0 && !self.ranks.is_empty() {
                self.rank_row = row;
                row += i32::from(spreads < self.nets.len());
            }
        }
        self.height = if self.nets.is_empty() { i32::from(above && beneath) } else { row - i32::from(!beneath) };
    }

    /// What can share the next row; nothing where the nets hold each other in a circle.
    fn choose(&self, waiting: &[usize]) -> Vec<usize> {
        let held = |id: &usize| waiting.iter().any(|other| other != id && self.holds(*other, *id));
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
        chosen
    }

    /// Whether a line that comes down to a net is at a place where one goes down from the other.
    fn holds(&self, net: usize, other: usize) -> bool {
        self.nets[net].arriving().iter().any(|x| self.nets[other].lowers.contains(x))
    }

    /// Of nets that hold each other in a circle, gives one a first row, with a line down from there where there is no other:
    /// now it holds no net any more.
    fn bend(&mut self, waiting: &[usize], row: i32) {
        let holding = |id: &&usize| waiting.iter().any(|other| other != *id && self.holds(**id, *other));
        // As few branches as can be, so that a double line stays in one piece.
        let Some(id) = waiting.iter().filter(holding).min_by_key(|id| self.nets[**id].uppers.len()).copied() else {
            return;
        };
        let (left, right) = self.nets[id].span();
        let place = self.unused(left, right);
        self.nets[id].bend = Some((place, row));
    }

    /// A place where no line goes down, between these two if there is one; with room on both sides if there is.
    fn unused(&self, left: i32, right: i32) -> i32 {
        let bends = self.nets.iter().filter_map(|net| net.bend.map(|(place, _)| place));
        let ends = self.nets.iter().flat_map(|net| net.uppers.iter().chain(&net.lowers).copied());
        let ways = self.ways.iter().flat_map(|way| [way.from, way.port, way.to]);
        let taken = bends.chain(ends).chain(ways).list();
        let (first, last) = (taken.iter().min().copied().unwrap_or(left), taken.iter().max().copied().unwrap_or(right));
        let free = |x: &i32, room: i32| taken.iter().all(|other| (other - x).abs() > room);
        let places = || (left + 1..right).chain((first..left).rev()).chain(right..=last);
        places().find(|x| free(x, 1)).or_else(|| places().find(|x| free(x, 0))).unwrap_or(last + 1)
    }

    /// Draws all lines: `above` is the last row of the upper layer, `below` the first of the lower one.
    pub(crate) fn draw(&self, above: i32, below: i32, to: &mut Drawing) {
        for way in &self.ways {
            let mut y = above;
            for (net, x) in [(way.spread, way.from), (way.collected, way.port)] {
                if let Some(net) = net {
                    to.line((x, y), (x, above + self.nets[net].top()), false);
                    y = above + self.nets[net].row;
                }
            }
            let last = if way.collected.is_some() { way.to } else { way.port };
            to.line((last, y), (last, below), false);
        }
        for net in &self.nets {
            let (row, (left, right)) = (above + net.row, net.span());
            to.line((left, row), (right, row), net.double && net.doubles_below());
            if let (Some((place, top)), Some((left, right))) = (net.bend, net.upper_span()) {
                to.line((left, above + top), (right, above + top), net.double && !net.doubles_below());
                to.line((place, above + top), (place, row), false);
            }
            net.dots(above, to);
            match net.kind {
                Purpose::Spread => {}
                Purpose::Collect => net.lowers.iter().for_each(|x| to.line((*x, row), (*x, below), false)),
                Purpose::Turn => net.uppers.iter().for_each(|x| to.line((*x, above), (*x, above + net.top()), false)),
            }
        }
        for (x, rank) in &self.ranks {
            to.text((x + 1, above + self.rank_row), &rank.to_string());
        }
    }
}

/// A place beside `x` that is free, with room for a number on its right. There is one, at the latest beyond all lines.
fn free(x: i32, taken: &[i32]) -> i32 {
    let far = taken.iter().map(|place| (place - x).abs()).max().unwrap_or(0) + APART;
    let mut beside = (1..=far).flat_map(|d| [x - d, x + d]);
    beside.find(|place| taken.iter().all(|other| (other - place).abs() >= APART)).unwrap_or(x + far)
}

#[cfg(test)]
mod tests;
