//! A net in layers: steps and transitions take turns from top to bottom, and what leads up again leaves the graph.

use crate::search::{Search, ranks};
use crate::sequence::{Sequence, sequence};
use crate::sheets::{Link, Node, Sheet};
use crate::sorted::{List, Map, sort_by_key};
use crate::wording::Wording;

/// How many lines go up at the side of a net; other jumps back are written as references.
const LOOPS: usize = 2;
/// A jump forward over more layers than this is written as a reference where there are many.
const FAR: usize = 6;
/// So many jumps forward are drawn as lines, however long they are.
const MANY: usize = 6;

/// What may be tried to find the main sequence of a net: its steps times its transitions, so many times.
const EFFORT: usize = 100_000;

/// What stands in a layer.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Kind {
    /// In layers of even numbers.
    Node(Node),
    /// In place of a step: a reference to it.
    Jump(Node),
    /// By its number in the description, in layers of odd numbers.
    Transition(usize),
    /// In place of the steps above a transition that is written as `any`: what it leaves. By the transition's number.
    Any(usize),
    /// A line on its way down.
    Pass,
    /// A line on its way up.
    Rise,
}

/// One thing in a layer.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Item {
    pub(crate) kind: Kind,
    pub(crate) layer: usize,
    /// Its place among others before crossings are looked at: as the chart is read.
    pub(crate) key: i64,
}

/// A line that goes up at the side: from below its last layer to above its first.
#[derive(Clone, Debug)]
pub(crate) struct Loop {
    /// What leads into it, in its last layer.
    pub(crate) from: Vec<usize>,
    /// The lines on the way, from top to bottom.
    pub(crate) rises: Vec<usize>,
    /// The step it leads to, in its first layer.
    pub(crate) to: usize,
}

/// A net in layers.
#[derive(Default)]
pub(crate) struct Graph {
    pub(crate) items: Vec<Item>,
    /// From an item to one in the layer below.
    pub(crate) hops: Vec<(usize, usize)>,
    pub(crate) loops: Vec<Loop>,
    /// From a transition, by its number in the description, to a step: what is written as a reference.
    pub(crate) jumps: Vec<(usize, Node)>,
    /// From left to right.
    pub(crate) layers: Vec<Vec<usize>>,
    /// The hops of sequences, which are straight if they can be: the number of the sequence, 0 for the main one.
    pub(crate) straight: Map<(usize, usize), usize>,
    /// The hops from a step to its branches where these have an order: which of them comes first, from 1.
    pub(crate) ranks: Map<(usize, usize), usize>,
}

/// The layers of a net.
pub(crate) fn layered(wording: &Wording<'_>, net: &Sheet) -> Graph {
    let mut search = Search::new(net);
    let mut entered = vec![false; net.nodes.len()];
    search.targets.iter().flatten().for_each(|node| entered[*node] = true);
    let mut roots = (0..net.nodes.len()).list();
    // What is active first, then what is entered first, then what no transition leads to.
    sort_by_key(&mut roots, |node| (wording.begins(net.nodes[*node]), entered[*node], *node));
    let first = roots.first().map_or(0, |node| wording.begins(net.nodes[*node]));
    search.top = net.nodes.iter().map(|node| wording.begins(*node) == first).list();
    search.run(&roots);
    lengthen(&mut search, &roots);
    // Once more with the main branches first: who is named first in the source does not matter.
    let layers = ranks(&search);
    let main = sequence(&search, &layers.0).main;
    for (links, main) in search.out.iter_mut().zip(main) {
        sort_by_key(links, |link| Some(*link) != main);
    }
    search.run(&roots);
    let layers = ranks(&search);
    let sequence = sequence(&search, &layers.0);
    Builder::of(&search, wording, layers).build(&sequence)
}

