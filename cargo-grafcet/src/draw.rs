//! `cargo grafcet draw`

use std::path::Path;

use grafcet_compiler::describe::with_description;
use grafcet_compiler::model::Model;

use crate::args::{Draw, Picture};
use crate::find::{self, Found};
use crate::model::drawn;
use crate::{Failure, Outcome, output};

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
