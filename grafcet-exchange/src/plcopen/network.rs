//! Steps, transitions, and what lies between them, each with its number, its place and its connections.
//!
//! A step is entered directly by what stands above it; whoever comes from below or from the side jumps.

use std::collections::BTreeMap;

use super::place::{Places, Rect, width};
use super::xml::Element;
use super::{documentation, st};
use crate::sfc::{Chart, Step};

/// How far a line lies from what it belongs to.
const GAP: i32 = 16;
/// A line of an action block.
const ROW: i32 = 20;

/// A point where a connection begins.
#[derive(Clone, Copy, Debug)]
struct Out {
    id: usize,
    at: (i32, i32),
}

pub(super) fn network(chart: &Chart, places: &Places) -> Vec<Element> {
    let mut network = Network {
        chart,
        places,
        elements: Vec::new(),
        next: 1 + chart.steps.len() + chart.transitions.len(),
        into: BTreeMap::new(),
    };
    network.leave();
    network.lead();
    for index in 0..chart.steps.len() {
        network.step(index);
    }
    network.elements
}

struct Network<'c> {
    chart: &'c Chart,
    places: &'c Places,
    elements: Vec<Element>,
    next: usize,
    /// By step, what enters it directly.
    into: BTreeMap<usize, Vec<Out>>,
}

impl Network<'_> {
    fn id(&mut self) -> usize {
        self.next += 1;
        self.next - 1
    }

    fn step_id(step: usize) -> usize {
        1 + step
    }

    fn transition_id(&self, transition: usize) -> usize {
        1 + self.chart.steps.len() + transition
    }

    /// From steps to their transitions: by way of a convergence where there are several steps, of a divergence where there are several transitions.
    fn leave(&mut self) {
        let mut done = vec![false; self.chart.transitions.len()];
        for first in 0..done.len() {
            if done[first] {
                continue;
            }
            let from = &self.chart.transitions[first].from;
            let branches: Vec<usize> =
                (first..done.len()).filter(|other| self.chart.transitions[*other].from == *from).collect();
            let top = branches.iter().map(|branch| self.places.transitions[*branch].y).min().unwrap_or_default();
            let out = self.joined(from, top - if branches.len() > 1 { 3 * GAP } else { 2 * GAP });
            if branches.len() > 1 {
                let to: Vec<i32> = branches.iter().map(|branch| self.places.transitions[*branch].middle()).collect();
                let outs = self.divergence("selectionDivergence", 1, out, &to, top - 2 * GAP);
                for (branch, out) in branches.iter().zip(outs) {
                    self.transition(*branch, out);
                }
            } else {
                self.transition(first, out);
            }
            for branch in branches {
                done[branch] = true;
            }
        }
    }

    /// What comes out of one step, or out of several together.
    fn joined(&mut self, steps: &[usize], y: i32) -> Out {
        let outs: Vec<Out> = steps.iter().map(|step| self.below(*step)).collect();
        match outs[..] {
            [one] => one,
            _ => self.convergence("simultaneousConvergence", 3, &outs, y),
        }
    }

    fn below(&self, step: usize) -> Out {
        let place = &self.places.steps[step];
        Out { id: Self::step_id(step), at: (place.middle(), place.bottom()) }
    }

    /// A line with several connections into it; what comes out of its middle.
    fn convergence(&mut self, name: &str, height: i32, outs: &[Out], y: i32) -> Out {
        let id = self.id();
        let (left, right) = span(outs.iter().map(|out| out.at.0));
        let ins = outs.iter().map(|out| connection_in((out.at.0, y), (left, y), &[*out]));
        let middle = (left + right) / 2;
        let element = element(name, id, Rect { x: left, y, width: right - left, height })
            .children(ins)
            .child(point("connectionPointOut", (middle - left, height)));
        self.elements.push(element);
        Out { id, at: (middle, y + height) }
    }

    /// A line with several connections out of it, above or below these places.
    fn divergence(&mut self, name: &str, height: i32, from: Out, to: &[i32], y: i32) -> Vec<Out> {
        let id = self.id();
        let (left, right) = span(to.iter().copied().chain([from.at.0]));
        let outs = to.iter().map(|x| point("connectionPointOut", (x - left, height)).with("formalParameter", ""));
        let element = element(name, id, Rect { x: left, y, width: right - left, height })
            .child(connection_in((from.at.0, y), (left, y), &[from]))
            .children(outs);
        self.elements.push(element);
        to.iter().map(|x| Out { id, at: (*x, y + height) }).collect()
    }

    fn transition(&mut self, number: usize, from: Out) {
        let transition = &self.chart.transitions[number];
        let place = self.places.transitions[number];
        let inline = Element::new("inline").with("name", "").child(st(&transition.condition));
        let mut element = element("transition", self.transition_id(number), place);
        if let Some(priority) = transition.priority {
            element = element.with("priority", priority);
        }
        let element = element
            .child(connection_in((place.middle(), place.y), (place.x, place.y), &[from]))
            .child(point("connectionPointOut", (place.width / 2, place.height)))
            .child(Element::new("condition").child(inline));
        self.elements.push(element);
    }

    /// From transitions to steps.
    fn lead(&mut self) {
        for number in 0..self.chart.transitions.len() {
            let to = &self.chart.transitions[number].to;
            let place = self.places.transitions[number];
            let out = Out { id: self.transition_id(number), at: (place.middle(), place.bottom()) };
            let direct: Vec<bool> = to.iter().map(|step| self.is_direct(number, *step)).collect();
            let outs = if let [_] = to[..] {
                vec![out]
            } else {
                let mut beside = place.middle();
                let xs: Vec<i32> = to
                    .iter()
                    .zip(&direct)
                    .map(|(step, direct)| {
                        let x = if *direct { self.places.steps[*step].middle() } else { beside };
                        beside += width(&self.chart.steps[*step].name) + GAP;
                        x
                    })
                    .collect();
                self.divergence("simultaneousDivergence", 3, out, &xs, place.bottom() + GAP)
            };
            for ((step, out), direct) in to.iter().zip(outs).zip(direct) {
                if direct {
                    self.into.entry(*step).or_default().push(out);
                } else {
                    self.jump(*step, out);
                }
            }
        }
    }

    /// What stands above a step leads to it: one transition, or several that lead to nothing else.
    fn is_direct(&self, number: usize, step: usize) -> bool {
        let above = |other: &usize| {
            let leads = self.chart.transitions[*other].to.contains(&step);
            leads && self.places.transitions[*other].y < self.places.steps[step].y
        };
        let all: Vec<usize> = (0..self.chart.transitions.len()).filter(above).collect();
        let alone = all.iter().all(|other| self.chart.transitions[*other].to.len() == 1);
        !self.chart.steps[step].initial && (all.first() == Some(&number) || alone && all.contains(&number))
    }

    fn jump(&mut self, step: usize, from: Out) {
        let id = self.id();
        let name = &self.chart.steps[step].name;
        let width = width(name);
        let place = Rect { x: from.at.0 - width / 2, y: from.at.1 + GAP, width, height: ROW };
        let element = element("jumpStep", id, place).with("targetName", name).child(connection_in(
            (place.middle(), place.y),
            (place.x, place.y),
            &[from],
        ));
        self.elements.push(element);
    }

    fn step(&mut self, index: usize) {
        let step = &self.chart.steps[index];
        let place = self.places.steps[index];
        let into = self.into.remove(&index).unwrap_or_default();
        let into =
            if into.len() > 1 { vec![self.convergence("selectionConvergence", 1, &into, place.y - GAP)] } else { into };
        let mut element = element("step", Self::step_id(index), place).with("name", &step.name);
        if step.initial {
            element = element.with("initialStep", true);
        }
        if !into.is_empty() {
            element = element.child(connection_in((place.middle(), place.y), (place.x, place.y), &into));
        }
        element =
            element.child(point("connectionPointOut", (place.width / 2, place.height)).with("formalParameter", ""));
        if !step.blocks.is_empty() {
            let point = point("connectionPointOutAction", (place.width, ROW / 2)).with("formalParameter", "");
            element = element.child(point);
        }
        if !step.note.is_empty() {
            element = element.child(documentation(&step.note));
        }
        self.elements.push(element);
        if !step.blocks.is_empty() {
            self.actions(step, index, place);
        }
    }

    /// The action block at the right of a step.
    fn actions(&mut self, step: &Step, index: usize, beside: Rect) {
        let out = Out { id: Self::step_id(index), at: (beside.x + beside.width, beside.y + ROW / 2) };
        let id = self.id();
        let names = step.blocks.iter().map(|block| width(&block.action) + block.time.as_deref().map_or(0, width));
        let height = i32::try_from(step.blocks.len()).unwrap_or(1) * ROW;
        let place = Rect { x: out.at.0 + 2 * GAP, y: beside.y, width: 40 + names.max().unwrap_or(0), height };
        let mut block =
            element("actionBlock", id, place).child(connection_in((place.x, out.at.1), (place.x, place.y), &[out]));
        for (number, one) in (0..).zip(&step.blocks) {
            let mut action = Element::new("action").with("localId", self.id()).with("qualifier", one.qualifier);
            if let Some(time) = &one.time {
                action = action.with("duration", time);
            }
            block = block.child(
                action
                    .child(Element::new("relPosition").with("x", 0).with("y", number * ROW))
                    .child(Element::new("reference").with("name", &one.action)),
            );
        }
        self.elements.push(block);
    }
}

