//! Sizes of paper, and what stands around a drawing on it. All lengths are points (1/72 inch).

use std::fmt::Write as _;

use grafcet_draw::pages::Page;

use crate::draw::{OnPaper, Paper};

/// Room to file the page on its left, and around the frame else (ISO 5457: 20 mm and 10 mm).
const LEFT: f32 = 56.7;
const AROUND: f32 = 28.3;
/// The height of the title block.
const TITLE: f32 = 38.0;
/// From the frame to the drawing.
const PAD: f32 = 8.0;
/// What one pixel of a drawing takes: as large as on a screen, or with letters of 2.6 mm, where that spares pages.
const SCALES: [f32; 2] = [0.75, 0.5625];
/// A letter of `DejaVu Sans Mono` is so much wider than its size.
const LETTER: f32 = 0.602;

impl Paper {
    /// Width and height, upright.
    fn size(self) -> (f32, f32) {
        let millimetres = |wide: f32, high: f32| (wide * 72.0 / 25.4, high * 72.0 / 25.4);
        match self {
            Self::A5 => millimetres(148.0, 210.0),
            Self::A4 => millimetres(210.0, 297.0),
            Self::A3 => millimetres(297.0, 420.0),
            Self::A2 => millimetres(420.0, 594.0),
            Self::A1 => millimetres(594.0, 841.0),
            Self::A0 => millimetres(841.0, 1189.0),
            Self::Letter => (612.0, 792.0),
            Self::Legal => (612.0, 1008.0),
            Self::Tabloid => (792.0, 1224.0),
        }
    }
}

/// What the title block says.
pub(super) struct Block {
    pub(super) kind: &'static str,
    pub(super) name: String,
    pub(super) source: String,
    pub(super) version: String,
    pub(super) date: String,
}

/// The pages of a chart and how they lie on paper.
pub(super) struct Sheet {
    pub(super) size: (f32, f32),
    pub(super) pages: Vec<Page>,
    scale: f32,
}

impl Sheet {
    /// Upright or across, where nobody says: what needs the fewest pages, and of these the fewest connectors. One page is as large as it can be.
    pub(super) fn of(options: &OnPaper, mut pages: impl FnMut((i32, i32)) -> Vec<Page>) -> Self {
        let (wide, high) = options.paper.size();
        let ways = match (options.portrait, options.landscape) {
            (true, _) => vec![(wide, high)],
            (_, true) => vec![(high, wide)],
            _ => vec![(wide, high), (high, wide)],
        };
        let mut best: Option<Self> = None;
        for scale in SCALES {
            for size in &ways {
                let mut sheet = Self { size: *size, pages: Vec::new(), scale };
                sheet.pages = pages(sheet.squares());
                if best.as_ref().is_none_or(|best| sheet.cost() < best.cost()) {
                    best = Some(sheet);
                }
            }
        }
        best.unwrap_or(Self { size: (wide, high), pages: Vec::new(), scale: SCALES[0] })
    }

    fn cost(&self) -> (usize, usize, usize) {
        // What has to be made smaller to fit can be read no more.
        let small = self.pages.iter().filter(|page| self.fitting(page) < 1.0).count();
        (small, self.pages.len(), self.pages.iter().map(|page| page.connectors.len()).sum())
    }

    /// Where the drawing may stand: its upper left corner, and its size.
    fn room(&self) -> ((f32, f32), (f32, f32)) {
        let (wide, high) = self.size;
        ((LEFT + PAD, AROUND + PAD), (wide - LEFT - AROUND - 2.0 * PAD, high - 2.0 * AROUND - TITLE - 2.0 * PAD))
    }

    /// The same in squares of a drawing.
    fn squares(&self) -> (i32, i32) {
        let (_, (wide, high)) = self.room();
        // Of a page of paper there are some hundred squares.
        #[expect(clippy::cast_possible_truncation, reason = "hundreds")]
        let squares = |points: f32, square: f32| ((points / self.scale - 8.0) / square).floor() as i32;
        (squares(wide, 8.0), squares(high, 16.0))
    }

