//! The drawing list: what is on the paper, and where.

use crate::compared::Change;
use crate::wrap::width;

/// A drawing on squared paper. A unit to the right is one character, a unit down is one line of text; lines run through the
/// middle of their squares.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Drawing {
    /// In characters.
    pub width: i32,
    /// In lines.
    pub height: i32,
    /// In the order of drawing.
    pub shapes: Vec<Shape>,
    /// Where steps, macro-steps and transitions stand, for who puts marks upon them.
    pub sites: Vec<Site>,
}

/// Where something of the chart stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Site {
    /// What it is.
    pub of: Thing,
    /// The upper left square.
    pub at: (i32, i32),
    /// From edge to edge, as of a frame.
    pub size: (i32, i32),
}

/// What can be marked, by its number in the description.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Thing {
    /// A step.
    Step(usize),
    /// A macro-step.
    Macro(usize),
    /// A transition: its bar.
    Transition(usize),
}

/// One thing on the paper.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Shape {
    /// A horizontal or vertical line between the middles of two squares, both included.
    ///
    /// Lines that meet at an end of one of them are connected. What crosses a double line has nothing to do with it: the
    /// double line has a gap there.
    Line {
        /// The left or upper end.
        from: (i32, i32),
        /// The right or lower end.
        to: (i32, i32),
        /// The double line of parallel branches.
        double: bool,
    },
    /// The bar of a transition, two squares to either side.
    Bar {
        /// Its middle.
        at: (i32, i32),
    },
    /// A rectangle whose edges run through the middles of its outermost squares.
    Frame {
        /// The upper left square.
        at: (i32, i32),
        /// Squares from edge to edge, both included: width and height.
        size: (i32, i32),
        /// What it frames.
        kind: Frame,
    },
    /// The head of an arrow.
    Arrow {
        /// Its square.
        at: (i32, i32),
        /// Where it points.
        to: Heading,
    },
    /// Lines that cross here are connected; without a dot they are not.
    Dot {
        /// Its square.
        at: (i32, i32),
    },
    /// The mark of an active step.
    Mark {
        /// Its square.
        at: (i32, i32),
    },
    /// Something that differs from another version of the chart, after what it is; in plain text nothing, as signs tell there.
    Changed {
        /// The upper left square.
        at: (i32, i32),
        /// Whole squares to the right and down.
        size: (i32, i32),
        /// How it differs.
        change: Change,
    },
    /// One line of text, one square a character.
    Text {
        /// The square of its first character.
        at: (i32, i32),
        /// Without line breaks.
        text: String,
        /// Half a square further right, where there is half of one: in the middle of a frame.
        half: bool,
    },
}

/// Where an arrow points.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Heading {
    /// To a step above.
    Up,
    /// To the name of a step that is drawn elsewhere.
    Down,
    /// From the names of such steps.
    Left,
}

/// What a rectangle frames.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Frame {
    /// A step; an initial one has a double frame.
    Step {
        /// Active in the initial situation.
        initial: bool,
        /// An enclosing step has marks at its corners.
        enclosing: bool,
        /// Drawn with the mark of an active step.
        active: bool,
    },
    /// A macro-step: double bars at top and bottom.
    Macro {
        /// One of its steps is active in the initial situation.
        initial: bool,
        /// One of its steps is active.
        active: bool,
    },
    /// An action.
    Action,
    /// A forcing order: a double frame.
    Force,
    /// A partial grafcet, an enclosure or an expansion.
    Sheet,
}

impl Drawing {
    /// Puts another drawing on this paper.
    pub(crate) fn paste(&mut self, other: Self, (dx, dy): (i32, i32)) {
        let moved = other.shapes.into_iter().map(|mut shape| {
            match &mut shape {
                Shape::Line { from, to, .. } => {
                    *from = (from.0 + dx, from.1 + dy);
                    *to = (to.0 + dx, to.1 + dy);
                }
                Shape::Bar { at }
                | Shape::Frame { at, .. }
                | Shape::Arrow { at, .. }
                | Shape::Dot { at }
                | Shape::Mark { at }
                | Shape::Changed { at, .. }
                | Shape::Text { at, .. } => *at = (at.0 + dx, at.1 + dy),
            }
            shape
        });
        self.shapes.extend(moved);
        for site in other.sites {
            self.sites.push(Site { at: (site.at.0 + dx, site.at.1 + dy), ..site });
        }
        self.width = self.width.max(other.width + dx);
        self.height = self.height.max(other.height + dy);
    }

    /// A line from one end to the other, in whatever direction; nothing where it has no length.
    pub(crate) fn line(&mut self, a: (i32, i32), b: (i32, i32), double: bool) {
        if a != b {
            self.shapes.push(Shape::Line { from: a.min(b), to: a.max(b), double });
        }
    }

    /// A line of text.
    pub(crate) fn text(&mut self, at: (i32, i32), text: &str) {
        if !text.is_empty() {
            self.shapes.push(Shape::Text { at, text: text.to_owned(), half: false });
        }
    }

    /// A line of text around the middle of a square.
    pub(crate) fn centred(&mut self, (x, y): (i32, i32), text: &str) {
        let squares = width(text);
        let at = (x - squares / 2, y);
        self.shapes.push(Shape::Text { at, text: text.to_owned(), half: squares % 2 == 0 });
    }
}

/// Side by side in their order, each as far up and then as far left as there is room for it, with `gap` between them, on
/// paper of some `width`.
pub(crate) fn pack(drawings: Vec<Drawing>, width: i32, gap: (i32, i32)) -> Drawing {
    let width = drawings.iter().map(|drawing| drawing.width).max().unwrap_or(0).max(width);
    let mut all = Drawing::default();
    // What is taken, with the gap: from left to right, and down to where.
    let mut taken: Vec<(i32, i32, i32)> = Vec::new();
    for drawing in drawings {
        let starts = taken.iter().map(|place| place.1).chain([0]).filter(|x| *x == 0 || x + drawing.width <= width);
        let below = |x: i32| {
            let above = taken.iter().filter(|(left, right, _)| *left < x + drawing.width + gap.0 && x < *right);
            above.map(|place| place.2).max().unwrap_or(0)
        };
        let (y, x) = starts.map(|x| (below(x), x)).min().unwrap_or_default();
        taken.push((x, x + drawing.width + gap.0, y + drawing.height + gap.1));
        all.paste(drawing, (x, y));
    }
    all
}
