//! Plays timelines and compares.

use std::fmt;

use crate::reader::{Kind, Line};
use crate::{Rest, Shown, Subject, Values};

/// Where two subjects, or a subject and the file, say different things.
#[derive(Debug, PartialEq, Eq)]
pub struct Difference {
    /// The line in the file.
    pub line: usize,
    /// What is expected there.
    pub expected: String,
    /// What the compiled chart shows.
    pub found: String,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}\n  expected {}\n  found    {}", self.line, self.expected, self.found)
    }
}

/// Plays the timeline and compares with what the file expects.
///
/// # Errors
/// The first difference.
pub fn against_the_file(subject: &mut dyn Subject, lines: &[Line]) -> Result<(), Difference> {
    for line in lines {
        let (found, expected) = match &line.kind {
            Kind::Cycle { inputs, now, expected } => (subject.cycle(inputs, *now), expected),
            Kind::Force { asked, inputs, now, expected } => {
                let forced = subject.force(&asked.steps(&[]).0, inputs, *now);
                (forced.and_then(|shown| shown.ok_or_else(|| "refused".to_owned())), expected)
            }
            Kind::Refuses(asked) => match subject.force(&asked.steps(&[]).0, &Values::new(), 0) {
                Ok(None) => continue,
                Ok(Some(found)) => return Err(failure(line, "refused", &found.to_string())),
                Err(error) => return Err(failure(line, "refused", &error)),
            },
            Kind::Shows(expected) => (Ok(subject.shown()), expected),
            Kind::Init => {
                subject.init().map_err(|error| failure(line, "", &error))?;
                continue;
            }
            Kind::Params(changed) => {
                subject.set_params(changed).map_err(|error| failure(line, "", &error))?;
                continue;
            }
            Kind::Wakes(expected) => {
                let found = subject.next_deadline();
                if found == *expected {
                    continue;
                }
                return Err(failure(line, &format!("{expected:?}"), &format!("{found:?}")));
            }
        };
        let expected = normal(expected);
        match found {
            Ok(found) if found == expected => {}
            Ok(found) => return Err(failure(line, &expected.to_string(), &found.to_string())),
            Err(error) => return Err(failure(line, &expected.to_string(), &error)),
        }
    }
    Ok(())
}

/// Plays the timeline on both and compares them, whatever the file expects; `oracle` says what is right.
///
/// # Errors
/// The first difference.
pub fn in_lockstep(subject: &mut dyn Subject, oracle: &mut dyn Subject, lines: &[Line]) -> Result<(), Difference> {
    let mut seen = vec![oracle.shown().steps];
    for line in lines {
        let both = match &line.kind {
            Kind::Force { asked, inputs, now, .. } => {
                let (steps, is_certain) = asked.steps(&seen);
                match subject.force(&steps, inputs, *now) {
                    Ok(Some(found)) => oracle
                        .force(&steps, inputs, *now)
                        .and_then(|shown| Ok((shown.ok_or("the interpreter refuses nothing")?, found))),
                    Ok(None) if is_certain => {
                        return Err(failure(line, "a situation that was there before", &format!("{steps:?} refused")));
                    }
                    Ok(None) => continue,
                    Err(error) => Err(error),
                }
            }
            Kind::Refuses(_) => continue,
            Kind::Cycle { inputs, now, .. } => {
                let expected = oracle.cycle(inputs, *now);
                // What the interpreter calls a mistake of the chart may be a panic of the compiled one.
                expected.and_then(|expected| Ok((expected, subject.cycle(inputs, *now)?)))
            }
            Kind::Init => oracle.init().and_then(|()| subject.init()).map(|()| (oracle.shown(), subject.shown())),
            Kind::Params(changed) => {
                // It shows in the next cycle.
                let set = oracle.set_params(changed).and_then(|()| subject.set_params(changed));
                set.map(|()| (subject.shown(), subject.shown()))
            }
            Kind::Shows(_) | Kind::Wakes(_) => Ok((oracle.shown(), subject.shown())),
        };
        match both {
            Ok((expected, found)) if found == expected => {
                at_once(subject, oracle, line)?;
                // What an unstable search has stopped at is no situation in which a cycle ends as it should.
                if expected.stable && !seen.contains(&expected.steps) {
                    seen.push(expected.steps);
                }
            }
            Ok((expected, found)) => return Err(failure(line, &expected.to_string(), &found.to_string())),
            Err(error) => return Err(failure(line, "no error of the interpreter", &error)),
        }
    }
    Ok(())
}

/// Whether the subject asks for a cycle at once where there is something to do, and nowhere else.
fn at_once(subject: &dyn Subject, oracle: &dyn Subject, line: &Line) -> Result<(), Difference> {
    let (Kind::Cycle { now, .. } | Kind::Force { now, .. }) = &line.kind else { return Ok(()) };
    let Some(rest) = oracle.rest() else { return Ok(()) };
    let wakes = subject.next_deadline();
    let wrong = match rest {
        Rest::Goes => wakes != Some(*now),
        Rest::Looks => false,
        Rest::Sleeps => wakes == Some(*now),
    };
    if wrong { Err(failure(line, &format!("{rest:?}"), &format!("next deadline {wakes:?}"))) } else { Ok(()) }
}

fn failure(line: &Line, expected: &str, found: &str) -> Difference {
    Difference { line: line.number, expected: expected.to_owned(), found: found.to_owned() }
}

/// Without what is zero.
fn normal(expected: &Shown) -> Shown {
    let mut expected = expected.clone();
    expected.outputs.retain(|_, value| *value != 0);
    expected
}
