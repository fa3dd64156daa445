//! What lines mean, by the rules of drawing of IEC 60848: from what hangs on each piece of line to steps, transitions and
//! their sources and targets.

use std::collections::BTreeMap;

/// A step or macro-step, as it is seen.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Box {
    pub(crate) name: String,
    pub(crate) initial: bool,
    /// The heading of the frame around it.
    pub(crate) sheet: String,
    /// Its middle and its upper edge.
    pub(crate) at: (i32, i32),
}

/// A bar with what is written beside it.
#[derive(Clone, Debug)]
pub(crate) struct Bar {
    pub(crate) name: String,
    /// The condition, and what is done on clearing: without blanks, which tell nothing where lines are broken.
    pub(crate) text: String,
    pub(crate) at: (i32, i32),
}

/// Where a piece of line ends at something else.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum End {
    /// At the top of a box, or at its bottom.
    Top(usize),
    Bottom(usize),
    /// At a bar, from above or from below.
    Over(usize),
    Under(usize),
    /// At a double line, from above or from below.
    OnDouble(usize),
    BelowDouble(usize),
    /// An arrow down to a name.
    To(String),
    /// An arrow from names.
    From(String),
    /// Words above a line of its own: what an `any` leaves.
    Any(String),
}

/// A piece of line: all that is connected without a bar, box or double line between.
#[derive(Clone, Debug, Default)]
pub(crate) struct Piece {
    pub(crate) ends: Vec<End>,
    /// It has the head of an arrow that points up.
    pub(crate) arrow: bool,
    /// The numbers at its branches, with the ends after each.
    pub(crate) ranks: Vec<(usize, Vec<End>)>,
}

/// A picture, taken apart.
#[derive(Clone, Debug, Default)]
pub(crate) struct Seen {
    pub(crate) boxes: Vec<Box>,
    pub(crate) bars: Vec<Bar>,
    pub(crate) doubles: usize,
    pub(crate) pieces: Vec<Piece>,
    /// What is written in a frame in which nothing is drawn.
    pub(crate) legend: String,
    /// What cannot be read, whatever it should mean.
    pub(crate) faults: Vec<String>,
}

/// A transition as it is read: the names of its steps in alphabetic order.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Read {
    pub(crate) sources: Vec<String>,
    /// `anyexceptA`: without blanks, as lines may be broken there.
    pub(crate) any: String,
    pub(crate) targets: Vec<String>,
    pub(crate) name: String,
    pub(crate) text: String,
}

/// A net as it is read.
#[derive(Debug, Default)]
pub(crate) struct Net {
    /// Name, whether it is initial, and the heading of its frame.
    pub(crate) steps: Vec<(String, bool, String)>,
    pub(crate) transitions: Vec<Read>,
    /// For each step with numbers at its branches: the texts of the transitions, in the order of the numbers.
    pub(crate) ranks: BTreeMap<String, Vec<String>>,
    /// What named conditions stand for, without blanks.
    pub(crate) legend: String,
    pub(crate) faults: Vec<String>,
}

/// Reads a picture.
pub(crate) fn net(seen: &Seen) -> Net {
    let mut reader = Reader { seen, faults: seen.faults.clone(), from: BTreeMap::new() };
    let mut transitions = Vec::new();
    for (bar, shown) in seen.bars.iter().enumerate() {
        let sources = reader.sources(bar);
        let targets = reader.targets(bar);
        let any = reader.any(bar);
        transitions.push(Read { sources, any, targets, name: shown.name.clone(), text: shown.text.clone() });
    }
    for piece in &seen.pieces {
        reader.piece(piece);
    }
    reader.references(&transitions);
    let ranks = reader.ranks();
    transitions.sort();
    let mut steps: Vec<_> = seen.boxes.iter().map(|b| (b.name.clone(), b.initial, b.sheet.clone())).collect();
    steps.sort();
    Net { steps, transitions, ranks, legend: seen.legend.clone(), faults: reader.faults }
}

struct Reader<'s> {
    seen: &'s Seen,
    faults: Vec<String>,
    /// The bars that lead to names by arrows.
    from: BTreeMap<String, Vec<usize>>,
}

