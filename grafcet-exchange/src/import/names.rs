//! Names that Rust takes: small letters for values, capitals at the beginning of words for steps and charts.

use std::collections::{BTreeMap, BTreeSet};

/// Keywords of Rust, and what a chart reserves.
const TAKEN: &str = "as async await break const continue crate dyn else enum extern false final fn for gen if impl in let loop match mod move mut pub ref \
    return self Self static struct super trait true type unsafe use where while abstract become box do macro override priv try typeof unsized \
    virtual yield bool time u8 u16 u32 u64 i8 i16 i32 i64 f32 f64 usize isize \
    N S R L D P P1 P0 SD DS SL INIT rising falling any _";

#[derive(Default)]
pub(super) struct Names {
    taken: BTreeSet<String>,
    /// By the name in the file, in small letters, which it does not tell apart.
    given: BTreeMap<String, String>,
    /// The same of steps, which in some tools may be called as a variable is.
    steps: BTreeMap<String, String>,
    /// And of actions that are stubs.
    actions: BTreeMap<String, String>,
    /// In the order in which they were given.
    pub(super) renamed: Vec<(String, String)>,
}

impl Names {
    pub(super) fn new() -> Self {
        Self { taken: TAKEN.split_whitespace().map(str::to_owned).collect(), ..Self::default() }
    }

    /// Of an input, an output, a variable, an action or a function.
    pub(super) fn value(&mut self, name: &str) -> String {
        let given = self.give(name, &snake(name), "_");
        self.given.insert(name.to_lowercase(), given.clone());
        given
    }

    /// Of an action, always the same.
    pub(super) fn action(&mut self, name: &str) -> String {
        if let Some(given) = self.actions.get(&name.to_lowercase()) {
            return given.clone();
        }
        let given = self.give(name, &snake(name), "_");
        self.actions.insert(name.to_lowercase(), given.clone());
        given
    }

    pub(super) fn step(&mut self, name: &str) -> String {
        let given = self.give(name, &camel(name), "Step");
        self.steps.insert(name.to_lowercase(), given.clone());
        given
    }

    fn give(&mut self, name: &str, wanted: &str, ending: &str) -> String {
        let wanted = if TAKEN.split_whitespace().any(|word| word == wanted) {
            format!("{wanted}{ending}")
        } else {
            wanted.to_owned()
        };
        let mut given = wanted.clone();
        let mut number = 2;
        while !self.taken.insert(given.clone()) {
            given = if ending == "_" { format!("{wanted}_{number}") } else { format!("{wanted}{number}") };
            number += 1;
        }
        if given != name {
            self.renamed.push((name.to_owned(), given.clone()));
        }
        given
    }

    pub(super) fn get_step(&self, name: &str) -> Option<&str> {
        self.steps.get(&name.to_lowercase()).map(String::as_str)
    }

    /// The name that it has here; that of a step is another one.
    pub(super) fn get(&self, name: &str) -> Option<&str> {
        self.given.get(&name.to_lowercase()).map(String::as_str)
    }
}

/// `SWITCH_BUTTON` and `SwitchButton` as `switch_button`.
fn snake(name: &str) -> String {
    named(&words(name).join("_"), 'x')
}

/// `TRAFFIC_LIGHT` and `trafficLight` as `TrafficLight`; what is written so stays as it is.
pub(super) fn camel(name: &str) -> String {
    let kept = name.starts_with(|first: char| first.is_ascii_uppercase())
        && name.chars().all(|letter| letter.is_ascii_alphanumeric())
        && (name.chars().any(|letter| letter.is_ascii_lowercase()) || name.len() < 3);
    if kept {
        return name.to_owned();
    }
    let capital = |word: &String| {
        let mut letters = word.chars();
        letters.next().map(|first| first.to_ascii_uppercase().to_string() + letters.as_str()).unwrap_or_default()
    };
    named(&words(name).iter().map(capital).collect::<String>(), 'X')
}

/// With a letter at the beginning.
fn named(text: &str, letter: char) -> String {
    if text.starts_with(|first: char| first.is_ascii_alphabetic()) {
        text.to_owned()
    } else {
        format!("{letter}{text}")
    }
}

/// In small letters; other letters than those of ASCII are left out.
fn words(name: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut before = '_';
    let mut letters = name.chars().peekable();
    while let Some(letter) = letters.next() {
        // `SFCInit`, `Pusher1MovedOut`
        let ends = before.is_ascii_uppercase() && letters.peek().is_some_and(char::is_ascii_lowercase);
        let begins = letter.is_ascii_uppercase() && (before.is_ascii_lowercase() || before.is_ascii_digit() || ends);
        if begins || !letter.is_ascii_alphanumeric() {
            words.push(String::new());
        }
        if let Some(last) = words.last_mut().filter(|_| letter.is_ascii_alphanumeric()) {
            last.push(letter.to_ascii_lowercase());
        }
        before = letter;
    }
    words.retain(|word| !word.is_empty());
    words
}

#[cfg(test)]
mod tests {
    use super::{Names, camel, snake};

    #[test]
    fn words_of_names() {
        assert_eq!(
            ["on", "SWITCH_BUTTON", "SwitchButton", "xStart", "q1", "_a__b", "größe", "SFCInit", "Pusher1MovedOut"]
                .map(snake),
            ["on", "switch_button", "switch_button", "x_start", "q1", "a_b", "gr_e", "sfc_init", "pusher1_moved_out"]
        );
        assert_eq!(
            ["Off", "ORANGE", "step_1", "S1", "OnStep", "fillAndHeat", "A", "1st"].map(camel),
            ["Off", "Orange", "Step1", "S1", "OnStep", "FillAndHeat", "A", "X1st"]
        );
    }

    #[test]
    fn each_name_once() {
        let mut names = Names::new();
        assert_eq!(["in", "In", "q"].map(|name| names.value(name)), ["in_", "in__2", "q"]);
        assert_eq!(["S", "Off", "OFF"].map(|name| names.step(name)), ["SStep", "Off", "Off2"]);
        assert_eq!((names.get_step("off"), names.get("off")), (Some("Off2"), None));
        // A variable that is called as a step.
        assert_eq!((names.value("OFF"), names.get_step("Off")), ("off".to_owned(), Some("Off2")));
        assert_eq!(names.renamed.len(), 5);
    }
}
