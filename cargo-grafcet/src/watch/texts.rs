//! The charts that may run at a source, as their files say now: who changes a chart while he looks at it needs no new start.

use std::fs;
use std::path::PathBuf;

use grafcet_sim::Chart;

use crate::args::Charts;
use crate::find::{self, Found};

/// What was read of one source's charts, and how it is read again.
pub(crate) struct Texts {
    options: Charts,
    /// The one chart that is said to run there.
    chosen: Option<String>,
    /// The files that the charts stand in, as they were when they were looked at last.
    files: Vec<(PathBuf, String)>,
    /// What stands between the braces of each chart that can be run: another thread reads it anew, as tokens cannot be handed over.
    charts: Vec<String>,
}

impl Texts {
    pub(crate) fn of(options: Charts, chosen: Option<&str>, found: &[Found], running: &[&Found]) -> Self {
        let meant = running.iter().filter(|chart| chosen.is_none_or(|name| chart.name == name));
        let charts = meant.map(|chart| text(chart)).collect();
        Self { options, chosen: chosen.map(str::to_owned), files: files(found), charts }
    }

    /// The charts, compiled in the thread that asks.
    pub(crate) fn compiled(&self) -> Vec<Chart> {
        self.charts.iter().filter_map(|text| Chart::parse(text).ok()).collect()
    }

    /// Looks at the files again, and says whether there are other charts in them now. A file that is no Rust at the moment says nothing.
    pub(crate) fn changed(&mut self) -> bool {
        // Parsing alone would take memory each time.
        let is_as_before = |(path, text): &(PathBuf, String)| fs::read_to_string(path).is_ok_and(|now| now == *text);
        if self.files.iter().all(is_as_before) {
            return false;
        }
        let Ok(found) = find::charts(&self.options) else { return false };
        self.files = files(&found);
        let meant = found.iter().filter(|chart| self.chosen.as_ref().is_none_or(|name| chart.name == *name));
        let charts: Vec<String> = meant.map(text).filter(|text| Chart::parse(text).is_ok()).collect();
        let is_other = !charts.is_empty() && charts != self.charts;
        if is_other {
            self.charts = charts;
        }
        is_other
    }
}

/// Each file once.
fn files(found: &[Found]) -> Vec<(PathBuf, String)> {
    let mut files: Vec<(PathBuf, String)> = Vec::new();
    for chart in found {
        if files.iter().all(|(path, _)| *path != chart.source.path) {
            files.push((chart.source.path.clone(), chart.source.text.clone()));
        }
    }
    files
}

/// What was written between the braces.
fn text(chart: &Found) -> String {
    let spans: Vec<_> = chart.tokens.clone().into_iter().map(|tree| tree.span().byte_range()).collect();
    let range = spans.first().map_or(0, |first| first.start)..spans.last().map_or(0, |last| last.end);
    chart.source.text.get(range).unwrap_or_default().to_owned()
}
