//! `cargo grafcet draw`

use std::path::Path;

use clap::{Args as Arguments, ValueEnum};
use grafcet_compiler::describe::with_description;
use grafcet_compiler::model::Model;

use crate::args::{Charts, Target};
use crate::find::{self, Found};
use crate::model::drawn;
use crate::{Failure, Outcome, output};

/// Draw charts: SVG, text for a terminal, Mermaid
///
/// The notation is that of IEC 60848. One chart goes to the output of the program or to a file, several to files in a folder.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet draw --chart Motor              in the terminal
  cargo grafcet draw --chart Motor -o motor.svg
  cargo grafcet draw --out drawings             all charts of the crate as drawings/NAME.svg")]
pub(crate) struct Draw {
    #[command(flatten)]
    pub(crate) charts: Charts,
    /// What kind of drawing; else by the end of the file's name, SVG in a folder, and text
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub(crate) format: Option<Picture>,
    #[command(flatten)]
    pub(crate) target: Target,
    /// Mark these steps as active
    #[arg(long, value_name = "STEP,…", value_delimiter = ',')]
    pub(crate) active: Vec<String>,
    /// The widest text: what stands side by side stands one below the other where there is no room
    #[arg(long, value_name = "COLUMNS")]
    pub(crate) width: Option<u16>,
}

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Picture {
    Svg,
    Text,
    Mermaid,
}

pub(crate) fn run(options: &Draw) -> Result<Outcome, Failure> {
    let charts = find::charts(&options.charts)?;
    let in_folder = options.target.out.as_ref().map(|_| Picture::Svg);
    let kind = options.format.or(in_folder).unwrap_or_else(|| kind_of(options.target.output.as_deref()));
    let ending = match kind {
        Picture::Svg => "svg",
        Picture::Text => "txt",
        Picture::Mermaid => "mmd",
    };
    output::each(&charts, &options.target, ending, |chart| picture(chart, kind, options))
}

/// By the end of the file's name.
fn kind_of(file: Option<&Path>) -> Picture {
    match file.and_then(Path::extension).and_then(|end| end.to_str()) {
        Some("svg") => Picture::Svg,
        Some("mmd" | "mermaid") => Picture::Mermaid,
        _ => Picture::Text,
    }
}

/// None where the chart has mistakes that leave nothing to draw, which have been shown.
fn picture(chart: &Found, kind: Picture, options: &Draw) -> Result<Option<String>, Failure> {
    let Some(model) = drawn(chart) else { return Ok(None) };
    let active = Active::of(&model, &options.active, chart)?;
    Ok(Some(with_description(&model, |description| match kind {
        Picture::Svg => grafcet_draw::svg(description, &active),
        Picture::Mermaid => grafcet_draw::mermaid(description),
        Picture::Text => match options.width {
            Some(columns) => grafcet_draw::text_within(description, &active, columns),
            None => grafcet_draw::text(description, &active),
        },
    })))
}

/// The steps that are marked, by number.
struct Active(Vec<usize>);

impl Active {
    fn of(model: &Model, names: &[String], chart: &Found) -> Result<Self, Failure> {
        let number = |name: &String| {
            let steps = model.steps.values();
            let number = steps.map(|step| step.name.to_string()).position(|step| step.trim_start_matches("r#") == name);
            number.ok_or_else(|| Failure::Said(format!("the chart {} has no step `{name}`", chart.name)))
        };
        Ok(Self(names.iter().map(number).collect::<Result<_, _>>()?))
    }
}

impl grafcet_core::ActiveSteps for Active {
    fn is_active_at(&self, step: usize) -> bool {
        self.0.contains(&step)
    }
}