/// In a circle that can be entered in several places, what leads back depends on the branch that is followed first: the one with which
/// the main sequence is longest.
fn lengthen(search: &mut Search<'_>, roots: &[usize]) {
    let Some(root) = roots.first().copied() else { return };
    let length = |search: &Search<'_>| sequence(search, &ranks(search).0).length(root);
    let mut longest = length(search);
    // Fewer tries in large nets, where each takes longer.
    let mut tries = (EFFORT / (search.out.len() * search.sources.len()).max(1)).min(60);
    for node in 0..search.out.len() {
        for branch in 1..search.out[node].len() {
            if tries == 0 {
                return search.run(roots);
            }
            tries -= 1;
            search.out[node][..=branch].rotate_right(1);
            search.run(roots);
            let now = length(search);
            if now > longest {
                longest = now;
            } else {
                search.out[node][..=branch].rotate_left(1);
            }
        }
    }
    search.run(roots);
}

/// A node and the transitions that lead back to it.
type Returns = (usize, Vec<usize>);

/// Items and hops from what the search has found.
struct Builder<'s> {
    search: &'s Search<'s>,
    wording: &'s Wording<'s>,
    graph: Graph,
    node_item: Vec<usize>,
    link_item: Vec<usize>,
}

impl<'s> Builder<'s> {
    fn of(
        search: &'s Search<'s>,
        wording: &'s Wording<'s>,
        (node_layer, link_layer): (Vec<usize>, Vec<usize>),
    ) -> Self {
        let mut graph = Graph::default();
        let key = |key: Option<i64>| key.unwrap_or_default() * 4;
        let mut item = |kind, layer, key| {
            graph.items.push(Item { kind, layer, key });
            graph.items.len() - 1
        };
        let nodes = search.net.nodes.iter().enumerate();
        let node_item = nodes.map(|(i, node)| item(Kind::Node(*node), node_layer[i], key(search.node_key[i]))).list();
        let links = search.net.links.iter().enumerate();
        let transition =
            |(i, link): (usize, &Link)| item(Kind::Transition(link.transition), link_layer[i], key(search.link_key[i]));
        let link_item = links.map(transition).list();
        Self { search, wording, graph, node_item, link_item }
    }

    fn build(mut self, sequence: &Sequence) -> Graph {
        let number = |ways: &[(usize, usize, usize)], from: usize, to: usize| {
            ways.iter().find(|way| (way.0, way.1) == (from, to)).map(|way| way.2)
        };
        let mut branches = vec![0; self.node_item.len()];
        for (link, sources) in self.search.sources.iter().enumerate() {
            for source in sources {
                let straight = number(&sequence.down, *source, link);
                let hop = self.descend(self.node_item[*source], self.link_item[link], straight);
                // What is gone has no rank among the others.
                if self.wording.is_gone(self.search.net.links[link].transition) {
                    continue;
                }
                branches[*source] += 1;
                if self.wording.ranks() && self.search.out[*source].len() > 1 {
                    self.graph.ranks.insert(hop, branches[*source]);
                }
            }
        }
        for link in 0..self.link_item.len() {
            if self.is_any(link) {
                self.connector(link);
            }
        }
        let (looped, jumps) = self.split();
        for (target, links) in looped {
            self.raise(target, &links);
        }
        for (link, targets) in self.search.targets.iter().enumerate() {
            for target in targets {
                if jumps.contains(&(link, *target)) {
                    self.jump(link, self.search.net.nodes[*target]);
                } else if !self.search.back.contains(&(link, *target)) {
                    let straight = number(&sequence.on, link, *target);
                    self.descend(self.link_item[link], self.node_item[*target], straight);
                }
            }
        }
        for (link, cut) in self.search.net.links.iter().enumerate() {
            cut.jumps.iter().for_each(|target| self.jump(link, *target));
        }
        let layers = self.graph.items.iter().map(|item| item.layer + 1).max().unwrap_or(0);
        self.graph.layers = vec![Vec::new(); layers];
        for (id, item) in self.graph.items.iter().enumerate() {
            self.graph.layers[item.layer].push(id);
        }
        self.graph
    }

    fn is_any(&self, link: usize) -> bool {
        self.wording.any(self.search.net.links[link].transition).is_some()
    }

