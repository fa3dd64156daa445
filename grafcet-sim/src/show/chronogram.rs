//! A trace as a chronogram: steps, inputs, outputs and variables over time.

use std::fmt::Write as _;

use super::{Axis, escape};
use crate::trace::Trace;
use crate::value::Value;

const ROW: u64 = 24;
const TOP: u64 = 30;
const HEADING: u64 = 26;
/// Of a character, in tenths of a pixel.
const CHARACTER: usize = 75;

/// A trace as an SVG that stands for itself, in the colours of the reader's theme: steps, inputs, outputs and variables over time, gaps
/// marked. Where the chart's clock stands still, the way from left to right counts cycles.
#[must_use]
pub fn chronogram(trace: &Trace) -> String {
    let Paper { body, width, height, .. } = Paper::of(trace);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
         role=\"img\" aria-label=\"Chronogram of {}\"><style>:root{{color-scheme:light dark;--paper:#fff;--ink:#1f2328;--faint:#d0d7de;\
         --step:#0969da;--high:#1a7f37;--bad:#cf222e}}@media(prefers-color-scheme:dark){{:root{{--paper:#0d1117;--ink:#e6edf3;\
         --faint:#30363d;--step:#4493f8;--high:#3fb950;--bad:#f85149}}}}{STYLE}</style>\
         <rect width=\"100%\" height=\"100%\" fill=\"var(--paper)\"/>{body}</svg>",
        escape(&trace.names.chart)
    )
}

/// The looks of its parts, by the colours of whoever shows it.
pub(super) const STYLE: &str = ".cg text{font:12px ui-monospace,monospace;fill:var(--ink)}.cg .h{font-weight:600;opacity:.75}\
    .cg .t{font-size:11px;opacity:.75}.cg .l{stroke:var(--faint);fill:none}.cg .s{fill:var(--step)}.cg .w{stroke:var(--high);\
    fill:none;stroke-width:1.5}.cg .f{fill:var(--high);fill-opacity:.25}.cg .v{stroke:var(--high);fill:none}\
    .cg .g{stroke:var(--bad);stroke-dasharray:4 3}.cg text.g{stroke:none;fill:var(--bad)}";

/// The drawing, and how places on it follow from times.
pub(super) struct Paper {
    pub(super) body: String,
    pub(super) width: u64,
    pub(super) height: u64,
    /// Where the axis begins.
    pub(super) left: u64,
    /// How long it is.
    pub(super) length: u64,
    pub(super) axis: Axis,
}

impl Paper {
    pub(super) fn of(trace: &Trace) -> Self {
        let axis = Axis::of(trace);
        let names = &trace.names;
        let signals = || names.inputs.iter().chain(&names.outputs).chain(&names.variables).map(|signal| &signal.name);
        let longest = names.steps.iter().map(|step| &step.name).chain(signals()).map(|name| name.chars().count()).max();
        let left = (longest.unwrap_or(0).clamp(8, 30) * CHARACTER / 10 + 20) as u64;
        // Wide enough for cycles that can be told apart, and not endless.
        let length = (trace.cycles.len() as u64 * 14).clamp(640, 8000);
        let mut paper = Self { body: String::new(), width: left + length + 20, height: TOP, left, length, axis };
        paper.rows(trace);
        // After the rows, which tell how high it all is.
        let rows = std::mem::take(&mut paper.body);
        paper.body.push_str("<g class=\"cg\">");
        paper.ticks(trace);
        paper.body.push_str(&rows);
        paper.gaps(trace);
        paper.body.push_str("</g>");
        paper
    }

    /// The place of a time, in pixels.
    fn x(&self, at: u64) -> u64 {
        let along = u128::from(at) * u128::from(self.length) / u128::from(self.axis.end.max(1));
        self.left + u64::try_from(along).unwrap_or(self.length)
    }

    /// Where a cycle begins, and the one after the last.
    fn start(&self, cycle: usize) -> u64 {
        self.x(self.axis.starts.get(cycle).copied().unwrap_or(self.axis.end))
    }

    fn rows(&mut self, trace: &Trace) {
        let names = &trace.names;
        self.heading("steps");
        for (step, named) in names.steps.iter().enumerate() {
            self.label(&named.name);
            self.step(trace, step);
            self.height += ROW;
        }
        let groups = [("inputs", &names.inputs), ("outputs", &names.outputs), ("variables", &names.variables)];
        for (group, (heading, signals)) in groups.into_iter().enumerate() {
            if !signals.is_empty() {
                self.heading(heading);
            }
            for (place, signal) in signals.iter().enumerate() {
                self.label(&signal.name);
                let values: Vec<&Value> = trace
                    .cycles
                    .iter()
                    .map(|cycle| &[&cycle.inputs, &cycle.outputs, &cycle.variables][group][place])
                    .collect();
                self.signal(&values);
                self.height += ROW;
            }
        }
        self.height += 10;
    }

