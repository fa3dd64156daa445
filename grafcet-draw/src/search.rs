//! What leads down in a net, what leads back, and how far below each other steps and transitions stand.

use crate::sheets::Sheet;
use crate::sorted::{List, Map};

/// Depth first through a net, which finds the arcs that lead back.
pub(crate) struct Search<'n> {
    pub(crate) net: &'n Sheet,
    pub(crate) sources: Vec<Vec<usize>>,
    pub(crate) targets: Vec<Vec<usize>>,
    /// The transitions after each node, the main branch first.
    pub(crate) out: Vec<Vec<usize>>,
    /// Where the net begins: nothing leads down to these from what is not reached from them.
    pub(crate) top: Vec<bool>,
    /// Those from which the search begins.
    root: Vec<bool>,
    /// The number of each node and transition in the order of finding.
    pub(crate) node_key: Vec<Option<i64>>,
    pub(crate) link_key: Vec<Option<i64>>,
    keys: i64,
    /// The transitions after which the search has gone on, and those that waited for other nodes.
    expanded: Vec<bool>,
    waiting: Vec<usize>,
    /// Arcs that lead down, by transition.
    pub(crate) forward: Vec<Vec<usize>>,
    /// Arcs from a transition to a node above it.
    pub(crate) back: Vec<(usize, usize)>,
}

impl<'n> Search<'n> {
    pub(crate) fn new(net: &'n Sheet) -> Self {
        let mut index = Map::new();
        for (number, node) in net.nodes.iter().enumerate() {
            index.insert(*node, number);
        }
        let (nodes, links) = (net.nodes.len(), net.links.len());
        let sources = net.links.iter().map(|link| index.of(&link.sources)).list();
        let mut out = vec![Vec::new(); nodes];
        for (link, sources) in sources.iter().enumerate() {
            for node in sources {
                out[*node].push(link);
            }
        }
        Self {
            net,
            sources,
            targets: net.links.iter().map(|link| index.of(&link.targets)).list(),
            out,
            top: vec![false; nodes],
            root: vec![false; nodes],
            node_key: vec![None; nodes],
            link_key: vec![None; links],
            keys: 0,
            expanded: vec![false; links],
            waiting: Vec::new(),
            forward: vec![Vec::new(); links],
            back: Vec::new(),
        }
    }

    /// Finds everything, from these nodes in turn.
    pub(crate) fn run(&mut self, roots: &[usize]) {
        self.node_key.fill(None);
        self.link_key.fill(None);
        self.keys = 0;
        self.back.clear();
        self.forward.iter_mut().for_each(Vec::clear);
        self.root.fill(false);
        self.expanded.fill(false);
        for node in roots {
            if !self.top[*node] {
                self.force();
            }
            self.root[*node] = self.top[*node] && self.node_key[*node].is_none();
            self.visit(*node);
        }
        self.force();
        self.loose();
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
        for link in self.out[node].clone() {
            if self.link_key[link].is_none() {
                self.link_key[link] = Some(self.key());
            }
            // After an AND-convergence it goes on once all that it waits for is found.
            if self.sources[link].iter().all(|source| self.node_key[*source].is_some()) {
                self.expand(link);
            } else {
                self.waiting.push(link);
            }
        }
    }

    /// Goes on after a transition; what leads to where it comes from leads back.
    fn expand(&mut self, link: usize) {
        if std::mem::replace(&mut self.expanded[link], true) {
            return;
        }
        for target in self.targets[link].clone() {
            // What begins the net stands on top, wherever a line to it comes from.
            if self.root[target] || self.leads_to(target, link) {
                self.back.push((link, target));
            } else {
                self.forward[link].push(target);
                self.visit(target);
            }
        }
    }

    /// Whether a way down leads from a node to a transition.
    fn leads_to(&self, node: usize, link: usize) -> bool {
        let mut seen = vec![false; self.out.len()];
        let mut next = vec![node];
        while let Some(node) = next.pop() {
            if std::mem::replace(&mut seen[node], true) {
                continue;
            }
            if self.out[node].contains(&link) {
                return true;
            }
            next.extend(self.out[node].iter().flat_map(|link| &self.forward[*link]));
        }
        false
    }

    /// What waits in vain goes on.
    fn force(&mut self) {
        while let Some(link) = self.waiting.pop() {
            self.expand(link);
        }
    }

    /// Source transitions come last.
    fn loose(&mut self) {
        for link in 0..self.link_key.len() {
            self.expand(link);
            if self.link_key[link].is_none() {
                self.link_key[link] = Some(self.key());
            }
        }
    }
}

/// The layers of nodes and transitions: each below all that leads to it. What nothing leads to, as a source transition, stands
/// closely above what it leads to.
pub(crate) fn ranks(search: &Search<'_>) -> (Vec<usize>, Vec<usize>) {
    let mut nodes = vec![0; search.out.len()];
    let mut links = vec![1; search.sources.len()];
    let mut above = vec![0_usize; nodes.len()];
    search.forward.iter().flatten().for_each(|node| above[*node] += 1);
    let mut waiting = search.sources.iter().map(Vec::len).list();
    let mut ready = (0..nodes.len()).filter(|node| above[*node] == 0).list();
    let mut done = (0..links.len()).filter(|link| waiting[*link] == 0).list();
    loop {
        while let Some(link) = done.pop() {
            for node in &search.forward[link] {
                nodes[*node] = nodes[*node].max(links[link] + 1);
                above[*node] -= 1;
                if above[*node] == 0 {
                    ready.push(*node);
                }
            }
        }
        let Some(node) = ready.pop() else { break };
        for link in &search.out[node] {
            links[*link] = links[*link].max(nodes[node] + 1);
            waiting[*link] -= 1;
            if waiting[*link] == 0 {
                done.push(*link);
            }
        }
    }
    for (link, targets) in search.forward.iter().enumerate().filter(|(link, _)| search.sources[*link].is_empty()) {
        let upper = targets.iter().map(|node| nodes[*node]).min();
        links[link] = upper.map_or(links[link], |upper| upper - 1);
    }
    (nodes, links)
}
