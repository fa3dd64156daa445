//! What rustdoc shows of the example charts, in its light and its dark theme, and the page of a replay, for people who look at them. Nothing compares
//! them: fonts and the version of the browser move their pixels.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

use crate::command::{Result, capture, capture_within, run as run_command};
use crate::firmware::{EXAMPLES, EXAMPLES_CRATE};
use crate::page::find_browser;
use crate::project::{self, cargo, remove, root};

/// Where they are kept.
const FOLDER: &str = "tests/screenshots";

/// The themes, with what the browser calls the scheme of colours that its user prefers.
const THEMES: [(&str, u8); 2] = [("light", 1), ("dark", 0)];

/// A part of a page, in pixels: as narrow as one without the list at its side.
const WINDOW: &str = "--window-size=690,900";

/// A browser that has not written the picture by then hangs.
const LIMIT: Duration = Duration::from_secs(60);

/// Makes all of them.
///
/// # Errors
/// Chromium is missing, rustdoc or the replay fails, or a page shows no chart.
pub(crate) fn run() -> Result {
    let browser = find_browser()?;
    let target = project::target("screenshots");
    // Rustdoc would not see that a chart has changed: they stand outside of the crate's folder.
    remove(&target)?;
    // One crate has all of the charts.
    let doc = ["doc", "--quiet", "--no-deps", "--lib", "--manifest-path", EXAMPLES_CRATE, "--target-dir"];
    run_command(cargo(&doc).arg(&target))?;
    for example in EXAMPLES {
        for (chart, page) in pages(&target.join("doc/grafcet_firmware").join(example))? {
            pictures(&browser, &chart, &page.display().to_string(), WINDOW)?;
        }
    }
    replay(&browser, &target)
}

/// The page of a replay, at the evolution in which the emergency stop of the cell is pressed.
fn replay(browser: &Path, target: &Path) -> Result {
    let page = target.join("cell");
    let run = ["run", "--quiet", "--package", "grafcet-sim", "--example", "replay", "--"];
    let script = ["examples/charts/cell.rs", "Cell", "examples/charts/cell.script"];
    capture(cargo(&run).args(script).arg(&page).stdout(Stdio::piped()))?;
    pictures(browser, "Replay", &format!("{}.html#14.1", page.display()), "--window-size=1400,900")
}

/// One picture in each theme.
fn pictures(browser: &Path, name: &str, page: &str, window: &str) -> Result {
    for (theme, scheme) in THEMES {
        let picture = root().join(FOLDER).join(format!("{name}-{theme}.png"));
        let mut command = Command::new(browser);
        // Its sandbox does not work for root; the page is our own.
        command.args(["--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", window]);
        command.arg(format!("--blink-settings=preferredColorScheme={scheme}"));
        command.arg(format!("--screenshot={}", picture.display())).arg(format!("file://{page}"));
        capture_within(&mut command, LIMIT)?;
    }
    println!("screenshots: {name}");
    Ok(())
}

/// The charts of a module, each with its page: those with a picture.
fn pages(module: &Path) -> Result<BTreeMap<String, PathBuf>> {
    let entries = fs::read_dir(module).map_err(|error| format!("{}: {error}", module.display()))?;
    let shows = |page: &PathBuf| fs::read_to_string(page).is_ok_and(|html| html.contains("aria-label=\"Chart "));
    let pages = entries.flatten().map(|entry| entry.path()).filter(shows);
    let named = pages.filter_map(|page| {
        let name = page.file_name()?.to_str()?.strip_prefix("struct.")?.strip_suffix(".html")?;
        Some((name.to_owned(), page))
    });
    let named: BTreeMap<_, _> = named.collect();
    if named.is_empty() { Err(format!("{}: no page shows a chart", module.display())) } else { Ok(named) }
}
