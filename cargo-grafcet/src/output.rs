//! Where a result goes: to the output of the program, to a file, or each chart to a file of its own.

use std::fs;
use std::path::{Path, PathBuf};

use std::io::{IsTerminal, Write};

use crate::args::Target;
use crate::find::{self, Found};
use crate::{Failure, Outcome, say};

/// What is written of a chart.
pub(crate) enum Content {
    Text(String),
    /// For no terminal.
    Bytes(Vec<u8>),
}

impl From<String> for Content {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl Content {
    pub(crate) fn bytes(&self) -> &[u8] {
        match self {
            Self::Text(text) => text.as_bytes(),
            Self::Bytes(bytes) => bytes,
        }
    }

    /// To the output of the program.
    fn say(&self) -> Result<(), Failure> {
        match self {
            Self::Text(text) => say(text),
            Self::Bytes(_) if std::io::stdout().is_terminal() => {
                Err(Failure::Said("that is nothing for a terminal: -o FILE says where it goes".to_owned()))
            }
            Self::Bytes(bytes) => std::io::stdout().write_all(bytes).map_err(|error| Failure::output(&error)),
        }
    }
}

/// Writes what `make` makes of each chart; `None` where that has failed and been said. `ending` is that of the files, without the dot.
///
/// # Errors
/// There are several charts and no folder, a file cannot be written, or `make` fails.
pub(crate) fn each<T: Into<Content>>(
    charts: &[Found],
    target: &Target,
    ending: &str,
    mut make: impl FnMut(&Found) -> Result<Option<T>, Failure>,
) -> Result<Outcome, Failure> {
    let Some(folder) = &target.out else {
        let [chart] = charts else {
            let one = find::one_of(charts);
            let message =
                format!("{} charts, and one goes to one output: {one}; or --out FOLDER for all", charts.len());
            return Err(Failure::Said(message));
        };
        let Some(content) = make(chart)? else { return Ok(Outcome::Wrong) };
        let content = content.into();
        match &target.output {
            Some(file) => fs::write(file, content.bytes()).map_err(|error| Failure::file(file, &error))?,
            None => content.say()?,
        }
        return Ok(Outcome::Well);
    };
    fs::create_dir_all(folder).map_err(|error| Failure::file(folder, &error))?;
    let (mut wrong, mut written) = (false, Vec::new());
    for chart in charts {
        let Some(content) = make(chart)? else {
            wrong = true;
            continue;
        };
        let file = free(folder, &chart.name, ending, &written);
        fs::write(&file, content.into().bytes()).map_err(|error| Failure::file(&file, &error))?;
        say(&format!("{}\n", file.display()))?;
        written.push(file);
    }
    Ok(Outcome::wrong_if(wrong))
}

/// `Motor.svg`; of charts with one name the second is `Motor-2.svg`, also where the file system takes capitals for small letters.
fn free(folder: &Path, name: &str, ending: &str, written: &[PathBuf]) -> PathBuf {
    let taken = |file: &Path| {
        let small = file.display().to_string().to_lowercase();
        written.iter().any(|other| other.display().to_string().to_lowercase() == small)
    };
    let mut file = folder.join(format!("{name}.{ending}"));
    let mut number = 2;
    while taken(&file) {
        file = folder.join(format!("{name}-{number}.{ending}"));
        number += 1;
    }
    file
}
