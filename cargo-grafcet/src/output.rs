//! Where a result goes: to the output of the program, to a file, or each chart to a file of its own.

use std::fs;
use std::path::{Path, PathBuf};

use crate::args::Target;
use crate::find::{self, Found};
use crate::{Failure, Outcome, say};

/// Writes what `make` makes of each chart; `None` where that has failed and been said. `ending` is that of the files, without the dot.
///
/// # Errors
/// There are several charts and no folder, a file cannot be written, or `make` fails.
pub(crate) fn each(
    charts: &[Found],
    target: &Target,
    ending: &str,
    mut make: impl FnMut(&Found) -> Result<Option<String>, Failure>,
) -> Result<Outcome, Failure> {
    let Some(folder) = &target.out else {
        let [chart] = charts else {
            let one = find::one_of(charts);
            let message =
                format!("{} charts, and one goes to one output: {one}; or --out FOLDER for all", charts.len());
            return Err(Failure::Said(message));
        };
        let Some(text) = make(chart)? else { return Ok(Outcome::Wrong) };
        match &target.output {
            Some(file) => fs::write(file, text).map_err(|error| Failure::file(file, &error))?,
            None => say(&text)?,
        }
        return Ok(Outcome::Well);
    };
    fs::create_dir_all(folder).map_err(|error| Failure::file(folder, &error))?;
    let (mut wrong, mut written) = (false, Vec::new());
    for chart in charts {
        let Some(text) = make(chart)? else {
            wrong = true;
            continue;
        };
        let file = free(folder, &chart.name, ending, &written);
        fs::write(&file, text).map_err(|error| Failure::file(&file, &error))?;
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
