//! `cargo grafcet draw`

use std::fs;
use std::path::{Path, PathBuf};

use grafcet_compiler::describe::with_description;
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::Model;
use grafcet_compiler::plant;

use crate::args::{Draw, Picture};
use crate::find::{self, Found};
use crate::report::{Message, human};
use crate::{Failure, Outcome, check, complain, say};

pub(crate) fn run(options: &Draw) -> Result<Outcome, Failure> {
    let charts = find::charts(&options.charts)?;
    let Some(folder) = &options.out else {
        let [chart] = &charts[..] else {
            let one = find::one_of(&charts);
            return Err(Failure::Said(format!(
                "{} charts, and one goes to one output: {one}; or --out FOLDER for all",
                charts.len()
            )));
        };
        let kind = options.format.unwrap_or_else(|| kind_of(options.output.as_deref()));
        let Some(picture) = picture(chart, kind, options)? else { return Ok(Outcome::Wrong) };
        match &options.output {
            Some(file) => fs::write(file, picture).map_err(|error| Failure::file(file, &error))?,
            None => say(&picture)?,
        }
        return Ok(Outcome::Well);
    };
    let kind = options.format.unwrap_or(Picture::Svg);
    fs::create_dir_all(folder).map_err(|error| Failure::file(folder, &error))?;
    let (mut wrong, mut written) = (false, Vec::new());
    for chart in &charts {
        match picture(chart, kind, options)? {
            Some(picture) => {
                let file = free(folder, &chart.name, kind, &written);
                fs::write(&file, picture).map_err(|error| Failure::file(&file, &error))?;
                say(&format!("{}\n", file.display()))?;
                written.push(file);
            }
            None => wrong = true,
        }
    }
    Ok(Outcome::wrong_if(wrong))
}

/// By the end of the file's name.
fn kind_of(file: Option<&Path>) -> Picture {
    match file.and_then(Path::extension).and_then(|end| end.to_str()) {
        Some("svg") => Picture::Svg,
        Some("mmd" | "mermaid") => Picture::Mermaid,
        _ => Picture::Text,
    }
}

/// `Motor.svg`; of charts with one name the second is `Motor-2.svg`, also where the file system takes capitals for small letters.
fn free(folder: &Path, name: &str, kind: Picture, written: &[PathBuf]) -> PathBuf {
    let end = match kind {
        Picture::Svg => "svg",
        Picture::Text => "txt",
        Picture::Mermaid => "mmd",
    };
    let taken = |file: &Path| {
        let small = file.display().to_string().to_lowercase();
        written.iter().any(|other| other.display().to_string().to_lowercase() == small)
    };
    let mut file = folder.join(format!("{name}.{end}"));
    let mut number = 2;
    while taken(&file) {
        file = folder.join(format!("{name}-{number}.{end}"));
        number += 1;
    }
    file
}

/// None where the chart has mistakes that leave nothing to draw, which have been shown.
fn picture(chart: &Found, kind: Picture, options: &Draw) -> Result<Option<String>, Failure> {
    let mut sink = Sink::new();
    let model = plant::model(chart.tokens.clone(), &mut sink);
    let said = sink.finish();
    let whole = model.filter(|model| !model.incomplete && said.iter().all(|one| one.rule.is_some()));
    let Some(model) = whole else {
        for message in check::messages_of(chart, None).iter().filter(|message| Message::is_error(message)) {
            complain(&human::shown(message));
        }
        return Ok(None);
    };
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