/// From the leftmost to the rightmost; a line has a length.
fn span(all: impl Iterator<Item = i32> + Clone) -> (i32, i32) {
    let left = all.clone().min().unwrap_or_default();
    (left, all.max().unwrap_or_default().max(left + 1))
}

fn element(name: &str, id: usize, place: Rect) -> Element {
    Element::new(name)
        .with("localId", id)
        .with("width", place.width)
        .with("height", place.height)
        .child(position("position", (place.x, place.y)))
}

fn position(name: &str, (x, y): (i32, i32)) -> Element {
    Element::new(name).with("x", x).with("y", y)
}

/// A pin, from the upper left corner of what it belongs to.
fn point(name: &str, at: (i32, i32)) -> Element {
    Element::new(name).child(position("relPosition", at))
}

/// A pin with the line that comes into it, written from this end.
fn connection_in(at: (i32, i32), corner: (i32, i32), from: &[Out]) -> Element {
    let connections = from.iter().map(|out| {
        let turn = (at.1 + out.at.1) / 2;
        let mut way = vec![at, (at.0, turn), (out.at.0, turn), out.at];
        if at.0 == out.at.0 || at.1 == out.at.1 {
            way = vec![at, out.at];
        }
        let connection = Element::new("connection").with("refLocalId", out.id);
        connection.children(way.into_iter().map(|at| position("position", at)))
    });
    point("connectionPointIn", (at.0 - corner.0, at.1 - corner.1)).children(connections)
}
