//! From a command line to charts: the files that are meant, and every `grafcet!` in them.
//!
//! - `package`: the crates that are meant, as cargo tells
//! - `modules`: from the first file of a target to all its files

mod modules;
mod package;

use std::fs;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use grafcet_sim::{calls, chart_name};
use proc_macro2::{Span, TokenStream};

use crate::Failure;
use crate::args::Charts;
use crate::report::human;

/// A file of the user.
pub(crate) struct Source {
    /// As it is shown: from the present folder on, where it lies below.
    pub(crate) path: PathBuf,
    pub(crate) text: String,
    /// So many bytes of the file stand in front of the text: a byte order mark.
    pub(crate) skipped: usize,
}

/// A chart in a file.
pub(crate) struct Found {
    pub(crate) source: Rc<Source>,
    /// `Motor`; empty where its header has none.
    pub(crate) name: String,
    /// What stands between the braces of `grafcet! { … }`.
    pub(crate) tokens: TokenStream,
    /// Where that call is: `grafcet`.
    pub(crate) call: Span,
}

/// The charts that are meant, by file and in the order of the source.
///
/// # Errors
/// A file cannot be read or is no Rust, cargo does not tell, or there is no chart, or none of a name.
pub(crate) fn charts(options: &Charts) -> Result<Vec<Found>, Failure> {
    let mut charts = if options.files.is_empty() { of_packages(options)? } else { of_files(&options.files)? };
    if let Some(name) = options.chart.iter().find(|name| charts.iter().all(|chart| chart.name != **name)) {
        return Err(Failure::Said(missing(name, &charts)));
    }
    if !options.chart.is_empty() {
        charts.retain(|chart| options.chart.contains(&chart.name));
    }
    Ok(charts)
}

/// A folder in which files lie that may have charts.
pub(crate) struct Folder {
    pub(crate) path: PathBuf,
    pub(crate) is_recursive: bool,
}

/// Where the files lie that are meant: those that are named, or of a crate all that lie beside the first file of a target or below it; in the crate's
/// own folder, in which all else lies, those beside it alone.
///
/// # Errors
/// Cargo does not tell.
pub(crate) fn folders(options: &Charts) -> Result<Vec<Folder>, Failure> {
    let files = if options.files.is_empty() { package::targets(options)?.files } else { options.files.clone() };
    let mut folders: Vec<Folder> = Vec::new();
    for file in files {
        // A file that is named alone lies here.
        let path = file.parent().filter(|path| !path.as_os_str().is_empty()).unwrap_or(Path::new(".")).to_path_buf();
        let is_recursive = options.files.is_empty() && !path.join("Cargo.toml").is_file();
        if folders.iter().all(|folder| folder.path != path) {
            folders.push(Folder { path, is_recursive });
        }
    }
    Ok(folders)
}

/// The version of the crate in which a file lies, as cargo tells.
#[cfg(feature = "print")]
pub(crate) fn version(file: &Path) -> Option<String> {
    package::version(file)
}

/// The one chart that is meant.
///
/// # Errors
/// As of [`charts`], or there are several.
pub(crate) fn one(options: &Charts) -> Result<Found, Failure> {
    let mut charts = charts(options)?;
    match charts.len() {
        1 => Ok(charts.remove(0)),
        count => Err(Failure::Said(format!("{count} charts, and one is meant: {}", one_of(&charts)))),
    }
}

/// `--chart Motor`, `--chart Valve` or …: how to choose.
pub(crate) fn one_of(charts: &[Found]) -> String {
    const MOST: usize = 8;
    let mut names: Vec<String> = Vec::new();
    for chart in charts {
        let choice = format!("--chart {}", chart.name);
        if !names.contains(&choice) {
            names.push(choice);
        }
    }
    if names.len() == 1 {
        let files: Vec<String> = charts.iter().map(|chart| chart.source.path.display().to_string()).collect();
        return format!("say which file: {}", files.join(" or "));
    }
    let more = if names.len() > MOST { ", …" } else { "" };
    names.truncate(MOST);
    format!("say which one: {}{more}", names.join(", "))
}

fn missing(name: &str, charts: &[Found]) -> String {
    let others: Vec<&str> = charts.iter().map(|chart| chart.name.as_str()).collect();
    let lower = name.to_lowercase();
    if let Some(meant) = others.iter().find(|other| other.to_lowercase() == lower) {
        return format!("there is no chart `{name}`, but `{meant}`");
    }
    format!("there is no chart `{name}`; {}", one_of(charts))
}

