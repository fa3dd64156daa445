//! The lines, boxes and texts of an SVG picture.

/// A line from one end to the other: from left to right, or from top to bottom.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Line {
    /// Its place across: the row of a level one, the column of an upright one.
    pub(crate) at: i32,
    pub(crate) from: i32,
    pub(crate) to: i32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Rect {
    pub(crate) x: i32,
    pub(crate) y: i32,
    pub(crate) w: i32,
    pub(crate) h: i32,
    pub(crate) faint: bool,
}

impl Rect {
    pub(crate) fn holds(&self, (x, y): (i32, i32)) -> bool {
        self.x < x && x < self.x + self.w && self.y < y && y < self.y + self.h
    }

    pub(crate) fn touches(&self, (x, y): (i32, i32)) -> bool {
        self.x <= x && x <= self.x + self.w && self.y <= y && y <= self.y + self.h
    }
}

#[derive(Clone, Debug)]
pub(crate) struct Text {
    pub(crate) x: i32,
    pub(crate) y: i32,
    pub(crate) width: i32,
    pub(crate) says: String,
}

/// What the picture is made of.
#[derive(Default)]
pub(crate) struct Parts {
    pub(crate) level: Vec<Line>,
    pub(crate) upright: Vec<Line>,
    /// The middles of bars.
    pub(crate) bars: Vec<(i32, i32)>,
    pub(crate) rects: Vec<Rect>,
    pub(crate) texts: Vec<Text>,
    pub(crate) dots: Vec<(i32, i32)>,
    /// The tips of arrows, and where they point.
    pub(crate) arrows: Vec<((i32, i32), char)>,
}

fn number(tag: &str, name: &str) -> i32 {
    let value = tag.split(&format!(" {name}=\"")).nth(1).and_then(|rest| rest.split('"').next());
    value.and_then(|value| value.parse().ok()).unwrap_or_else(|| panic!("no {name} in {tag}"))
}

fn attribute<'t>(tag: &'t str, name: &str) -> Option<&'t str> {
    tag.split(&format!(" {name}=\"")).nth(1).and_then(|rest| rest.split('"').next())
}

fn plain(text: &str) -> String {
    text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&amp;", "&")
}

impl Parts {
    pub(crate) fn of(svg: &str) -> Self {
        let mut parts = Self::default();
        for tag in svg.split('<').skip(1) {
            let (tag, after) = tag.split_once('>').unwrap_or((tag, ""));
            match tag.split_whitespace().next() {
                Some("path") => {
                    let d = attribute(tag, "d").unwrap_or_default();
                    if d.contains('z') {
                        parts.arrow(d);
                    } else {
                        parts.path(d, tag.contains("stroke-width"));
                    }
                }
                Some("rect") => parts.rects.push(Rect {
                    x: number(tag, "x"),
                    y: number(tag, "y"),
                    w: number(tag, "width"),
                    h: number(tag, "height"),
                    faint: tag.contains("stroke-opacity"),
                }),
                Some("circle") => parts.dots.push((number(tag, "cx"), number(tag, "cy"))),
                Some("text") => parts.texts.push(Text {
                    x: number(tag, "x"),
                    y: number(tag, "y"),
                    width: number(tag, "textLength"),
                    says: plain(after),
                }),
                _ => {}
            }
        }
        parts
    }

    /// `M8 8H20V4h-3l7 -7`
    fn path(&mut self, d: &str, thick: bool) {
        let mut at = (0, 0);
        let starts: Vec<usize> = d.char_indices().filter(|(_, c)| c.is_alphabetic()).map(|(i, _)| i).collect();
        for (number, start) in starts.iter().enumerate() {
            let end = starts.get(number + 1).copied().unwrap_or(d.len());
            let values: Vec<i32> = d[start + 1..end].split([' ', ',']).filter_map(|value| value.parse().ok()).collect();
            let to = match (&d[*start..=*start], &values[..]) {
                ("M" | "L", [x, y]) => (*x, *y),
                ("H", [x]) => (*x, at.1),
                ("h", [x]) => (at.0 + x, at.1),
                ("V", [y]) => (at.0, *y),
                ("v", [y]) => (at.0, at.1 + y),
                ("l", [x, y]) => (at.0 + x, at.1 + y),
                other => panic!("{other:?} in a path"),
            };
            let drawn = d[*start..=*start] != *"M";
            if drawn && thick {
                self.bars.push(((at.0 + to.0) / 2, at.1));
            } else if drawn && at.1 == to.1 {
                self.level.push(Line { at: at.1, from: at.0.min(to.0), to: at.0.max(to.0) });
            } else if drawn && at.0 == to.0 {
                self.upright.push(Line { at: at.0, from: at.1.min(to.1), to: at.1.max(to.1) });
            }
            at = to;
        }
    }

    fn arrow(&mut self, d: &str) {
        let values: Vec<i32> =
            d.split(|c: char| c != '-' && !c.is_ascii_digit()).filter_map(|v| v.parse().ok()).collect();
        let heading = match values[2..] {
            [4, 9, ..] => '^',
            [4, -9, ..] => 'v',
            [9, 4, ..] => '<',
            _ => panic!("an arrow {d}"),
        };
        self.arrows.push(((values[0], values[1]), heading));
    }
}
