//! A net in layers: steps and transitions take turns from top to bottom, and what leads up again leaves the graph.

use std::collections::BTreeMap;

use crate::sheets::{Link, Node, Sheet};

/// How many lines go up at the side of a net; other jumps back are written as references.
const LOOPS: usize = 2;
/// A jump forward over more layers than this is written as a reference where there are many.
const FAR: usize = 6;
/// So many jumps forward are drawn as lines, however long they are.
const MANY: usize = 6;

/// What stands in a layer.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Kind {
    /// In layers of even numbers.
    Node(Node),
    /// In place of a step: a reference to it.
    Jump(Node),
    /// By its number in the description, in layers of odd numbers.
    Transition(usize),
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
}

/// The layers of a net; `initial` says where it begins.
pub(crate) fn layered(net: &Sheet, initial: impl Fn(Node) -> bool) -> Graph {
    let mut search = Search::new(net);
    let (first, others): (Vec<_>, Vec<_>) = (0..net.nodes.len()).partition(|node| initial(net.nodes[*node]));
    for node in first.into_iter().chain(others) {
        search.visit(node);
    }
    search.loose();
    Builder::of(&search).build()
}

/// Depth first through a net, which finds the arcs that lead back.
struct Search<'n> {
    net: &'n Sheet,
    sources: Vec<Vec<usize>>,
    targets: Vec<Vec<usize>>,
    /// The transitions behind each node.
    out: Vec<Vec<usize>>,
    /// The number of each node and transition in the order of finding.
    node_key: Vec<Option<i64>>,
    link_key: Vec<Option<i64>>,
    keys: i64,
    open: Vec<bool>,
    /// Finished nodes, the last one first: an order in which arcs lead forward.
    order: Vec<usize>,
    /// Arcs from a transition to a node above it.
    back: Vec<(usize, usize)>,
}

impl<'n> Search<'n> {
    fn new(net: &'n Sheet) -> Self {
        let index: BTreeMap<Node, usize> = net.nodes.iter().enumerate().map(|(i, node)| (*node, i)).collect();
        let known = |nodes: &[Node]| nodes.iter().filter_map(|node| index.get(node).copied()).collect::<Vec<_>>();
        let (nodes, links) = (net.nodes.len(), net.links.len());
        let sources: Vec<_> = net.links.iter().map(|link: &Link| known(&link.sources)).collect();
        let mut out = vec![Vec::new(); nodes];
        for (link, sources) in sources.iter().enumerate() {
            for node in sources {
                out[*node].push(link);
            }
        }
        Self {
            net,
            sources,
            targets: net.links.iter().map(|link| known(&link.targets)).collect(),
            out,
            node_key: vec![None; nodes],
            link_key: vec![None; links],
            keys: 0,
            open: vec![false; nodes],
            order: Vec::new(),
            back: Vec::new(),
        }
    }

    fn key(&mut self) -> i64 {
        self.keys += 1;
        self.keys
    }

    /// As deep as a net has steps, which is bounded.
    fn visit(&mut self, node: usize) {
        if self.node_key[node].is_some() {
            return;
        }
        self.node_key[node] = Some(self.key());
        self.open[node] = true;
        for link in self.out[node].clone() {
            if self.link_key[link].is_none() {
                self.link_key[link] = Some(self.key());
            }
            for target in self.targets[link].clone() {
                if !self.open[target] {
                    self.visit(target);
                } else if !self.back.contains(&(link, target)) {
                    self.back.push((link, target));
                }
            }
        }
        self.open[node] = false;
        self.order.push(node);
    }

    /// Source transitions come last.
    fn loose(&mut self) {
        for link in 0..self.link_key.len() {
            if self.link_key[link].is_none() {
                self.link_key[link] = Some(self.key());
            }
        }
    }
}

/// A node and the transitions that lead back to it.
type Returns = (usize, Vec<usize>);

/// Items and hops from what the search has found.
struct Builder<'s> {
    search: &'s Search<'s>,
    graph: Graph,
    node_item: Vec<usize>,
    link_item: Vec<usize>,
}