fn of_packages(options: &Charts) -> Result<Vec<Found>, Failure> {
    let mut files = modules::Files::default();
    let packages = package::targets(options)?;
    for target in &packages.files {
        files.add_target(target)?;
    }
    let mut charts = Vec::new();
    for file in files.all {
        charts.extend(file.charts());
    }
    if charts.is_empty() {
        return Err(Failure::Said(format!("there is no `grafcet!` in {}", packages.names)));
    }
    Ok(charts)
}

/// The charts of these files, in the order of the source.
///
/// # Errors
/// A file cannot be read or is no Rust, or there is no chart.
pub(crate) fn of_files(files: &[PathBuf]) -> Result<Vec<Found>, Failure> {
    let mut charts = Vec::new();
    for path in files {
        charts.append(&mut File::read(path)?.all());
    }
    if charts.is_empty() {
        let files: Vec<String> = files.iter().map(|path| path.display().to_string()).collect();
        return Err(Failure::Said(format!("there is no `grafcet!` in {}, and no chart", files.join(", "))));
    }
    Ok(charts)
}

/// The charts of a text that is to be the file of this name.
///
/// # Errors
/// It is no Rust.
pub(crate) fn of_text(path: &Path, text: &str) -> Result<Vec<Found>, Failure> {
    Ok(File::of(path, text)?.charts())
}

/// The same of a file as it was, with a chart alone, too.
pub(crate) fn of_version(path: &Path, text: &str) -> Result<Vec<Found>, Failure> {
    let charts = File::of(path, text)?.all();
    if charts.is_empty() {
        return Err(Failure::Said(format!("there is no `grafcet!` in {}, and no chart", path.display())));
    }
    Ok(charts)
}

/// A file as tokens.
struct File {
    source: Rc<Source>,
    tokens: TokenStream,
}

impl File {
    /// Its calls, or the chart that it is itself, as it stands between the braces.
    fn all(self) -> Vec<Found> {
        let mut found = self.charts();
        if let (true, Some(name)) = (found.is_empty(), chart_name(&self.tokens)) {
            found.push(Found { name, tokens: self.tokens, source: self.source, call: Span::call_site() });
        }
        found
    }

    fn read(path: &Path) -> Result<Self, Failure> {
        Self::of(path, &fs::read_to_string(path).map_err(|error| Failure::file(path, &error))?)
    }

    fn of(path: &Path, text: &str) -> Result<Self, Failure> {
        let skipped = text.len() - text.trim_start_matches(MARK).len();
        let source = Rc::new(Source { path: shown(path), text: plain(text), skipped });
        let tokens = source.text.parse().map_err(|error: proc_macro2::LexError| {
            let what = "this is not Rust: it cannot be read beyond this point";
            Failure::Shown(human::at(&source, error.span(), what))
        })?;
        Ok(Self { source, tokens })
    }

    fn charts(&self) -> Vec<Found> {
        let found = calls(&self.tokens).into_iter();
        found
            .map(|(call, tokens)| Found {
                source: Rc::clone(&self.source),
                name: chart_name(&tokens).unwrap_or_default(),
                tokens,
                call,
            })
            .collect()
    }
}

/// A byte order mark.
const MARK: char = '\u{feff}';

/// Without what the lexer does not know: a byte order mark, and a first line for a shell, whose place stays empty so that all others keep theirs.
fn plain(text: &str) -> String {
    let text = text.trim_start_matches(MARK);
    match text.strip_prefix("#!").filter(|rest| !rest.trim_start().starts_with('[')) {
        Some(rest) => {
            let line = rest.find('\n').unwrap_or(rest.len());
            format!("{}{}", " ".repeat(line + 2), &rest[line..])
        }
        None => text.to_owned(),
    }
}

/// From the present folder on, where it lies below.
pub(crate) fn shown(path: &Path) -> PathBuf {
    let here = std::env::current_dir().unwrap_or_default();
    path.strip_prefix(&here).unwrap_or(path).to_path_buf()
}

#[cfg(test)]
mod tests {
    use super::plain;

    #[test]
    fn a_line_for_a_shell_leaves_all_others_where_they_are() {
        assert_eq!(plain("#!/bin/run\nfn"), "          \nfn");
        assert_eq!(plain("#![allow(x)]\n"), "#![allow(x)]\n");
        assert_eq!(plain("\u{feff}fn"), "fn");
    }
}
