//! One net on paper.

use crate::figure::{Extent, Figure};
use crate::fold::columns;
use crate::graph::{Graph, Kind, layered};
use crate::order::order;
use crate::place::place;
use crate::route::channel;
use crate::shape::{Drawing, Heading, Shape};
use crate::sheets::{Sheet, pieces};
use crate::sorted::{List, sort};
use crate::wording::{Density, Origin, References, Wording};
use crate::wrap::width;

/// Wider nets are drawn anew densely: what fits a page that is scaled to three fifths.
const WIDE: i32 = 180;

/// Draws the nets of a sheet, long ones in columns.
pub(crate) fn draw(wording: &Wording<'_>, sheet: &Sheet) -> Vec<Drawing> {
    let columns = pieces(sheet).into_iter().flat_map(|net| columns(wording, net));
    let graphs = columns.map(|net| {
        let mut graph = layered(wording, &net);
        order(&mut graph);
        graph
    });
    let graphs = graphs.list();
    let references = references(sheet, &graphs);
    let dense = Wording { active: wording.active.clone(), density: Density::DENSE, ..*wording };
    let drawings = graphs.iter().map(|graph| {
        let drawing = drawn(wording, graph, &references);
        if drawing.width > WIDE { drawn(&dense, graph, &references) } else { drawing }
    });
    drawings.list()
}

/// The steps that lead to others by references, each once, as they stand on paper.
fn references(sheet: &Sheet, graphs: &[Graph]) -> References {
    let mut references = References::new();
    for (transition, target) in graphs.iter().flat_map(|graph| &graph.jumps) {
        let from: &mut Vec<Origin> = references.entry(*target);
        let sources = sheet.links.iter().filter(|link| link.transition == *transition).flat_map(|link| &link.sources);
        let mut origins = sources.map(|node| Origin::Node(*node)).list();
        if origins.is_empty() {
            origins.push(Origin::Source(*transition));
        }
        origins.retain(|origin| !from.contains(origin));
        from.extend(origins);
    }
    references
}

/// A net whose steps are all connected.
fn drawn(wording: &Wording<'_>, graph: &Graph, references: &References) -> Drawing {
    let figures = graph.items.iter().map(|item| wording.figure(item, references)).list();
    let extents = figures.iter().map(Figure::extent).list();
    let x = place(graph, &extents);
    let mut hops = vec![Vec::new(); graph.layers.len() + 1];
    let (mut leads_on, mut entered) = (vec![false; graph.items.len()], vec![false; graph.items.len()]);
    for (upper, lower) in &graph.hops {
        hops[graph.items[*lower].layer].push((*upper, *lower));
        (leads_on[*upper], entered[*lower]) = (true, true);
    }
    for upward in &graph.loops {
        upward.from.iter().for_each(|id| leads_on[*id] = true);
        entered[upward.to] = true;
    }
    for (item, entered) in graph.items.iter().zip(&mut entered) {
        *entered |= matches!(item.kind, Kind::Node(node) if references.get(node).is_some());
    }
    let channels = hops.iter().enumerate().map(|(below, hops)| channel(graph, &x, below, hops));
    let channels = channels.list();
    let mut drawing = Drawing::default();
    let mut last = -1;
    let mut rows = Vec::new();
    for (layer, items) in graph.layers.iter().enumerate() {
        let channel = &channels[layer];
        let y = last + 1 + channel.height;
        channel.draw(last, y, &mut drawing);
        let rise = items.iter().map(|id| figures[*id].ports().0).max().unwrap_or(0);
        let lowered = |id: usize| figures[id].lowered(rise);
        last = y + items.iter().map(|id| extents[*id].height + lowered(*id)).max().unwrap_or(0);
        rows.push((y, last));
        for id in items {
            let top = y + lowered(*id);
            figures[*id].draw(x[*id], top, last, &mut drawing);
            let (enter, leave) = figures[*id].ports();
            if entered[*id] {
                drawing.line((x[*id], y), (x[*id], top + enter), false);
            }
            if leads_on[*id] {
                drawing.line((x[*id], top + leave), (x[*id], last), false);
            }
        }
    }
    if let Some(channel) = channels.last() {
        channel.draw(last, last + channel.height, &mut drawing);
        last += channel.height;
    }
    arrows(graph, &x, &rows, &mut drawing);
    finish(drawing, graph, &x, &extents, last + 1)
}

