//! Drawings on paper and as pixels: what `draw` writes as PDF and PNG.
//!
//! - `paper`: sizes, the frame of a page and its title block
//! - `letters`: from SVG to a drawing whose texts look the same on every machine
//! - `pdf`, `png`: what is written

mod letters;
mod paper;
mod pdf;
mod png;
#[cfg(test)]
mod tests;

use std::time::{SystemTime, UNIX_EPOCH};

use grafcet_compiler::describe::with_description;
use grafcet_compiler::model::Model;
use grafcet_core::ActiveSteps;

use crate::draw::OnPaper;
use crate::find::{self, Found};
use crate::{Failure, complain};
use letters::Letters;
use paper::{Block, Sheet};

/// A chart on pages with a title block.
pub(crate) fn pdf(
    chart: &Found,
    model: &Model,
    active: &impl ActiveSteps,
    options: &OnPaper,
) -> Result<Vec<u8>, Failure> {
    let block = Block {
        kind: match model.dialect {
            grafcet_compiler::model::Dialect::Sfc => "SFC (IEC 61131-3)",
            grafcet_compiler::model::Dialect::Grafcet => "GRAFCET (IEC 60848)",
        },
        name: chart.name.clone(),
        source: chart.source.path.display().to_string(),
        version: options.revision.clone().or_else(|| find::version(&chart.source.path)).unwrap_or_default(),
        date: options.date.clone().unwrap_or_else(today),
    };
    let mut letters = Letters::new();
    let written = with_description(model, |description| {
        let sheet = Sheet::of(options, |room| grafcet_draw::pages::pages(description, active, room));
        pdf::write(&sheet, &block, &mut letters)
    });
    missing(&chart.name, &letters);
    written.map_err(|error| Failure::Said(format!("{}: {error}", chart.name)))
}

/// The whole chart as pixels.
pub(crate) fn png(chart: &Found, model: &Model, active: &impl ActiveSteps, dots: u16) -> Result<Vec<u8>, Failure> {
    png_of(&chart.name, &with_description(model, |description| grafcet_draw::svg(description, active)), dots)
}

/// A picture of a chart of this name.
pub(crate) fn png_of(chart: &str, svg: &str, dots: u16) -> Result<Vec<u8>, Failure> {
    let mut letters = Letters::new();
    let written = png::write(svg, dots, &mut letters);
    missing(chart, &letters);
    written.map_err(|error| Failure::Said(format!("{chart}: {error}")))
}

fn missing(chart: &str, letters: &Letters) {
    if !letters.missing.is_empty() {
        let signs: String = letters.missing.iter().collect();
        complain(&format!("note: {chart}: the letters of prints have no sign for `{signs}`: a box stands for each"));
    }
}

/// `2026-11-24`, of Universal Time; where `SOURCE_DATE_EPOCH` says when it is, that day, so that one source makes one file.
fn today() -> String {
    let told = std::env::var("SOURCE_DATE_EPOCH").ok().and_then(|seconds| seconds.parse().ok());
    let now = || SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
    date(told.unwrap_or_else(now) / 86_400)
}

/// The day so many days after the 1st of January 1970 (the Gregorian calendar begins anew every 400 years, counted from March on).
fn date(days: u64) -> String {
    // From the 1st of March of the year 0.
    let days = days + 719_468;
    let (era, day) = (days / 146_097, days % 146_097);
    let year = (day - day / 1_460 + day / 36_524 - day / 146_096) / 365;
    let of_year = day - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let day = of_year - (153 * month + 2) / 5 + 1;
    let (year, month) = if month < 10 { (year, month + 3) } else { (year + 1, month - 9) };
    format!("{:04}-{month:02}-{day:02}", era * 400 + year)
}
