//! Scripts with what a person does beside the inputs: parameters that are exchanged, *Init*, and cycles by hand.
//!
//! A word `most=80` exchanges a parameter from that cycle on; with `init{}` the cycle starts like a first one; `force{Run,Light}` makes one that leads into these
//! steps by hand.

use std::fmt::Write as _;

use grafcet_sim::{BadLine, Kind, Signal, Value, script_line, script_of, script_words};

/// One cycle of a session.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Played {
    pub(crate) now: u32,
    /// Of each signal.
    pub(crate) values: Vec<Value>,
    /// What is exchanged in front of it: parameters by their places.
    pub(crate) params: Vec<(usize, Value)>,
    /// It starts like a first one.
    pub(crate) init: bool,
    /// The steps that it leads into by hand.
    pub(crate) by_hand: Option<Vec<String>>,
}

/// Reads all cycles.
///
/// # Errors
/// A word is no signal, parameter or order by hand, or has a value that is none of its own.
pub(crate) fn read(signals: &[Signal], params: &[Signal], text: &str) -> Result<Vec<Played>, BadLine> {
    let mut cycles: Vec<Played> = Vec::new();
    for (index, line) in text.lines().enumerate().filter(|(_, line)| !line.starts_with('#')) {
        let here = |bad: BadLine| BadLine { line: index + 1, ..bad };
        let (mut others, mut exchanged, mut init, mut by_hand) = (Vec::new(), Vec::new(), false, None);
        for word in script_words(line) {
            if let Some(steps) = word.strip_prefix("force{").and_then(|rest| rest.strip_suffix('}')) {
                by_hand = Some(steps.split(',').filter(|step| !step.is_empty()).map(str::to_owned).collect());
                continue;
            }
            if word == "init{}" {
                init = true;
                continue;
            }
            match params.iter().position(|param| word.split('=').next() == Some(&param.name)) {
                Some(place) => exchanged.push((place, value(&params[place], word).map_err(here)?)),
                None => others.push(word),
            }
        }
        // The time goes on from line to line.
        let before = cycles.last().map_or(0, |cycle| cycle.now);
        let rest = format!("@{before} {}", others.join(" "));
        for (now, values) in script_of(signals, &rest).map_err(here)? {
            cycles.push(Played { now, values, params: exchanged.clone(), init, by_hand: by_hand.clone() });
        }
    }
    Ok(cycles)
}

fn value(param: &Signal, word: &str) -> Result<Value, BadLine> {
    let bad = || BadLine { line: 1, word: word.to_owned() };
    // Of a truth the name alone is no exchange: it would be a value that nobody sees.
    if !word.contains('=') && param.kind != Kind::Bool {
        return Err(bad());
    }
    let mut read = script_of(std::slice::from_ref(param), word)?;
    read.pop().and_then(|mut cycle| cycle.1.pop()).ok_or_else(bad)
}

/// The lines that [`read`] reads as these cycles.
pub(crate) fn text(signals: &[Signal], params: &[Signal], cycles: &[Played]) -> String {
    let mut clock = 0;
    let mut lines = String::new();
    for cycle in cycles {
        if cycle.now != clock {
            // Writing to a string cannot fail.
            _ = write!(lines, "@{} ", cycle.now);
            clock = cycle.now;
        }
        for (place, value) in &cycle.params {
            _ = write!(lines, "{}={value} ", params[*place].name);
        }
        if cycle.init {
            lines += "init{} ";
        }
        if let Some(steps) = &cycle.by_hand {
            _ = write!(lines, "force{{{}}} ", steps.join(","));
        }
        lines += &script_line(signals, &cycle.values);
        lines.push('\n');
    }
    lines
}

#[cfg(test)]
mod tests {
    use grafcet_sim::{Kind, Signal, Value};

    use super::{read, text};

    #[test]
    fn what_is_written_is_read_again() {
        let signal = |name: &str, kind| Signal { name: name.to_owned(), kind };
        let number = || Kind::Int { signed: false, bits: 8 };
        let signals = [signal("on", Kind::Bool), signal("near(x, 3)", Kind::Bool)];
        let params = [signal("most", number()), signal("fast", Kind::Bool), signal("soak", Kind::Time)];
        let script =
            "-\n@5 most=80 fast=false on\n@7 force{Run,Two::Light} on `near(x, 3)`\nforce{} -\nsoak=300 init{} on\n";
        let cycles = read(&signals, &params, script).expect("a script");
        assert_eq!(text(&signals, &params, &cycles), script);
        assert_eq!(cycles[1].params, [(0, Value::Int(80)), (1, false.into())]);
        assert_eq!(cycles[2].by_hand, Some(vec!["Run".to_owned(), "Two::Light".to_owned()]));
        assert_eq!((cycles[3].by_hand.as_deref(), cycles[3].now), (Some(&[][..]), 7));
        assert_eq!(
            (&cycles[4].params[..], cycles[4].init, cycles[3].init),
            (&[(2, Value::Ticks(300))][..], true, false)
        );
        for (bad, word) in [
            ("-\nmost", "most"),
            ("-\nmost=x", "most=x"),
            ("-\nmoist=3", "moist=3"),
            ("#\nforce{A", "force{A"),
            ("-\ninit", "init"),
        ] {
            let error = read(&signals, &params, bad).expect_err(bad);
            assert_eq!((error.line, error.word.as_str()), (2, word));
        }
    }
}
