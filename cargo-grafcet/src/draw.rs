//! `cargo grafcet draw`

use std::path::Path;

use clap::{Args as Arguments, ValueEnum};
use grafcet_compiler::describe::with_description;
use grafcet_compiler::model::Model;

use crate::args::{Charts, Target};
use crate::find::{self, Found};
use crate::model::drawn;
use crate::output::Content;
#[cfg(feature = "print")]
use crate::print;
use crate::{Failure, Outcome, output};

/// Draw charts: SVG, text for a terminal, Mermaid, PNG, PDF
///
/// The notation is that of IEC 60848. One chart goes to the output of the program or to a file, several to files in a folder. A PDF has pages with a title block: name,
/// version, date, page. What is larger than a page goes on at a connector of the same number, which says on which page.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet draw --chart Motor              in the terminal
  cargo grafcet draw --chart Motor -o motor.svg
  cargo grafcet draw --chart Motor -o motor.pdf --paper a3 --revision B
  cargo grafcet draw --out drawings             all charts of the crate as drawings/NAME.svg

Exit code 1 says that a chart has mistakes that leave nothing to draw.")]
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
    /// The dots an inch of a PNG; at 96 a drawing is as large as on a screen
    #[arg(long, value_name = "DOTS", default_value_t = 192, value_parser = clap::value_parser!(u16).range(24..=1200))]
    pub(crate) dpi: u16,
    #[command(flatten)]
    pub(crate) on_paper: OnPaper,
}

/// What a PDF needs.
#[derive(Arguments, Debug)]
pub(crate) struct OnPaper {
    /// The size of the pages of a PDF
    #[arg(long, value_enum, default_value_t, value_name = "SIZE")]
    pub(crate) paper: Paper,
    /// Upright pages; else what needs fewer pages
    #[arg(long, conflicts_with = "landscape")]
    pub(crate) portrait: bool,
    /// Pages that lie across
    #[arg(long)]
    pub(crate) landscape: bool,
    /// The version in the title block; else that of the crate
    #[arg(long, value_name = "TEXT")]
    pub(crate) revision: Option<String>,
    /// The date in the title block; else today's
    #[arg(long, value_name = "TEXT")]
    pub(crate) date: Option<String>,
}

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(crate) enum Paper {
    A5,
    #[default]
    A4,
    A3,
    A2,
    A1,
    A0,
    Letter,
    Legal,
    Tabloid,
}

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Picture {
    Svg,
    Text,
    Mermaid,
    Png,
    Pdf,
}

pub(crate) fn run(options: &Draw) -> Result<Outcome, Failure> {
    let charts = find::charts(&options.charts)?;
    let in_folder = options.target.out.as_ref().map(|_| Picture::Svg);
    let kind = options.format.or(in_folder).unwrap_or_else(|| kind_of(options.target.output.as_deref()));
    let ending = match kind {
        Picture::Svg => "svg",
        Picture::Text => "txt",
        Picture::Mermaid => "mmd",
        Picture::Png => "png",
        Picture::Pdf => "pdf",
    };
    output::each(&charts, &options.target, ending, |chart| picture(chart, kind, options))
}

/// By the end of the file's name.
fn kind_of(file: Option<&Path>) -> Picture {
    match file.and_then(Path::extension).and_then(|end| end.to_str()) {
        Some("svg") => Picture::Svg,
        Some("mmd" | "mermaid") => Picture::Mermaid,
        Some("png") => Picture::Png,
        Some("pdf") => Picture::Pdf,
        _ => Picture::Text,
    }
}

/// None where the chart has mistakes that leave nothing to draw, which have been shown.
fn picture(chart: &Found, kind: Picture, options: &Draw) -> Result<Option<Content>, Failure> {
    let Some(model) = drawn(chart) else { return Ok(None) };
    let active = Active::of(&model, &options.active, chart)?;
    if let Picture::Png | Picture::Pdf = kind {
        return Ok(Some(Content::Bytes(printed(chart, &model, &active, kind, options)?)));
    }
    Ok(Some(Content::Text(with_description(&model, |description| match kind {
        Picture::Svg | Picture::Png | Picture::Pdf => grafcet_draw::svg(description, &active),
        Picture::Mermaid => grafcet_draw::mermaid(description),
        Picture::Text => match options.width {
            Some(columns) => grafcet_draw::text_within(description, &active, columns),
            None => grafcet_draw::text(description, &active),
        },
    }))))
}

#[cfg(feature = "print")]
fn printed(chart: &Found, model: &Model, active: &Active, kind: Picture, options: &Draw) -> Result<Vec<u8>, Failure> {
    match kind {
        Picture::Pdf => print::pdf(chart, model, active, &options.on_paper),
        _ => print::png(chart, model, active, options.dpi),
    }
}

#[cfg(not(feature = "print"))]
fn printed(_: &Found, _: &Model, _: &Active, _: Picture, _: &Draw) -> Result<Vec<u8>, Failure> {
    Err(Failure::Said(
        "this `cargo grafcet` was built without its feature `print`: it writes no PNG and no PDF".to_owned(),
    ))
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