    /// How much smaller than the others a page is that does not fit.
    fn fitting(&self, page: &Page) -> f32 {
        let (wide, high) = pixels(page);
        let (_, room) = self.room();
        (room.0 / (wide * self.scale)).min(room.1 / (high * self.scale)).min(1.0)
    }

    /// From pixels of a page's drawing to points: what is added, and the scale.
    pub(super) fn place(&self, page: &Page) -> ((f32, f32), f32) {
        (self.room().0, self.scale * self.fitting(page))
    }

    /// A page with its frame and title block, in points.
    pub(super) fn svg(&self, number: usize, block: &Block) -> String {
        let (wide, high) = self.size;
        let page = &self.pages[number];
        let ((x, y), scale) = self.place(page);
        let drawing = page.svg(&block.name);
        let title = title(self.size, block, number + 1, self.pages.len());
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{wide}\" height=\"{high}\" viewBox=\"0 0 {wide} {high}\">\
             <rect width=\"{wide}\" height=\"{high}\" fill=\"#fff\"/>{title}\
             <g transform=\"translate({x} {y}) scale({scale})\">{drawing}</g></svg>"
        )
    }
}

#[expect(clippy::cast_precision_loss, reason = "thousands")]
fn pixels(page: &Page) -> (f32, f32) {
    let (wide, high) = page.pixels();
    (wide as f32, high as f32)
}

/// The frame, and the title block in its lower edge.
fn title((wide, high): (f32, f32), block: &Block, page: usize, pages: usize) -> String {
    let (left, right, bottom) = (LEFT, wide - AROUND, high - AROUND);
    let top = bottom - TITLE;
    let mut lines = format!("M{left} {AROUND}H{right}V{bottom}H{left}ZM{left} {top}H{right}");
    let mut texts = String::new();
    // From the right to the left.
    let cells = [
        ("Page", format!("{page} of {pages}"), 62.0),
        ("Date", block.date.clone(), 72.0),
        ("Version", block.version.clone(), 68.0),
    ];
    let mut end = right;
    for (label, value, width) in cells {
        let begin = end - width;
        // Writing to a string cannot fail.
        _ = write!(lines, "M{begin} {top}V{bottom}");
        cell((begin, top), width, label, &value, &mut texts);
        end = begin;
    }
    let label = format!("{} · {}", block.kind, block.source);
    cell((left, top), end - left, &label, &block.name, &mut texts);
    format!(
        "<path d=\"{lines}\" fill=\"none\" stroke=\"#1f2328\" stroke-width=\"0.7\"/>\
         <g fill=\"#1f2328\" font-family=\"monospace\">{texts}</g>"
    )
}

/// A small label, and below it what it is about; a long text has small letters, a longer one an ellipsis.
fn cell((x, y): (f32, f32), width: f32, label: &str, value: &str, to: &mut String) {
    let room = width - 10.0;
    for (text, largest, smallest, down) in [(label, 6.0_f32, 4.5_f32, 11.0), (value, 12.0, 6.0, 29.0)] {
        let count = u16::try_from(text.chars().count()).unwrap_or(u16::MAX);
        let size = (room / (f32::from(count.max(1)) * LETTER)).clamp(smallest, largest);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "hundreds")]
        let most = (room / (size * LETTER)) as usize;
        let shown: String = match text.char_indices().nth(most) {
            // The first words say what is meant.
            Some(_) => text.chars().take(most.saturating_sub(1)).chain(['…']).collect(),
            None => text.to_owned(),
        };
        // Writing to a string cannot fail.
        _ = write!(to, "<text x=\"{}\" y=\"{}\" font-size=\"{size}\">{}</text>", x + 5.0, y + down, escaped(&shown));
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