    fn heading(&mut self, text: &str) {
        _ = write!(self.body, "<text class=\"h\" x=\"8\" y=\"{}\">{text}</text>", self.height + 17);
        self.height += HEADING;
    }

    fn label(&mut self, name: &str) {
        let (y, right) = (self.height, self.left + self.length);
        let shown: String =
            if name.chars().count() > 30 { name.chars().take(29).chain(['…']).collect() } else { name.to_owned() };
        _ = write!(self.body, "<text x=\"14\" y=\"{}\">{}</text>", y + 16, escape(&shown));
        _ = write!(self.body, "<path class=\"l\" d=\"M{} {}.5H{right}\"/>", self.left, y + 20);
    }

    /// A bar while it is active, a thin one where it was so within a cycle.
    fn step(&mut self, trace: &Trace, step: usize) {
        let mut d = String::new();
        let y = self.height;
        let active: Vec<bool> = trace.cycles.iter().map(|cycle| cycle.steps.contains(&step)).collect();
        for (first, last) in runs(&active).into_iter().filter(|(first, _)| active[*first]) {
            let (from, to) = (self.start(first), self.start(last + 1));
            _ = write!(d, "M{from} {}H{to}v14H{from}z", y + 5, to = to.max(from + 2));
        }
        for (index, cycle) in trace.cycles.iter().enumerate().filter(|(index, _)| !active[*index]) {
            if cycle.evolutions.iter().any(|evolution| evolution.activated.contains(&step)) {
                _ = write!(d, "M{} {}h2v14h-2z", self.start(index), y + 5);
            }
        }
        _ = write!(self.body, "<path class=\"s\" d=\"{d}\"/>");
    }

    fn signal(&mut self, values: &[&Value]) {
        let y = self.height;
        let runs = runs(values);
        if values.iter().all(|value| matches!(value, Value::Bool(_))) {
            let (mut line, mut fill) = (String::new(), String::new());
            for (first, last) in runs {
                let (from, to) = (self.start(first), self.start(last + 1));
                let high = values[first].is_true();
                let level = if high { y + 6 } else { y + 19 };
                _ = write!(line, "{}{from} {level}H{to}", if line.is_empty() { "M" } else { "L" });
                if high {
                    _ = write!(fill, "M{from} {}H{to}V{}H{from}z", y + 6, y + 19);
                }
            }
            _ = write!(self.body, "<path class=\"f\" d=\"{fill}\"/><path class=\"w\" d=\"{line}\"/>");
            return;
        }
        for (first, last) in runs {
            let (from, to) = (self.start(first), self.start(last + 1));
            let (wide, text) = (to - from, values[first].to_string());
            _ = write!(self.body, "<rect class=\"v\" x=\"{from}\" y=\"{}\" width=\"{wide}\" height=\"14\"/>", y + 5);
            if text.chars().count() * CHARACTER / 10 + 6 <= usize::try_from(wide).unwrap_or(0) {
                _ = write!(self.body, "<text x=\"{}\" y=\"{}\">{}</text>", from + 4, y + 16, escape(&text));
            }
        }
    }

    /// Lines at round times.
    fn ticks(&mut self, trace: &Trace) {
        let least = (self.axis.end / (self.length / 90).max(1)).max(1);
        let mut step = 1_u64;
        while step < least {
            // 1, 2, 5, 10, …
            let leading = step / 10_u64.pow(step.ilog10());
            step = if leading == 2 { step / 2 * 5 } else { step * 2 };
        }
        let mut at = 0;
        while at <= self.axis.end {
            let x = self.x(at);
            let label = self.axis.label(trace, at);
            _ = write!(self.body, "<path class=\"l\" d=\"M{x}.5 {}V{}\"/>", TOP - 4, self.height);
            _ = write!(
                self.body,
                "<text class=\"t\" x=\"{x}\" y=\"{}\" text-anchor=\"middle\">{label}</text>",
                TOP - 10
            );
            at += step;
        }
        let what = if self.axis.is_time { "time" } else { "cycle" };
        _ = write!(self.body, "<text class=\"t\" x=\"8\" y=\"{}\">{what}</text>", TOP - 10);
    }

    fn gaps(&mut self, trace: &Trace) {
        for (cycle, gap) in trace.gaps() {
            let x = self.start(cycle);
            let reason = escape(&gap.reason);
            _ = write!(self.body, "<path class=\"g\" d=\"M{x} {TOP}V{}\"><title>{reason}</title></path>", self.height);
            _ = write!(self.body, "<text class=\"g t\" x=\"{}\" y=\"{}\">gap</text>", x + 3, TOP + 10);
        }
    }
}

/// From where to where one value stays.
fn runs<T: PartialEq>(values: &[T]) -> Vec<(usize, usize)> {
    let mut runs: Vec<(usize, usize)> = Vec::new();
    for (index, value) in values.iter().enumerate() {
        match runs.last_mut() {
            Some(run) if values[run.0] == *value => run.1 = index,
            _ => runs.push((index, index)),
        }
    }
    runs
}
