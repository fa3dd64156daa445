//! Steps, transitions, and what lies between them, each with its place and its lines; how that is written is the edition's.
//!
//! A step is entered directly by what stands above it; whoever comes from below or from the side jumps, or has a line at the right of the chart, where the
//! edition knows no jumps.

use std::collections::BTreeMap;

use super::place::{Places, Rect, width};
use crate::sfc::{Chart, Step, Transition};

/// How far a line lies from what it belongs to.
const GAP: i32 = 16;
/// A line of an action block.
pub(super) const ROW: i32 = 20;

/// How a step is entered from below or from the side.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Back {
    Jumps,
    Lines,
}

/// What is drawn.
#[derive(Clone, Debug)]
pub(super) struct Object<'c> {
    pub(super) kind: Kind<'c>,
    /// By which lines and people know it.
    pub(super) id: usize,
    pub(super) place: Rect,
    pub(super) ins: Vec<In>,
    /// From its upper left corner.
    pub(super) outs: Vec<Pin>,
}

#[derive(Clone, Debug)]
pub(super) enum Kind<'c> {
    /// With the pin of its actions.
    Step(&'c Step, Option<Pin>),
    Transition(&'c Transition),
    /// By pin.
    SelectionDivergence(Vec<Option<usize>>),
    SelectionConvergence,
    SimultaneousDivergence,
    SimultaneousConvergence,
    /// To a step of this name.
    Jump(&'c str),
    /// With a number for each.
    Actions(&'c Step, Vec<usize>),
}

/// Where lines leave something.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pin {
    /// No other one of the drawing has it.
    pub(super) number: usize,
    pub(super) at: (i32, i32),
}

/// Where lines lead into something.
#[derive(Clone, Debug)]
pub(super) struct In {
    /// From the upper left corner of what it belongs to.
    pub(super) at: (i32, i32),
    pub(super) lines: Vec<Line>,
}

#[derive(Clone, Debug)]
pub(super) struct Line {
    pub(super) from: Out,
    /// From its end to its beginning, on the paper.
    pub(super) way: Vec<(i32, i32)>,
}

/// A point where a line begins.
#[derive(Clone, Copy, Debug)]
pub(super) struct Out {
    pub(super) id: usize,
    pub(super) pin: usize,
    /// On the paper.
    pub(super) at: (i32, i32),
}

/// What comes to a step, on a lane of its own where it comes from below.
#[derive(Clone, Copy, Debug)]
struct Arrival {
    out: Out,
    lane: Option<Lane>,
}

/// A way at the right of everything. Where others of the same row turn, it does not, so that each can be followed.
#[derive(Clone, Copy, Debug)]
struct Lane {
    x: i32,
    /// Where it leaves to the right.
    below: i32,
    /// Where it comes back to a step that it enters alone.
    above: i32,
}

/// How far lines of one row are apart, and so many of them have room between a transition and the next step; of those above a step there are fewer.
const APART: i32 = 4;
const BELOW: i32 = 5;
const ABOVE: i32 = 3;

impl Arrival {
    fn direct(out: Out) -> Self {
        Self { out, lane: None }
    }

    /// Where it arrives from left to right.
    fn x(&self) -> i32 {
        self.lane.map_or(self.out.at.0, |lane| lane.x)
    }
}

pub(super) fn network<'c>(chart: &'c Chart, places: &'c Places, back: Back) -> Vec<Object<'c>> {
    let right = (0..chart.steps.len()).map(|step| {
        let (place, beside) = (places.steps[step], beside(&chart.steps[step], places.steps[step]));
        place.right().max(beside.right())
    });
    let mut network = Network {
        chart,
        places,
        back,
        objects: Vec::new(),
        next: 1 + chart.steps.len() + chart.transitions.len(),
        pins: 1 + 2 * chart.steps.len() + chart.transitions.len(),
        lane: right.max().unwrap_or_default() + GAP,
        rows: BTreeMap::new(),
        into: BTreeMap::new(),
    };
    network.leave();
    network.lead();
    for index in 0..chart.steps.len() {
        network.step(index);
    }
    network.objects
}

struct Network<'c> {
    chart: &'c Chart,
    places: &'c Places,
    back: Back,
    objects: Vec<Object<'c>>,
    next: usize,
    pins: usize,
    /// The next one that is free, at the right of everything.
    lane: i32,
    /// By height, how many lanes turn there.
    rows: BTreeMap<i32, i32>,
    /// By step, what enters it.
    into: BTreeMap<usize, Vec<Arrival>>,
}

impl<'c> Network<'c> {
    fn id(&mut self) -> usize {
        self.next += 1;
        self.next - 1
    }

    fn pin(&mut self, at: (i32, i32)) -> Pin {
        self.pins += 1;
        Pin { number: self.pins - 1, at }
    }

    fn step_id(step: usize) -> usize {
        1 + step
    }

    /// Of the line that leads on; that of its actions is after it.
    fn step_pin(step: usize) -> usize {
        1 + 2 * step
    }

    fn transition_id(&self, transition: usize) -> usize {
        1 + self.chart.steps.len() + transition
    }

    fn transition_pin(&self, transition: usize) -> usize {
        1 + 2 * self.chart.steps.len() + transition
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
                let priorities = branches.iter().map(|branch| self.chart.transitions[*branch].priority).collect();
                let outs = self.divergence(Kind::SelectionDivergence(priorities), 1, out, &to, top - 2 * GAP);
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
        let outs: Vec<Arrival> = steps.iter().map(|step| Arrival::direct(self.below(*step))).collect();
        match outs[..] {
            [one] => one.out,
            _ => self.convergence(Kind::SimultaneousConvergence, 3, &outs, y, None),
        }
    }

    fn below(&self, step: usize) -> Out {
        let place = &self.places.steps[step];
        Out { id: Self::step_id(step), pin: Self::step_pin(step), at: (place.middle(), place.bottom()) }
    }

    /// A line with several connections into it; what comes out of it at this place from left to right, or out of its middle.
    fn convergence(&mut self, kind: Kind<'c>, height: i32, from: &[Arrival], y: i32, out: Option<i32>) -> Out {
        let id = self.id();
        let (left, right) = span(from.iter().map(Arrival::x).chain(out));
        let ins = from.iter().map(|one| into((one.x(), y), (left, y), &[*one])).collect();
        let middle = out.unwrap_or((left + right) / 2);
        let pin = self.pin((middle - left, height));
        let place = Rect { x: left, y, width: right - left, height };
        self.objects.push(Object { kind, id, place, ins, outs: vec![pin] });
        Out { id, pin: pin.number, at: (middle, y + height) }
    }

    /// A line with several connections out of it, above or below these places.
    fn divergence(&mut self, kind: Kind<'c>, height: i32, from: Out, to: &[i32], y: i32) -> Vec<Out> {
        let id = self.id();
        let (left, right) = span(to.iter().copied().chain([from.at.0]));
        let outs: Vec<Pin> = to.iter().map(|x| self.pin((x - left, height))).collect();
        let ins = vec![into((from.at.0, y), (left, y), &[Arrival::direct(from)])];
        let all = to.iter().zip(&outs).map(|(x, pin)| Out { id, pin: pin.number, at: (*x, y + height) }).collect();
        let place = Rect { x: left, y, width: right - left, height };
        self.objects.push(Object { kind, id, place, ins, outs });
        all
    }

    fn transition(&mut self, number: usize, from: Out) {
        let place = self.places.transitions[number];
        let ins = vec![into((place.middle(), place.y), (place.x, place.y), &[Arrival::direct(from)])];
        let outs = vec![Pin { number: self.transition_pin(number), at: (place.width / 2, place.height) }];
        let kind = Kind::Transition(&self.chart.transitions[number]);
        self.objects.push(Object { kind, id: self.transition_id(number), place, ins, outs });
    }

    /// From transitions to steps.
    fn lead(&mut self) {
        for number in 0..self.chart.transitions.len() {
            let to = &self.chart.transitions[number].to;
            let place = self.places.transitions[number];
            let (id, pin) = (self.transition_id(number), self.transition_pin(number));
            let out = Out { id, pin, at: (place.middle(), place.bottom()) };
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
                self.divergence(Kind::SimultaneousDivergence, 3, out, &xs, place.bottom() + GAP)
            };
            for ((step, out), direct) in to.iter().zip(outs).zip(direct) {
                if direct {
                    self.into.entry(*step).or_default().push(Arrival::direct(out));
                } else if self.back == Back::Jumps {
                    self.jump(*step, out);
                } else {
                    let below = out.at.1 + GAP / 2 + APART * (self.turns(out.at.1) % BELOW);
                    let lane = Some(Lane { x: self.lane, below, above: 0 });
                    self.lane += GAP;
                    self.into.entry(*step).or_default().push(Arrival { out, lane });
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

    /// How many lanes have turned at this height before.
    fn turns(&mut self, y: i32) -> i32 {
        let row = self.rows.entry(y).or_default();
        *row += 1;
        *row - 1
    }

    fn jump(&mut self, step: usize, from: Out) {
        let id = self.id();
        let name = &self.chart.steps[step].name;
        let width = width(name);
        let place = Rect { x: from.at.0 - width / 2, y: from.at.1 + GAP, width, height: ROW };
        let ins = vec![into((place.middle(), place.y), (place.x, place.y), &[Arrival::direct(from)])];
        self.objects.push(Object { kind: Kind::Jump(name), id, place, ins, outs: Vec::new() });
    }

    fn step(&mut self, index: usize) {
        let step = &self.chart.steps[index];
        let place = self.places.steps[index];
        let mut from = self.into.remove(&index).unwrap_or_default();
        let has_lane = from.iter().any(|one| one.lane.is_some());
        let higher = if has_lane { APART * (self.turns(place.y) % ABOVE) } else { 0 };
        for lane in from.iter_mut().filter_map(|one| one.lane.as_mut()) {
            lane.above = place.y - APART - higher;
        }
        if from.len() > 1 {
            // A line from below makes it wide, and is none of its middle.
            let out = has_lane.then(|| place.middle());
            let out = self.convergence(Kind::SelectionConvergence, 1, &from, place.y - GAP - higher, out);
            from = vec![Arrival::direct(out)];
        }
        let mut ins = Vec::new();
        if !from.is_empty() {
            ins.push(into((place.middle(), place.y), (place.x, place.y), &from));
        }
        let outs = vec![Pin { number: Self::step_pin(index), at: (place.width / 2, place.height) }];
        let action = Pin { number: Self::step_pin(index) + 1, at: (place.width, ROW / 2) };
        let action = (!step.blocks.is_empty()).then_some(action);
        self.objects.push(Object { kind: Kind::Step(step, action), id: Self::step_id(index), place, ins, outs });
        if let Some(pin) = action {
            self.actions(step, index, pin);
        }
    }

    /// The action block at the right of a step.
    fn actions(&mut self, step: &'c Step, index: usize, pin: Pin) {
        let corner = self.places.steps[index];
        let out = Out { id: Self::step_id(index), pin: pin.number, at: (corner.x + pin.at.0, corner.y + pin.at.1) };
        let id = self.id();
        let place = beside(step, corner);
        let ins = vec![into((place.x, out.at.1), (place.x, place.y), &[Arrival::direct(out)])];
        let ids = step.blocks.iter().map(|_| self.id()).collect();
        self.objects.push(Object { kind: Kind::Actions(step, ids), id, place, ins, outs: Vec::new() });
    }
}

/// Where the action block of a step stands.
fn beside(step: &Step, place: Rect) -> Rect {
    let names = step.blocks.iter().map(|block| width(&block.action) + block.time.as_deref().map_or(0, width));
    let height = i32::try_from(step.blocks.len()).unwrap_or(1) * ROW;
    Rect { x: place.x + place.width + 2 * GAP, y: place.y, width: 40 + names.max().unwrap_or(0), height }
}

/// From the leftmost to the rightmost; a line has a length.
fn span(all: impl Iterator<Item = i32> + Clone) -> (i32, i32) {
    let left = all.clone().min().unwrap_or_default();
    (left, all.max().unwrap_or_default().max(left + 1))
}

/// A pin with the lines that come into it, written from this end.
fn into(at: (i32, i32), corner: (i32, i32), from: &[Arrival]) -> In {
    let lines = from.iter().map(|one| {
        let start = one.out.at;
        let turn = (at.1 + start.1) / 2;
        let way = match one.lane {
            // Into a convergence that is as wide; or above the step to its middle.
            Some(Lane { x, below, above }) => {
                let mut way = if at.0 == x { vec![at] } else { vec![at, (at.0, above), (x, above)] };
                way.extend([(x, below), (start.0, below), start]);
                way
            }
            None if at.0 == start.0 || at.1 == start.1 => vec![at, start],
            None => vec![at, (at.0, turn), (start.0, turn), start],
        };
        Line { from: one.out, way }
    });
    In { at: (at.0 - corner.0, at.1 - corner.1), lines: lines.collect() }
}
