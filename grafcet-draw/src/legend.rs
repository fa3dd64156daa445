//! What the names of conditions stand for, beside the nets that use them.

use grafcet_core::description::Description;

use crate::shape::{Drawing, Frame, Shape};
use crate::wording::LINES;
use crate::wrap::{width, wrap};

/// Texts are broken at so many squares: with the frame around them they fit a terminal.
const TEXT: i32 = 70;
/// So many names are shown.
const MOST: usize = 60;
/// How far below its name what is said of it stands to the right.
const INDENT: i32 = 4;

/// The named conditions of a chart in a frame, one below the other; none where it has none.
pub(crate) fn legend(chart: &Description<'_>) -> Option<Drawing> {
    let mut lines: Vec<(i32, String)> = Vec::new();
    // One more takes no more room than the words that there is one more.
    let shown = if chart.lets.len() == MOST + 1 { chart.lets.len() } else { MOST };
    for named in chart.lets.iter().take(shown) {
        let text = wrap(&format!("{} = {}", named.name, named.text), TEXT, LINES);
        lines.extend(text.into_iter().enumerate().map(|(row, line)| (if row == 0 { 0 } else { INDENT / 2 }, line)));
        let about = wrap(named.doc, TEXT - INDENT, LINES);
        lines.extend(about.into_iter().filter(|line| !line.is_empty()).map(|line| (INDENT, line)));
    }
    if chart.lets.len() > shown {
        lines.push((0, format!("and {} more", chart.lets.len() - shown)));
    }
    let wide = lines.iter().map(|(indent, line)| indent + width(line)).max()?;
    let size = (wide + 4, i32::try_from(lines.len()).unwrap_or(0) + 2);
    let mut drawing = Drawing { width: size.0, height: size.1, ..Drawing::default() };
    drawing.shapes.push(Shape::Frame { at: (0, 0), size, kind: Frame::Sheet });
    for (row, (indent, line)) in (1..).zip(&lines) {
        drawing.text((2 + indent, row), line);
    }
    Some(drawing)
}