impl<'s> Builder<'s> {
    fn of(search: &'s Search<'s>) -> Self {
        let (node_layer, link_layer) = ranks(search);
        let mut graph = Graph::default();
        let key = |key: Option<i64>| key.unwrap_or_default() * 4;
        let mut item = |kind, layer, key| {
            graph.items.push(Item { kind, layer, key });
            graph.items.len() - 1
        };
        let nodes = search.net.nodes.iter().enumerate();
        let node_item =
            nodes.map(|(i, node)| item(Kind::Node(*node), node_layer[i], key(search.node_key[i]))).collect();
        let links = search.net.links.iter().enumerate();
        let transition =
            |(i, link): (usize, &Link)| item(Kind::Transition(link.transition), link_layer[i], key(search.link_key[i]));
        let link_item = links.map(transition).collect();
        Self { search, graph, node_item, link_item }
    }

    fn build(mut self) -> Graph {
        for (link, sources) in self.search.sources.iter().enumerate() {
            for source in sources {
                self.descend(self.node_item[*source], self.link_item[link]);
            }
        }
        let (looped, jumps) = self.split();
        let rising = self.rising();
        for (target, links) in looped {
            self.raise(target, &links);
        }
        for (link, targets) in self.search.targets.iter().enumerate() {
            for target in targets {
                if jumps.contains(&(link, *target)) {
                    self.jump(link, self.search.net.nodes[*target]);
                } else if !rising.contains(&(link, *target)) {
                    self.descend(self.link_item[link], self.node_item[*target]);
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

    fn layer(&self, item: usize) -> usize {
        self.graph.items[item].layer
    }

    fn item(&mut self, kind: Kind, layer: usize, key: i64) -> usize {
        self.graph.items.push(Item { kind, layer, key });
        self.graph.items.len() - 1
    }

    /// A line down, through every layer between.
    fn descend(&mut self, from: usize, to: usize) {
        let mut upper = from;
        for layer in self.layer(from) + 1..self.layer(to) {
            let pass = self.item(Kind::Pass, layer, self.graph.items[from].key + 1);
            self.graph.hops.push((upper, pass));
            upper = pass;
        }
        self.graph.hops.push((upper, to));
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
        let rises: Vec<_> = (first..=last).map(|layer| self.item(Kind::Rise, layer, key)).collect();
        self.graph.hops.extend(rises.windows(2).map(|pair| (pair[0], pair[1])));
        self.graph.loops.push(Loop { from, rises, to });
    }

    /// The arcs that lead up on paper. These are the arcs back, as a rule; where a transition has several sources, one that
    /// leads back from the first may lead down from the last, and the other way round.
    fn rising(&self) -> Vec<(usize, usize)> {
        let search = self.search;
        let leads_up = |arc: &(usize, usize)| self.layer(self.node_item[arc.1]) < self.layer(self.link_item[arc.0]);
        let mut rising: Vec<_> = search.back.iter().copied().filter(leads_up).collect();
        for (link, targets) in search.targets.iter().enumerate() {
            let arcs = targets.iter().map(|target| (link, *target)).filter(leads_up);
            rising.extend(arcs.filter(|arc| !search.back.contains(arc)));
        }
        rising
    }

    /// The steps that a line leads back to, with its transitions; and what is written as a reference.
    fn split(&self) -> (Vec<Returns>, Vec<(usize, usize)>) {
        let search = self.search;
        let mut looped: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        let rising = self.rising();
        for (link, target) in &rising {
            if search.targets[*link].len() == 1 {
                looped.entry(*target).or_default().push(*link);
            }
        }
        let mut looped: Vec<_> = looped.into_iter().collect();
        looped.sort_by_key(|(target, _)| self.layer(self.node_item[*target]));
        looped.truncate(LOOPS);
        let drawn = |arc: &(usize, usize)| looped.iter().any(|(to, links)| *to == arc.1 && links.contains(&arc.0));
        let mut jumps: Vec<_> = rising.iter().copied().filter(|arc| !drawn(arc)).collect();
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

/// The layers of nodes and transitions: each below all that leads to it.
fn ranks(search: &Search<'_>) -> (Vec<usize>, Vec<usize>) {
    let mut nodes = vec![0; search.node_key.len()];
    let mut links = vec![1; search.link_key.len()];
    let mut before: Vec<Vec<usize>> = vec![Vec::new(); nodes.len()];
    for (link, targets) in search.targets.iter().enumerate() {
        for target in targets.iter().filter(|target| !search.back.contains(&(link, **target))) {
            before[*target].push(link);
        }
    }
    for node in search.order.iter().rev() {
        nodes[*node] = before[*node].iter().map(|link| links[*link] + 1).max().unwrap_or(0);
        for link in &search.out[*node] {
            links[*link] = links[*link].max(nodes[*node] + 1);
        }
    }
    (nodes, links)
}
