//! What is drawn as one net: a partial grafcet, an enclosure, the expansion of a macro-step.

use grafcet_core::description::Description;

use crate::sorted::{List, Map};

/// A step as it is drawn: a macro-step stands for its expansion.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum Node {
    Step(usize),
    Macro(usize),
}

/// A transition between nodes.
#[derive(Clone, Debug)]
pub(crate) struct Link {
    /// Its number in the description.
    pub(crate) transition: usize,
    pub(crate) sources: Vec<Node>,
    pub(crate) targets: Vec<Node>,
    /// Targets to which a reference leads in place of a line.
    pub(crate) jumps: Vec<Node>,
}

/// What belongs together on the paper.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sheet {
    /// Empty for what stands directly in the chart.
    pub(crate) title: String,
    /// What it is for, in the user's words.
    pub(crate) doc: String,
    pub(crate) nodes: Vec<Node>,
    pub(crate) links: Vec<Link>,
}

/// How a step at an end of a transition is seen.
type Seen = fn(&Description<'_>, usize) -> Node;

/// The place of a sheet: its partial grafcet and its macro-step.
type Room = (usize, Option<usize>);

/// The sheets of a chart: its partial grafcets in order, each before the expansions of its macro-steps.
pub(crate) fn sheets(chart: &Description<'_>) -> Vec<Sheet> {
    let mut rooms: Map<Room, Sheet> = Map::new();
    for (step, described) in chart.steps.iter().enumerate() {
        let room = (described.partial, described.expansion);
        rooms.entry(room).nodes.push(Node::Step(step));
    }
    for (id, macro_step) in chart.macros.iter().enumerate() {
        let partial = chart.steps.get(macro_step.entry).map_or(0, |entry| entry.partial);
        rooms.entry((partial, macro_step.outer)).nodes.push(Node::Macro(id));
    }
    for (transition, described) in chart.transitions.iter().enumerate() {
        let known =
            |steps: &[usize]| -> Vec<usize> { steps.iter().copied().filter(|step| *step < chart.steps.len()).list() };
        let (sources, targets) = (known(described.sources), known(described.targets));
        let seen = |steps: &[usize], of: Seen| -> Vec<Node> { steps.iter().map(|step| of(chart, *step)).list() };
        // From outside an expansion is its macro-step; what stays within it leads from step to step.
        let views: [[Seen; 2]; 4] = [[source, target], [source, plain], [plain, target], [plain, plain]];
        let links = views.map(|[from, to]| (seen(&sources, from), seen(&targets, to)));
        let rooms_of = |(from, to): &(Vec<Node>, Vec<Node>)| -> Vec<Room> {
            from.iter().chain(to).map(|node| room(chart, *node)).list()
        };
        let one = |link: &&(Vec<Node>, Vec<Node>)| rooms_of(link).windows(2).all(|pair| pair[0] == pair[1]);
        let (sources, targets) = links.iter().find(one).unwrap_or(&links[0]).clone();
        // An `any` stands in the net that it leaves, outside of its macro-steps; one of a description made by hand without any
        // steps in the first net.
        let net = described.any.and_then(|any| chart.steps.get(*any.steps.first()?)).map(|step| (step.partial, None));
        let first = net.or_else(|| sources.first().or(targets.first()).map(|node| room(chart, *node)));
        let Some(place) = first.or(rooms.first()) else { continue };
        let link = Link { transition, sources, targets, jumps: Vec::new() };
        rooms.entry(place).links.push(link);
    }
    let named = |(room, mut sheet): (Room, Sheet)| {
        sheet.title = title(chart, room);
        doc(chart, room).clone_into(&mut sheet.doc);
        sheet
    };
    rooms.entries().into_iter().map(named).list()
}

fn plain(_: &Description<'_>, step: usize) -> Node {
    Node::Step(step)
}

/// A transition from the exit of an expansion is drawn as one from the macro-step.
fn source(chart: &Description<'_>, step: usize) -> Node {
    match chart.steps[step].expansion {
        Some(id) if chart.macros.get(id).is_some_and(|m| m.exit == step) => Node::Macro(id),
        _ => Node::Step(step),
    }
}

fn target(chart: &Description<'_>, step: usize) -> Node {
    match chart.steps[step].expansion {
        Some(id) if chart.macros.get(id).is_some_and(|m| m.entry == step) => Node::Macro(id),
        _ => Node::Step(step),
    }
}

fn room(chart: &Description<'_>, node: Node) -> Room {
    let partial = |step: usize| chart.steps.get(step).map_or(0, |step| step.partial);
    match node {
        Node::Step(step) => (partial(step), chart.steps.get(step).and_then(|step| step.expansion)),
        Node::Macro(id) => chart.macros.get(id).map_or((0, None), |m| (partial(m.entry), m.outer)),
    }
}

fn doc<'a>(chart: &Description<'a>, (partial, expansion): Room) -> &'a str {
    match expansion {
        Some(id) => chart.macros.get(id).map_or("", |m| m.doc),
        None => chart.partials.get(partial).map_or("", |partial| partial.doc),
    }
}

/// `Auto ▸ Production` for an enclosure, `M Clamp` for an expansion.
fn title(chart: &Description<'_>, (partial, expansion): Room) -> String {
    if let Some(id) = expansion {
        return chart.macros.get(id).map_or_else(String::new, |m| format!("macro step {}", m.name));
    }
    let Some(partial) = chart.partials.get(partial) else { return String::new() };
    match partial.enclosed_by.and_then(|step| chart.steps.get(step)) {
        Some(step) => format!("{} ▸ {}", step.name, partial.name),
        None => partial.name.to_owned(),
    }
}

/// The name that is written for a node.
pub(crate) fn name<'a>(chart: &Description<'a>, node: Node) -> &'a str {
    match node {
        Node::Step(step) => chart.steps.get(step).map_or("", |step| step.name),
        Node::Macro(id) => chart.macros.get(id).map_or("", |m| m.name),
    }
}

/// The pieces of a sheet that no transition connects.
pub(crate) fn pieces(sheet: &Sheet) -> Vec<Sheet> {
    let mut piece = Map::new();
    for (number, node) in sheet.nodes.iter().enumerate() {
        piece.insert(*node, number);
    }
    for link in &sheet.links {
        let ids = piece.of(link.sources.iter().chain(&link.targets));
        let Some(least) = ids.iter().min().copied() else { continue };
        for node in &sheet.nodes {
            let id = piece.entry(*node);
            if ids.contains(id) {
                *id = least;
            }
        }
    }
    let mut pieces: Map<usize, Sheet> = Map::new();
    for node in &sheet.nodes {
        pieces.entry(*piece.entry(*node)).nodes.push(*node);
    }
    for link in &sheet.links {
        let first = link.sources.iter().chain(&link.targets).find_map(|node| piece.get(*node).copied());
        pieces.entry(first.unwrap_or_default()).links.push(link.clone());
    }
    pieces.entries().into_iter().map(|(_, piece)| piece).list()
}
