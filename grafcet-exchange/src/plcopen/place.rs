//! Where steps and transitions stand: as `grafcet-draw` lays them out, in the units of PLCopen.

use grafcet_compiler::describe::with_description;
use grafcet_compiler::model::Model;
use grafcet_draw::Thing;

use crate::sfc::Chart;

/// A square of the layout is so many units wide and high, so that action blocks with their names have room.
const SQUARE: (i32, i32) = (12, 18);
/// The edge of the paper.
const MARGIN: i32 = 40;
/// The bar of a transition.
const BAR: (i32, i32) = (20, 2);

/// A rectangle; down is more.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Rect {
    pub(super) x: i32,
    pub(super) y: i32,
    pub(super) width: i32,
    pub(super) height: i32,
}

impl Rect {
    /// The middle from left to right.
    pub(super) fn middle(&self) -> i32 {
        self.x + self.width / 2
    }

    pub(super) fn right(&self) -> i32 {
        self.x + self.width
    }

    pub(super) fn bottom(&self) -> i32 {
        self.y + self.height
    }
}

/// By number.
pub(super) struct Places {
    pub(super) steps: Vec<Rect>,
    pub(super) transitions: Vec<Rect>,
}

pub(super) fn places(model: &Model, chart: &Chart) -> Places {
    let (mut steps, mut transitions) = (vec![None; model.steps.len()], vec![None; chart.transitions.len()]);
    // The drawing shows an `any` once, and numbers what it shows.
    let drawn: Vec<usize> = model.drawn_transitions().map(|(id, _)| grafcet_compiler::model::Id::index(id)).collect();
    let layout = with_description(model, |description| grafcet_draw::layout(description, &()));
    for site in layout.sites {
        let at = |square: i32, unit: i32| MARGIN + square * unit;
        let (x, y) = (at(site.at.0, SQUARE.0), at(site.at.1, SQUARE.1));
        let (width, height) = (site.size.0 * SQUARE.0, site.size.1 * SQUARE.1);
        match site.of {
            Thing::Step(number) => steps[number] = Some(Rect { x, y, width, height }),
            Thing::Transition(number) => {
                let x = x + width / 2 - BAR.0 / 2;
                transitions[drawn[number]] = Some(Rect { x, y: y + height / 2, width: BAR.0, height: BAR.1 });
            }
            Thing::Macro(_) => {}
        }
    }
    let mut steps = steps.iter().copied().collect::<Option<Vec<Rect>>>().unwrap_or_else(|| column(chart));
    // What is beside the chart stands at its right.
    for step in &chart.steps[steps.len().min(chart.steps.len())..] {
        let right = steps.iter().map(|place| place.x + place.width).max().unwrap_or_default();
        steps.push(Rect { x: right + 10 * MARGIN, y: MARGIN, width: width(&step.name), height: MARGIN });
    }
    let missing = |(number, place): (usize, &Option<Rect>)| place.unwrap_or_else(|| below(chart, &steps, number));
    let transitions = transitions.iter().enumerate().map(missing).collect();
    Places { steps, transitions }
}

/// Of a chart that is too large to be laid out: one step below the other.
fn column(chart: &Chart) -> Vec<Rect> {
    let mut y = MARGIN;
    let mut places = Vec::new();
    for step in &chart.steps {
        let height = i32::try_from(step.blocks.len()).unwrap_or(1).max(2) * 20;
        let width = width(&step.name);
        places.push(Rect { x: 20 * MARGIN / 2 - width / 2, y, width, height });
        y += height + 140;
    }
    places
}

/// Where the layout has no place for a transition, it stands below its first step, beside the others there.
fn below(chart: &Chart, steps: &[Rect], number: usize) -> Rect {
    let from = chart.transitions[number].from.first().copied().unwrap_or_default();
    let siblings = chart.transitions[..number].iter().filter(|other| other.from.first() == Some(&from)).count();
    let beside = i32::try_from(siblings).unwrap_or(0) * 180;
    Rect { x: steps[from].middle() - BAR.0 / 2 + beside, y: steps[from].bottom() + 60, width: BAR.0, height: BAR.1 }
}

/// Room for a name.
pub(super) fn width(name: &str) -> i32 {
    i32::try_from(name.chars().count()).unwrap_or(0) * 9 + 24
}