impl Reader<'_> {
    fn pieces(&self, end: &End) -> Vec<usize> {
        let has = |(_, piece): &(usize, &Piece)| piece.ends.contains(end);
        self.seen.pieces.iter().enumerate().filter(has).map(|(id, _)| id).collect()
    }

    /// The only piece with this end; none where nothing leads there.
    fn piece_at(&mut self, end: &End) -> Option<usize> {
        match self.pieces(end)[..] {
            [] => None,
            [one] => Some(one),
            _ => {
                self.faults.push(format!("{end:?} is the end of several lines"));
                None
            }
        }
    }

    fn name(&self, step: usize) -> String {
        self.seen.boxes[step].name.clone()
    }

    fn shown(&self, ends: &[End]) -> String {
        let show = |end: &End| match end {
            End::Top(step) => format!("to {}", self.name(*step)),
            End::Bottom(step) => format!("from {}", self.name(*step)),
            End::Over(bar) => format!("to the bar `{}` at {:?}", self.seen.bars[*bar].text, self.seen.bars[*bar].at),
            End::Under(bar) => format!("from the bar `{}` at {:?}", self.seen.bars[*bar].text, self.seen.bars[*bar].at),
            other => format!("{other:?}"),
        };
        ends.iter().map(show).collect::<Vec<_>>().join(", ")
    }

    fn sources(&mut self, bar: usize) -> Vec<String> {
        let Some(piece) = self.piece_at(&End::Over(bar)) else { return Vec::new() };
        let ends = &self.seen.pieces[piece].ends;
        let doubles: Vec<usize> =
            ends.iter().filter_map(|end| if let End::BelowDouble(id) = end { Some(*id) } else { None }).collect();
        let mut above = vec![piece];
        if let [double] = doubles[..] {
            if ends.len() != 2 {
                self.faults.push(format!("a line below a double line: {}", self.shown(ends)));
            }
            above = self.pieces(&End::OnDouble(double));
            if above.len() < 2 {
                self.faults.push(format!("a double line that collects {} lines", above.len()));
            }
        } else if !doubles.is_empty() {
            self.faults.push(format!("a line between double lines: {}", self.shown(ends)));
        }
        let mut names = Vec::new();
        for piece in above {
            let ends = &self.seen.pieces[piece].ends;
            let steps: Vec<String> = ends
                .iter()
                .filter_map(|end| if let End::Bottom(id) = end { Some(self.name(*id)) } else { None })
                .collect();
            let any = ends.iter().any(|end| matches!(end, End::Any(_)));
            let none = steps.is_empty() && ends.len() > if any { 2 } else { 1 };
            if steps.len() + usize::from(any) > 1 || none || doubles.len() == 1 && steps.is_empty() {
                self.faults.push(format!("a line to a transition: {}", self.shown(ends)));
            }
            names.extend(steps);
        }
        names.sort();
        names
    }

    /// The words above its line where it has one of its own.
    fn any(&self, bar: usize) -> String {
        let ends = self.seen.pieces.iter().filter(|piece| piece.ends.contains(&End::Over(bar))).flat_map(|p| &p.ends);
        ends.filter_map(|end| if let End::Any(words) = end { Some(words.as_str()) } else { None }).collect()
    }

    fn targets(&mut self, bar: usize) -> Vec<String> {
        let Some(piece) = self.piece_at(&End::Under(bar)) else { return Vec::new() };
        let ends = &self.seen.pieces[piece].ends;
        let double = ends.iter().find_map(|end| if let End::OnDouble(id) = end { Some(*id) } else { None });
        let mut below = vec![piece];
        if let Some(double) = double {
            if ends.len() != 2 {
                self.faults.push(format!("a line to a double line: {}", self.shown(ends)));
            }
            below = self.pieces(&End::BelowDouble(double));
            if below.len() < 2 {
                self.faults.push(format!("a double line that spreads to {} lines", below.len()));
            }
        }
        let mut names = Vec::new();
        for piece in below {
            let ends = &self.seen.pieces[piece].ends;
            let mut here = Vec::new();
            for end in ends {
                match end {
                    End::Top(step) => here.push(self.name(*step)),
                    End::To(name) => {
                        here.push(name.clone());
                        self.from.entry(name.clone()).or_default().push(bar);
                    }
                    _ => {}
                }
            }
            let nothing = here.is_empty() && (ends.len() > 1 || double.is_some());
            if here.len() > 1 || nothing {
                self.faults.push(format!("a line from a transition: {}", self.shown(ends)));
            }
            names.extend(here);
        }
        names.sort();
        names
    }

    /// What may hang together, and which way a line goes.
    fn piece(&mut self, piece: &Piece) {
        let ends = &piece.ends;
        let before = ends.iter().any(|end| matches!(end, End::Bottom(_) | End::Over(_)));
        let after = ends.iter().any(|end| matches!(end, End::Under(_) | End::Top(_) | End::To(_) | End::From(_)));
        if before && after {
            self.faults.push(format!("a line without a transition or step between: {}", self.shown(ends)));
        }
        // A source or sink transition has a line of its own that leads nowhere.
        let stub = matches!(ends[..], [End::Over(_) | End::Under(_)]);
        if ends.len() < 2 && !stub {
            self.faults.push(format!("a line that leads nowhere: {}", self.shown(ends)));
        }
        let top =
            ends.iter().find_map(|end| if let End::Top(step) = end { Some(self.seen.boxes[*step].at.1) } else { None });
        let below = |end: &End| match end {
            End::Under(bar) => top.is_some_and(|top| self.seen.bars[*bar].at.1 > top),
            _ => false,
        };
        let up = ends.iter().any(below);
        if up != piece.arrow {
            self.faults.push(format!("{} arrow up: {}", if up { "no" } else { "an" }, self.shown(ends)));
        }
    }

    /// At the step that arrows lead to stand the names of those before them.
    fn references(&mut self, transitions: &[Read]) {
        let mut named: BTreeMap<String, String> = BTreeMap::new();
        for piece in &self.seen.pieces {
            let from = piece.ends.iter().find_map(|end| if let End::From(names) = end { Some(names) } else { None });
            let to = piece.ends.iter().find_map(|end| if let End::Top(step) = end { Some(*step) } else { None });
            match (from, to) {
                (Some(from), Some(to)) => drop(named.insert(self.name(to), from.clone())),
                (Some(from), None) => self.faults.push(format!("an arrow from {from} to no step")),
                _ => {}
            }
        }
        for (to, bars) in &self.from {
            let origins = |bar: &usize| match &transitions[*bar] {
                // One without steps before it has its name there.
                Read { sources, any, name, .. } if sources.is_empty() => match (&**name, &**any) {
                    ("", "") => vec!["()"],
                    ("", _) => vec!["any"],
                    _ => vec![name.as_str()],
                },
                Read { sources, .. } => sources.iter().map(String::as_str).collect(),
            };
            let mut expected: Vec<&str> = bars.iter().flat_map(origins).collect();
            expected.sort_unstable();
            expected.dedup();
            let listed = named.remove(to).unwrap_or_default();
            let mut shown: Vec<&str> = listed.split(',').filter(|name| !name.is_empty()).collect();
            shown.sort_unstable();
            if shown != expected && !listed.ends_with('…') {
                self.faults.push(format!("arrows lead from {expected:?} to {to}, where {shown:?} stands"));
            }
        }
        for (to, from) in named {
            self.faults.push(format!("{from} stands at {to}, and no arrow leads there"));
        }
    }

    /// The transitions of each step in the order of the numbers at its branches.
    fn ranks(&mut self) -> BTreeMap<String, Vec<String>> {
        let mut ranks = BTreeMap::new();
        for piece in self.seen.pieces.iter().filter(|piece| !piece.ranks.is_empty()) {
            let step = piece.ends.iter().find_map(|end| if let End::Bottom(step) = end { Some(*step) } else { None });
            let Some(step) = step else {
                self.faults.push(format!("numbers at {}", self.shown(&piece.ends)));
                continue;
            };
            let mut numbered = piece.ranks.clone();
            numbered.sort_by_key(|(number, _)| *number);
            if numbered.iter().enumerate().any(|(place, (number, _))| place + 1 != *number) || numbered.len() < 2 {
                self.faults.push(format!("the numbers at the branches of {}: {numbered:?}", self.name(step)));
            }
            let mut bars = Vec::new();
            for (_, ends) in &numbered {
                match self.bars_after(ends)[..] {
                    [bar] => bars.push(self.seen.bars[bar].text.clone()),
                    _ => self.faults.push(format!("a number at {}", self.shown(ends))),
                }
            }
            ranks.insert(self.name(step), bars);
        }
        ranks
    }

    /// The bars to which these ends lead.
    fn bars_after(&self, ends: &[End]) -> Vec<usize> {
        let mut bars = Vec::new();
        for end in ends {
            match end {
                End::Over(bar) => bars.push(*bar),
                End::OnDouble(double) => {
                    for piece in self.pieces(&End::BelowDouble(*double)) {
                        let over = |end: &End| if let End::Over(bar) = end { Some(*bar) } else { None };
                        bars.extend(self.seen.pieces[piece].ends.iter().filter_map(over));
                    }
                }
                _ => {}
            }
        }
        bars
    }
}
