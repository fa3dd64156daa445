//! The loop around a session: keys in, screens out.

use std::fs;
use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};
use std::time::Duration;

use ratatui::DefaultTerminal;
use ratatui::crossterm::event::{self, Event, KeyEventKind};

use super::frame;
use super::screen::{Next, Screen};
use super::script;
use super::session::Session;
use crate::Failure;

/// How long a cycle is looked at while the chart runs: its time step, within these bounds, so that nothing is too fast to be seen or seems to stand.
const PACE: (Duration, Duration) = (Duration::from_millis(50), Duration::from_secs(1));

/// Lets a person play until the end is wanted. `save` is the file for the script; none is one of the chart's name, which must be new.
///
/// # Errors
/// There is no terminal, or it breaks.
pub(crate) fn play(session: &mut Session<'_>, save: Option<&Path>) -> Result<(), Failure> {
    if !io::stdin().is_terminal() || !io::stdout().is_terminal() {
        let what = "there is no terminal to play in; --script FILE runs cycles without one";
        return Err(Failure::Said(what.to_owned()));
    }
    let failed = |error: io::Error| Failure::Said(format!("the terminal fails: {error}"));
    let mut terminal = ratatui::try_init().map_err(failed)?;
    let done = looped(&mut terminal, session, save);
    ratatui::restore();
    done.map_err(failed)
}

fn looped(terminal: &mut DefaultTerminal, session: &mut Session<'_>, save: Option<&Path>) -> io::Result<()> {
    let mut screen = Screen::of(session);
    let mut saved = save.map(Path::to_path_buf);
    loop {
        terminal.draw(|frame| frame::draw(frame, session, &screen))?;
        if screen.running && !event::poll(pace(session))? {
            screen.cycle(session);
            continue;
        }
        let Event::Key(key) = event::read()? else { continue };
        if key.kind == KeyEventKind::Release {
            continue;
        }
        match screen.press(key, session) {
            Next::Go => {}
            Next::Save => screen.message = Some(write(session, &mut saved)),
            Next::End => return Ok(()),
        }
    }
}

fn pace(session: &Session<'_>) -> Duration {
    let nanos = u64::from(session.step()).saturating_mul(session.names().nanos_per_tick);
    Duration::from_nanos(nanos).clamp(PACE.0, PACE.1)
}

/// Writes the script, and says so or why not.
fn write(session: &Session<'_>, saved: &mut Option<PathBuf>) -> String {
    let file =
        saved.clone().unwrap_or_else(|| PathBuf::from(format!("{}.script", session.names().chart.to_lowercase())));
    if saved.is_none() && file.exists() {
        return format!("{} is there already: begin with --save FILE", file.display());
    }
    match fs::write(&file, text(session)) {
        Ok(()) => {
            let said = format!("{} cycles in {}", session.script().len(), file.display());
            *saved = Some(file);
            said
        }
        Err(error) => format!("{}: {error}", file.display()),
    }
}

/// All cycles so far as a script.
pub(crate) fn text(session: &Session<'_>) -> String {
    script::text(session.signals(), &session.names().params, session.script())
}