    /// What an `any` leaves, above it.
    fn connector(&mut self, link: usize) {
        let below = self.link_item[link];
        let (layer, key) = (self.layer(below).saturating_sub(1), self.graph.items[below].key);
        let connector = self.item(Kind::Any(self.search.net.links[link].transition), layer, key);
        self.graph.hops.push((connector, below));
    }

    fn layer(&self, item: usize) -> usize {
        self.graph.items[item].layer
    }

    fn item(&mut self, kind: Kind, layer: usize, key: i64) -> usize {
        self.graph.items.push(Item { kind, layer, key });
        self.graph.items.len() - 1
    }

    /// A line down, through every layer between, of a sequence if it has a number; its first hop.
    fn descend(&mut self, from: usize, to: usize, straight: Option<usize>) -> (usize, usize) {
        let mut way = vec![from];
        for layer in self.layer(from) + 1..self.layer(to) {
            way.push(self.item(Kind::Pass, layer, self.graph.items[from].key + 1));
        }
        way.push(to);
        for pair in way.windows(2) {
            let hop = (pair[0], pair[1]);
            self.graph.hops.push(hop);
            if let Some(number) = straight {
                self.graph.straight.insert(hop, number);
            }
        }
        (way[0], way[1])
    }

    /// A reference below a transition.
    fn jump(&mut self, link: usize, target: Node) {
        let transition = self.link_item[link];
        let (layer, key) = (self.layer(transition) + 1, self.graph.items[transition].key + 1);
        let jump = self.item(Kind::Jump(target), layer, key);
        self.graph.hops.push((transition, jump));
        self.graph.jumps.push((self.search.net.links[link].transition, target));
    }

    /// A line up at the left side; the longer one is further outside.
    fn raise(&mut self, target: usize, links: &[usize]) {
        let to = self.node_item[target];
        let first = self.layer(to);
        let last = links.iter().map(|link| self.layer(self.link_item[*link])).max().unwrap_or(first);
        let mut from = Vec::new();
        for link in links {
            let mut upper = self.link_item[*link];
            for layer in self.layer(upper) + 1..=last {
                let pass = self.item(Kind::Pass, layer, self.graph.items[upper].key);
                self.graph.hops.push((upper, pass));
                upper = pass;
            }
            from.push(upper);
        }
        let key = -1 - i64::try_from(last - first).unwrap_or_default();
        let rises = (first..=last).map(|layer| self.item(Kind::Rise, layer, key)).list();
        self.graph.hops.extend(rises.windows(2).map(|pair| (pair[0], pair[1])));
        self.graph.loops.push(Loop { from, rises, to });
    }

    /// The steps that a line leads back to, with its transitions; and what is written as a reference.
    fn split(&self) -> (Vec<Returns>, Vec<(usize, usize)>) {
        let search = self.search;
        let mut looped: Map<usize, Vec<usize>> = Map::new();
        let rising = &search.back;
        for (link, target) in rising {
            // What can come from anywhere is no way back of the net.
            if search.targets[*link].len() == 1 && !self.is_any(*link) {
                looped.entry(*target).push(*link);
            }
        }
        let mut looped = looped.entries();
        sort_by_key(&mut looped, |(target, _)| self.layer(self.node_item[*target]));
        looped.truncate(LOOPS);
        let drawn = |arc: &(usize, usize)| looped.iter().any(|(to, links)| *to == arc.1 && links.contains(&arc.0));
        let mut jumps = rising.iter().copied().filter(|arc| !drawn(arc)).list();
        let mut far = Vec::new();
        for (link, targets) in search.targets.iter().enumerate() {
            let arcs = targets.iter().map(|target| (link, *target)).filter(|arc| !rising.contains(arc));
            far.extend(arcs.filter(|arc| self.layer(self.node_item[arc.1]) > self.layer(self.link_item[link]) + 1));
        }
        if far.len() > MANY {
            far.retain(|(link, to)| self.layer(self.node_item[*to]) > self.layer(self.link_item[*link]) + FAR);
            jumps.extend(far);
        }
        (looped, jumps)
    }
}