/// What goes up has an arrow (IEC 60848, 4.6): in the middle of its way through the layers `rows`.
fn arrows(graph: &Graph, x: &[i32], rows: &[(i32, i32)], drawing: &mut Drawing) {
    for upward in &graph.loops {
        let (Some(first), Some(last)) = (upward.rises.first(), upward.rises.last()) else { continue };
        let layers = &rows[graph.items[*first].layer..=graph.items[*last].layer];
        let middle = (layers[0].0 + layers[layers.len() - 1].1) / 2;
        // Beside a layer, as between them lines cross.
        let places = layers.iter().map(|(top, bottom)| middle.clamp(*top, *bottom));
        let Some(y) = places.min_by_key(|y| (y - middle).abs()) else { continue };
        drawing.shapes.push(Shape::Arrow { at: (x[*first], y), to: Heading::Up });
    }
}

/// The paper's size, and lines as long as they are.
fn finish(mut drawing: Drawing, graph: &Graph, x: &[i32], extents: &[Extent], height: i32) -> Drawing {
    drawing.shapes = joined(drawing.shapes);
    // Lines between the layers may lead around what stands in them.
    let lines = || {
        drawing.shapes.iter().filter_map(|shape| match shape {
            Shape::Line { from, to, .. } => Some((from.0, to.0)),
            Shape::Text { at, text, .. } => Some((at.0, at.0 + width(text) - 1)),
            _ => None,
        })
    };
    let items = || (0..graph.items.len()).map(|id| (x[id] - extents[id].left, x[id] + extents[id].right));
    let left = items().chain(lines()).map(|(left, _)| left).min().unwrap_or(0);
    drawing.width = items().chain(lines()).map(|(_, right)| right + 1).max().unwrap_or(0) - left;
    drawing.height = height;
    let mut moved = Drawing::default();
    let size = (drawing.width, drawing.height);
    moved.paste(drawing, (-left, 0));
    (moved.width, moved.height) = size;
    moved
}

/// Lines that go on in the same direction become one, but for those that end at a double line: what goes on there crosses it.
fn joined(shapes: Vec<Shape>) -> Vec<Shape> {
    let (mut lines, mut others) = (Vec::new(), Vec::new());
    for shape in shapes {
        match shape {
            // Upright or not, single or double, then from which place to which on it.
            Shape::Line { from, to, double } if from.0 == to.0 => lines.push((true, double, from.0, from.1, to.1)),
            Shape::Line { from, to, double } => lines.push((false, double, from.1, from.0, to.0)),
            other => others.push(other),
        }
    }
    sort(&mut lines);
    let doubles: Vec<_> = lines.iter().filter(|line| line.1).map(|(.., row, left, right)| (*row, *left, *right)).list();
    let ends = |x: i32, y: i32| doubles.iter().any(|(row, left, right)| y == *row && (*left..=*right).contains(&x));
    let mut long: Vec<(bool, bool, i32, i32, i32)> = Vec::new();
    for line in lines {
        match long.last_mut() {
            Some(last)
                if (last.0, last.1, last.2) == (line.0, line.1, line.2)
                    && (line.3 < last.4 || line.3 == last.4 && !(line.0 && ends(line.2, line.3))) =>
            {
                last.4 = last.4.max(line.4);
            }
            _ => long.push(line),
        }
    }
    let lines = long.into_iter().map(|(upright, double, at, start, end)| {
        let (from, to) = if upright { ((at, start), (at, end)) } else { ((start, at), (end, at)) };
        Shape::Line { from, to, double }
    });
    lines.chain(others).list()
}
