//! What keys mean, and what a person has chosen on the screen beside the session itself.

use grafcet_sim::{Error, Kind, Signal, script_of};
use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use super::session::Session;

/// How far a key scrolls the drawing.
const SCROLL: i32 = 5;

#[derive(Default)]
pub(crate) struct Screen {
    /// By signal the key that stands for it.
    pub(crate) keys: Vec<Option<char>>,
    pub(crate) selected: usize,
    /// What is being typed as the value of the selected signal.
    pub(crate) typing: Option<String>,
    /// The steps that are being typed for a cycle by hand.
    pub(crate) forcing: Option<String>,
    pub(crate) running: bool,
    /// Columns and rows that the drawing is moved, beside what keeps its active steps in view.
    pub(crate) scroll: (i32, i32),
    /// What is to be said until the next key.
    pub(crate) message: Option<String>,
}

/// What the loop around has to do.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Next {
    Go,
    Save,
    End,
}

impl Screen {
    pub(crate) fn of(session: &Session<'_>) -> Self {
        Self { keys: keys(session.shown()), ..Self::default() }
    }

    pub(crate) fn press(&mut self, key: KeyEvent, session: &mut Session<'_>) -> Next {
        self.message = None;
        match (key.code, key.modifiers.contains(KeyModifiers::CONTROL)) {
            (KeyCode::Char('c'), true) => return Next::End,
            (KeyCode::Char('s'), true) => return Next::Save,
            (KeyCode::Char('r'), true) => {
                (self.typing, self.forcing) = (None, None);
                let done = session.init().map(drop);
                self.ran(done);
                return Next::Go;
            }
            (KeyCode::Char('f'), true) => {
                (self.running, self.typing, self.forcing) = (false, None, Some(String::new()));
                return Next::Go;
            }
            _ => {}
        }
        if self.forcing.is_some() {
            self.forced(key.code, session);
            return Next::Go;
        }
        if self.typing.is_some() {
            self.typed(key.code, session);
            return Next::Go;
        }
        match key.code {
            KeyCode::Esc => return Next::End,
            KeyCode::Enter => self.cycle(session),
            KeyCode::Char(' ') => self.running = !self.running,
            KeyCode::Backspace => {
                self.running = false;
                if !session.back() {
                    self.message = Some("there is no earlier cycle".to_owned());
                }
            }
            KeyCode::Char('+') => session.step_by(true),
            KeyCode::Char('-') => session.step_by(false),
            KeyCode::Up => self.selected = self.selected.saturating_sub(1),
            KeyCode::Down => self.selected = (self.selected + 1).min(session.shown().len().saturating_sub(1)),
            KeyCode::Left => self.scroll.0 -= SCROLL,
            KeyCode::Right => self.scroll.0 += SCROLL,
            KeyCode::PageUp => self.scroll.1 -= SCROLL,
            KeyCode::PageDown => self.scroll.1 += SCROLL,
            KeyCode::Tab if self.selected < session.shown().len() => self.change(self.selected, session),
            KeyCode::Char(c) => match self.keys.iter().position(|key| *key == Some(c)) {
                Some(signal) => self.change(signal, session),
                None => self.message = Some(format!("no input has the key {c}")),
            },
            _ => {}
        }
        Next::Go
    }

    /// One cycle; where the chart fails, nothing runs any more.
    pub(crate) fn cycle(&mut self, session: &mut Session<'_>) {
        let done = session.cycle().map(drop);
        self.ran(done);
    }

    fn ran(&mut self, done: Result<(), Error>) {
        if let Err(error) = done {
            self.running = false;
            self.message = Some(format!("this cycle cannot be run: {error}"));
        }
    }

    fn change(&mut self, signal: usize, session: &mut Session<'_>) {
        self.selected = signal;
        if !session.toggle(signal) {
            self.typing = Some(String::new());
        }
    }

    /// The names of the steps, with commas between them.
    fn forced(&mut self, key: KeyCode, session: &mut Session<'_>) {
        let Some(text) = &mut self.forcing else { return };
        match key {
            KeyCode::Char(c) => text.push(c),
            KeyCode::Backspace => _ = text.pop(),
            KeyCode::Esc => self.forcing = None,
            KeyCode::Enter => {
                let steps = text.split([',', ' ']).filter(|step| !step.is_empty()).map(str::to_owned).collect();
                self.message = session.force(steps).err().map(|why| format!("no cycle by hand: {why}"));
                self.forcing = None;
            }
            _ => {}
        }
    }

    fn typed(&mut self, key: KeyCode, session: &mut Session<'_>) {
        let Some(text) = &mut self.typing else { return };
        match key {
            KeyCode::Char(c) => text.push(c),
            KeyCode::Backspace => _ = text.pop(),
            KeyCode::Esc => self.typing = None,
            KeyCode::Enter => {
                let signal = &session.shown()[self.selected];
                let read = script_of(std::slice::from_ref(signal), &format!("`{}`={}", signal.name, text.trim()));
                match read.ok().and_then(|mut cycles| cycles.pop()?.1.pop()) {
                    Some(value) => session.set(self.selected, value),
                    None => self.message = Some(format!("`{}` cannot be `{text}`: it is {}", signal.name, is(signal))),
                }
                self.typing = None;
            }
            _ => {}
        }
    }
}

/// What values a signal takes, in words.
fn is(signal: &Signal) -> String {
    match &signal.kind {
        Kind::Bool => "true or false".to_owned(),
        Kind::Int { .. } => "a whole number".to_owned(),
        Kind::Float(_) => "a number".to_owned(),
        Kind::Time => "a count of ticks".to_owned(),
        Kind::Listed(_, list) => format!("one of {}", list.join(", ")),
        Kind::Other(ty) => format!("a variant of `{ty}`"),
    }
}

/// A key for each signal: the first letter of its name that no signal before it has, else any letter or digit.
fn keys(signals: &[Signal]) -> Vec<Option<char>> {
    let mut keys = vec![None; signals.len()];
    let mut taken = Vec::new();
    for (key, signal) in keys.iter_mut().zip(signals) {
        *key = free(&taken, signal.name.chars().map(|c| c.to_ascii_lowercase()));
        taken.extend(*key);
    }
    for key in keys.iter_mut().filter(|key| key.is_none()) {
        *key = free(&taken, ('a'..='z').chain('A'..='Z').chain('0'..='9'));
        taken.extend(*key);
    }
    keys
}

fn free(taken: &[char], mut letters: impl Iterator<Item = char>) -> Option<char> {
    letters.find(|key| key.is_ascii_alphanumeric() && !taken.contains(key))
}
