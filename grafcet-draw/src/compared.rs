//! A chart beside another version of it: what is marked, and how that looks.

#[cfg(feature = "compared")]
use crate::shape::{Drawing, Frame, Shape};
use crate::sorted::List;
#[cfg(feature = "compared")]
use crate::wrap::{width, wrap};

/// How a part of a chart differs from the other version. Each has a colour, a kind of line and a sign, so that nobody needs to see the colour.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Change {
    /// It is new: `+`, a full line.
    New,
    /// It is gone, and is drawn nevertheless: `−`, a broken line.
    Gone,
    /// It is another one than it was: `~`, a dotted line.
    Other,
    /// It has another place in the order of its neighbours, which counts: `↕`, dashes and dots.
    Moved,
}

/// What can be marked, by its numbers in the description.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Part {
    /// A step.
    Step(usize),
    /// An action of a step: the number of the step, and its own one. The forcing orders go on counting after the actions.
    Action(usize, usize),
    /// A transition with its condition.
    Transition(usize),
    /// What a transition does as it clears: the number of the transition, and its own one.
    Clearing(usize, usize),
}

/// One part that differs.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Difference {
    /// What it is.
    pub part: Part,
    /// What has become of it.
    pub change: Change,
    /// The words that it had, shown below those that it has; of a transition alone, and often empty.
    pub was: String,
}

impl Change {
    #[cfg(feature = "compared")]
    /// All of them, as a legend lists them.
    const ALL: [(Self, &'static str); 4] =
        [(Self::New, "new"), (Self::Gone, "gone"), (Self::Other, "changed"), (Self::Moved, "order changed")];

    /// In front of its words.
    pub(crate) fn sign(self) -> &'static str {
        match self {
            Self::New => "+",
            Self::Gone => "−",
            Self::Other => "~",
            Self::Moved => "↕",
        }
    }

    /// Colours that people tell apart who see few of them (Okabe and Ito), and lines that tell on their own.
    pub(crate) fn look(self) -> &'static str {
        match self {
            Self::New => "fill=\"#0072b2\" stroke=\"#0072b2\"",
            Self::Gone => "fill=\"#d55e00\" stroke=\"#d55e00\" stroke-dasharray=\"6 3\"",
            Self::Other => "fill=\"#cc79a7\" stroke=\"#cc79a7\" stroke-dasharray=\"2 2\"",
            Self::Moved => "fill=\"#009e73\" stroke=\"#009e73\" stroke-dasharray=\"7 2 2 2\"",
        }
    }
}

#[cfg(feature = "compared")]
/// What the signs mean, and below it `notes`, one below the other, in a frame.
pub(crate) fn key(differences: &[Difference], notes: &[String], wide: i32) -> Drawing {
    const BEGIN: i32 = 2;
    let mut drawing = Drawing::default();
    let mut x = BEGIN;
    for (change, word) in Change::ALL.iter().filter(|one| differences.iter().any(|each| each.change == one.0)) {
        let text = format!("{} {word}", change.sign());
        drawing.shapes.push(Shape::Changed { at: (x - 1, 1), size: (width(&text) + 2, 1), change: *change });
        drawing.text((x, 1), &text);
        x += width(&text) + 4;
    }
    let mut row = if x == BEGIN { 1 } else { 3 };
    let mut right = x - 4;
    for note in notes {
        for (number, line) in wrap(note, wide - 6, usize::MAX - 1).iter().enumerate() {
            let indent = if number == 0 { BEGIN } else { BEGIN + 2 };
            drawing.text((indent, row), line);
            right = right.max(indent + width(line));
            row += 1;
        }
    }
    let size = (right + 2, row.max(2) + 1 - i32::from(notes.is_empty()));
    drawing.shapes.insert(0, Shape::Frame { at: (0, 0), size, kind: Frame::Sheet });
    (drawing.width, drawing.height) = size;
    drawing
}

/// The words of something with the signs of its changes in front.
pub(crate) fn signed(lines: Vec<String>, changes: &[Change]) -> Vec<String> {
    if changes.is_empty() {
        return lines;
    }
    let signs: String = changes.iter().map(|change| change.sign()).collect();
    let blanks = " ".repeat(changes.len());
    let sign = |(number, line): (usize, String)| format!("{} {line}", if number == 0 { &signs } else { &blanks });
    lines.into_iter().enumerate().map(sign).list()
}
