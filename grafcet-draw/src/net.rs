//! One net on paper.

use crate::figure::{Extent, Figure, Scene};
use crate::graph::{Graph, layered};
use crate::order::order;
use crate::place::place;
use crate::route::{Channel, channel};
use crate::shape::{Drawing, Shape};
use crate::sheets::Sheet;

/// Draws a net whose steps are all connected.
pub(crate) fn draw(scene: &Scene<'_>, net: &Sheet) -> Drawing {
    let mut graph = layered(net, |node| scene.is_initial(node));
    order(&mut graph);
    let figures: Vec<Figure> = graph.items.iter().map(|item| scene.figure(item)).collect();
    let extents: Vec<Extent> = figures.iter().map(Figure::extent).collect();
    let x = place(&graph, &extents);
    let channels: Vec<Channel> = (0..=graph.layers.len()).map(|below| channel(&graph, &x, below)).collect();
    let mut drawing = Drawing::default();
    let mut last = -1;
    for (layer, items) in graph.layers.iter().enumerate() {
        let channel = &channels[layer];
        let y = last + 1 + channel.height;
        channel.draw(last, y, &mut drawing);
        last = y + items.iter().map(|id| extents[*id].height).max().unwrap_or(0);
        for id in items {
            figures[*id].draw(x[*id], y, last, &mut drawing);
            let (enter, leave) = figures[*id].ports();
            drawing.line((x[*id], y), (x[*id], y + enter), false);
            if leads_on(&graph, *id) {
                drawing.line((x[*id], y + leave), (x[*id], last), false);
            }
        }
    }
    if let Some(channel) = channels.last() {
        channel.draw(last, last + channel.height, &mut drawing);
        last += channel.height;
    }
    arrows(&graph, &x, &mut drawing);
    finish(drawing, &graph, &x, &extents, last + 1)
}

/// Whether a line leaves an item downwards.
fn leads_on(graph: &Graph, id: usize) -> bool {
    graph.hops.iter().any(|hop| hop.0 == id) || graph.loops.iter().any(|l| l.from.contains(&id))
}

/// What goes up has an arrow (IEC 60848, 4.6): in the middle of its way.
fn arrows(graph: &Graph, x: &[i32], drawing: &mut Drawing) {
    for upward in &graph.loops {
        let Some(place) = upward.rises.first().map(|id| x[*id]) else { continue };
        let ends = drawing.shapes.iter().filter_map(|shape| match shape {
            Shape::Line { from, to, .. } if from.0 == place && to.0 == place => Some((from.1, to.1)),
            _ => None,
        });
        let (top, bottom) = ends.fold((i32::MAX, i32::MIN), |(top, bottom), (a, b)| (top.min(a), bottom.max(b)));
        if top < bottom {
            drawing.shapes.push(Shape::Arrow { at: (place, i32::midpoint(top, bottom)), up: true });
        }
    }
}

/// The paper's size, and no line twice.
fn finish(mut drawing: Drawing, graph: &Graph, x: &[i32], extents: &[Extent], height: i32) -> Drawing {
    let mut seen = std::collections::BTreeSet::new();
    drawing.shapes.retain(|shape| !matches!(shape, Shape::Line { .. }) || seen.insert(shape.clone()));
    let left = (0..graph.items.len()).map(|id| x[id] - extents[id].left).min().unwrap_or(0);
    drawing.width = (0..graph.items.len()).map(|id| x[id] + extents[id].right + 1).max().unwrap_or(0) - left;
    drawing.height = height;
    let mut moved = Drawing::default();
    let (width, height) = (drawing.width, drawing.height);
    moved.paste(drawing, (-left, 0));
    (moved.width, moved.height) = (width, height);
    moved
}
