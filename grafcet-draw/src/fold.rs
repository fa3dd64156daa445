//! Long nets in columns: a flow ends in a reference below a transition and goes on at the top of the next column.

use crate::graph::{Graph, Kind, layered};
use crate::sheets::{Link, Node, Sheet, pieces};
use crate::sorted::{List, Map, sort_by_key};
use crate::wording::Wording;

/// What has more rows than this is folded where a screen shows it.
pub(crate) const TALL: i32 = 120;
/// About so many rows are a column: what a screen shows.
const COLUMN: i32 = 60;

/// The columns of a net whose steps are all connected, in the order of the flow; parallel branches that are cut stand in
/// columns of their own.
pub(crate) fn columns(wording: &Wording<'_>, net: Sheet) -> Vec<Sheet> {
    let graph = layered(wording, &net);
    let heights = heights(wording, &graph);
    if heights.iter().sum::<i32>() <= wording.tall {
        return vec![net];
    }
    let layers = Layers::of(&graph);
    let cuts = cuts(&heights, &layers.costs(&net, heights.len()));
    split(net, &layers, &cuts).iter().flat_map(pieces).list()
}

/// The rows of each layer, with those of the lines after it: about.
fn heights(wording: &Wording<'_>, graph: &Graph) -> Vec<i32> {
    let none = Map::new();
    let height = |id: &usize| wording.figure(&graph.items[*id], &none).extent().height;
    graph.layers.iter().map(|layer| layer.iter().map(height).max().unwrap_or(0) + 2).list()
}

/// Where everything stands before the fold.
struct Layers {
    nodes: Map<Node, usize>,
    links: Map<usize, usize>,
}

impl Layers {
    fn of(graph: &Graph) -> Self {
        let mut layers = Self { nodes: Map::new(), links: Map::new() };
        for item in &graph.items {
            match item.kind {
                Kind::Node(node) => layers.nodes.insert(node, item.layer),
                Kind::Transition(id) => layers.links.insert(id, item.layer),
                Kind::Jump(_) | Kind::Any(_) | Kind::Pass | Kind::Rise => {}
            }
        }
        layers
    }

    fn node(&self, node: Node) -> usize {
        self.nodes.get(node).copied().unwrap_or_default()
    }

    fn link(&self, link: &Link) -> usize {
        self.links.get(link.transition).copied().unwrap_or_default()
    }

    /// How many lines down become references where the net is cut below each layer; `None` where it cannot be: a transition
    /// stands with all its steps above.
    fn costs(&self, net: &Sheet, layers: usize) -> Vec<Option<usize>> {
        let mut costs = vec![Some(0); layers];
        for link in &net.links {
            let here = self.link(link);
            for source in &link.sources {
                costs[self.node(*source).min(here)..here].fill(None);
            }
            for target in &link.targets {
                costs[here..self.node(*target).max(here)].iter_mut().flatten().for_each(|cost| *cost += 1);
            }
        }
        costs
    }
}

/// The layers below which the net is cut: where columns are about equally high, and there where it costs least.
fn cuts(heights: &[i32], costs: &[Option<usize>]) -> Vec<usize> {
    let total: i32 = heights.iter().sum();
    let wanted = total / (total / COLUMN).max(1);
    let (mut cuts, mut begin) = (Vec::new(), 0);
    loop {
        let mut bottom = begin;
        let first = cuts.last().map_or(0, |last| last + 1);
        let mut places = Vec::new();
        for layer in first..heights.len() {
            bottom += heights[layer];
            if let Some(cost) = costs[layer].filter(|_| bottom - begin >= wanted / 2 && total - bottom >= wanted / 2) {
                places.push(((bottom - begin - wanted).abs(), cost, layer, bottom));
            }
        }
        // The first that is too far away is what remains where there is none nearer.
        let near = |place: &&(i32, usize, usize, i32)| place.0 <= wanted / 2;
        let best = places.iter().filter(near).min_by_key(|place| (place.1, place.0)).or(places.first());
        match best {
            Some((.., layer, below)) if total - begin > wanted * 5 / 4 => {
                cuts.push(*layer);
                begin = *below;
            }
            _ => return cuts,
        }
    }
}

/// What stands between the cuts; a line over one of them is a reference.
fn split(net: Sheet, layers: &Layers, cuts: &[usize]) -> Vec<Sheet> {
    let column = |layer: usize| cuts.partition_point(|cut| *cut < layer);
    let mut columns = vec![Sheet::default(); cuts.len() + 1];
    let mut nodes = net.nodes;
    sort_by_key(&mut nodes, |node| layers.node(*node));
    for node in nodes {
        columns[column(layers.node(node))].nodes.push(node);
    }
    for mut link in net.links {
        let here = column(layers.link(&link));
        let (near, far) = link.targets.iter().partition(|target| column(layers.node(**target)) == here);
        (link.targets, link.jumps) = (near, far);
        columns[here].links.push(link);
    }
    columns
}
