//! A page as SVG.

use std::fmt::Write as _;

use super::{Connector, Page, Side};
use crate::svg::{MARGIN, SQUARE, Style, middle, write_upon};

/// The radius of a connector, in pixels.
const RADIUS: i32 = 7;

impl Page {
    /// The page as SVG, as [`svg`](crate::svg()) draws a chart: in pixels, dark on white.
    ///
    /// A connector is a circle with its number, and beside it the page of the other one.
    #[must_use]
    pub fn svg(&self, name: &str) -> String {
        let (mut lines, mut texts) = (String::new(), String::new());
        for connector in &self.connectors {
            circle(connector, &mut lines, &mut texts);
        }
        for reference in &self.references {
            let (x, y) = middle(reference.at);
            // Writing to a string cannot fail.
            _ = write!(texts, "<text x=\"{}\" y=\"{y}\" text-anchor=\"start\">p{}</text>", x + 7, reference.page);
        }
        let marks = format!(
            "<path d=\"{lines}\" fill=\"none\" stroke=\"currentColor\"/><g fill=\"currentColor\" font-family=\"monospace\" \
             font-size=\"10\" text-anchor=\"middle\" dominant-baseline=\"central\">{texts}</g>"
        );
        write_upon(name, &self.drawing, Style::Paper, &marks)
    }

    /// The width and height of that picture in pixels.
    #[must_use]
    pub fn pixels(&self) -> (i32, i32) {
        (self.drawing.width * SQUARE.0 + 2 * MARGIN, self.drawing.height * SQUARE.1 + 2 * MARGIN)
    }
}

/// The circle, the line to it, and its two numbers.
fn circle(connector: &Connector, lines: &mut String, texts: &mut String) {
    let (x, y) = middle(connector.at);
    let (r, half) = (RADIUS, SQUARE.1 / 2);
    // From the end of the line to the circle, and where the page is said.
    let (stub, (page_x, page_y)) = match connector.side {
        Side::Top => (format!("M{x} {}V{}", y + r, y + 2 * half), (x, y - r - half)),
        Side::Bottom => (format!("M{x} {}V{}", y - 2 * half, y - r), (x, y + r + half)),
        Side::Left => (format!("M{} {y}h1", x + r), (x - r - 11, y)),
        Side::Right => (format!("M{} {y}h1", x - r - 1), (x + r + 11, y)),
    };
    // Writing to a string cannot fail.
    _ = write!(lines, "{stub}M{} {y}a{r} {r} 0 1 0 {} 0a{r} {r} 0 1 0 {} 0", x - r, 2 * r, -2 * r);
    _ = write!(
        texts,
        "<text x=\"{x}\" y=\"{y}\">{}</text><text x=\"{page_x}\" y=\"{page_y}\">p{}</text>",
        connector.number, connector.page
    );
}
