//! Who stands left of whom: as the chart is read, and then with fewer crossings where that is possible.

use crate::graph::{Graph, Kind};
use crate::sorted::{List, sort_by_key};

/// How often the layers are gone through, down and up.
const SWEEPS: usize = 4;

/// Orders every layer of a graph.
pub(crate) fn order(graph: &mut Graph) {
    let items = &graph.items;
    for layer in &mut graph.layers {
        sort_by_key(layer, |id| (items[*id].key, *id));
    }
    let (mut best, mut least) = (graph.layers.clone(), crossings(graph));
    for sweep in 0..SWEEPS {
        if least == 0 {
            break;
        }
        sort(graph, sweep % 2 == 0);
        let now = crossings(graph);
        if now < least {
            (best, least) = (graph.layers.clone(), now);
        }
    }
    graph.layers = best;
}

/// Places of the items in their layers.
pub(crate) fn places(graph: &Graph) -> Vec<usize> {
    let mut places = vec![0; graph.items.len()];
    for layer in &graph.layers {
        layer.iter().enumerate().for_each(|(place, id)| places[*id] = place);
    }
    places
}

/// Puts each item where its neighbours in the layer above (or below) are in the mean.
fn sort(graph: &mut Graph, down: bool) {
    let neighbours = neighbours(graph, down);
    let count = graph.layers.len();
    let mut places = places(graph);
    for step in 1..count {
        let layer = if down { step } else { count - 1 - step };
        let mean = |id: usize| {
            // What goes up stays at the side.
            if graph.items[id].kind == Kind::Rise {
                return -1;
            }
            let near = &neighbours[id];
            let sum: usize = near.iter().map(|other| places[*other]).sum();
            let scaled = (sum * 1024).checked_div(near.len()).unwrap_or(places[id] * 1024);
            i64::try_from(scaled).unwrap_or(i64::MAX)
        };
        let mut keyed = graph.layers[layer].iter().map(|id| (mean(*id), places[*id], *id)).list();
        sort_by_key(&mut keyed, |key| *key);
        let sorted = keyed.into_iter().map(|(.., id)| id).list();
        sorted.iter().enumerate().for_each(|(place, id)| places[*id] = place);
        graph.layers[layer] = sorted;
    }
}

fn neighbours(graph: &Graph, above: bool) -> Vec<Vec<usize>> {
    let mut neighbours = vec![Vec::new(); graph.items.len()];
    for (upper, lower) in &graph.hops {
        if above {
            neighbours[*lower].push(*upper);
        } else {
            neighbours[*upper].push(*lower);
        }
    }
    neighbours
}

/// How many pairs of lines cross.
fn crossings(graph: &Graph) -> usize {
    let places = places(graph);
    let mut lines: Vec<Vec<(usize, usize)>> = vec![Vec::new(); graph.layers.len()];
    for (upper, lower) in &graph.hops {
        lines[graph.items[*upper].layer].push((places[*upper], places[*lower]));
    }
    let pairs = |lines: &Vec<(usize, usize)>| {
        let crossed = |a: &(usize, usize)| lines.iter().filter(|b| a.0 < b.0 && a.1 > b.1).count();
        lines.iter().map(crossed).sum::<usize>()
    };
    lines.iter().map(pairs).sum()
}
