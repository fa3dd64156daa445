//! How far a proof is, for somebody who waits at a terminal.

use std::cell::RefCell;
use std::io::{IsTerminal, stderr};
use std::time::{Duration, Instant};

use grafcet_prove::At;
use ratatui::crossterm::cursor::MoveToColumn;
use ratatui::crossterm::execute;
use ratatui::crossterm::style::Print;
use ratatui::crossterm::terminal::{self, Clear, ClearType};

/// Nobody waits for what is over sooner.
const SOON: Duration = Duration::from_millis(300);

/// From one line to the next.
const PACE: Duration = Duration::from_millis(100);

/// The columns of a terminal that does not say how wide it is.
const COLUMNS: u16 = 80;

/// A line beside the output, which is written again and again, and taken away in the end; without colours, but what moves on a terminal it needs in any case.
pub(crate) struct Progress {
    /// The chart and its property.
    about: String,
    start: Instant,
    line: RefCell<Line>,
}

struct Line {
    stage: String,
    last: Option<Instant>,
}

impl Progress {
    /// None where there is no terminal.
    pub(crate) fn new(about: String) -> Option<Self> {
        let line = RefCell::new(Line { stage: String::new(), last: None });
        stderr().is_terminal().then(|| Self { about, start: Instant::now(), line })
    }

    /// The search is there, or goes on.
    pub(crate) fn at(&self, at: Option<At>) {
        if let Some(at) = at {
            self.line.borrow_mut().stage = stage(at);
        }
        self.show();
    }

    /// A command is waited for.
    pub(crate) fn waits_for(&self, command: &str) {
        command.clone_into(&mut self.line.borrow_mut().stage);
        self.show();
    }

    fn show(&self) {
        let (mut line, elapsed) = (self.line.borrow_mut(), self.start.elapsed());
        if elapsed < SOON || line.last.is_some_and(|last| last.elapsed() < PACE) {
            return;
        }
        line.last = Some(Instant::now());
        let columns = terminal::size().map_or(COLUMNS, |(columns, _)| columns);
        let text = text(&line.stage, elapsed, &self.about, usize::from(columns));
        // Where nobody reads, nothing can be said.
        _ = execute!(stderr(), MoveToColumn(0), Print(text), Clear(ClearType::UntilNewLine));
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if self.line.borrow().last.is_some() {
            _ = execute!(stderr(), MoveToColumn(0), Clear(ClearType::UntilNewLine));
        }
    }
}

fn stage(at: At) -> String {
    match at {
        At::Cycle(cycle) => format!("bounded search, cycle {cycle}"),
        At::Frame(frame) => format!("IC3, frame {frame}"),
        At::Lemmas => "how clocks go together".to_owned(),
        At::Ways(ways) => format!("ways home, {ways} so far"),
    }
}

/// One line: what a terminal has no room for would begin another one, which nothing takes away. The last column stays free, too.
fn text(stage: &str, elapsed: Duration, about: &str, columns: usize) -> String {
    let whole = format!("{stage}, {} s: {about}", elapsed.as_secs());
    if whole.chars().count() < columns {
        return whole;
    }
    let room = columns.saturating_sub(2);
    whole.chars().take(room).chain(['…']).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_says_how_far_it_is() {
        let line = |at, columns| text(&stage(at), Duration::from_millis(12_900), "Motor: never relay && red", columns);
        assert_eq!(line(At::Frame(7), 80), "IC3, frame 7, 12 s: Motor: never relay && red");
        assert_eq!(line(At::Cycle(3), 80), "bounded search, cycle 3, 12 s: Motor: never relay && red");
        assert_eq!(line(At::Ways(40), 30), "ways home, 40 so far, 12 s: …");
        assert_eq!(line(At::Lemmas, 30).chars().count(), 29);
        assert_eq!(line(At::Lemmas, 80), "how clocks go together, 12 s: Motor: never relay && red");
        assert_eq!(line(At::Frame(7), 1), "…");
    }
}
