//! Coverage in words, and as a file that tools read.

use std::collections::BTreeMap;
use std::fmt::{self, Write as _};

use super::{Coverage, Criterion, Missing};

impl fmt::Display for Missing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Step(name) => write!(f, "step `{name}` was never active"),
            Self::Transition(name) => write!(f, "transition `{name}` never cleared"),
            Self::Part { transition, part, value } => {
                write!(f, "`{part}` never decided as {value} in the condition of `{transition}`")
            }
        }
    }
}

/// So many of so many.
struct Share(usize, usize);

impl fmt::Display for Share {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} of {}", self.0, self.1)
    }
}

/// The shares, and below what is missing, one line each.
impl fmt::Display for Coverage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let steps = Share(self.steps.iter().filter(|count| **count > 0).count(), self.steps.len());
        let cleared = self.transitions.iter().filter(|covered| covered.cleared > 0).count();
        let sides: Vec<u64> = self
            .transitions
            .iter()
            .flat_map(|covered| &covered.parts)
            .flat_map(|part| [part.when_true, part.when_false])
            .collect();
        let decided = Share(sides.iter().filter(|count| **count > 0).count(), sides.len());
        writeln!(
            f,
            "{}: {steps} steps active, {} transitions cleared, {decided} decisions of parts of conditions",
            self.names.chart,
            Share(cleared, self.transitions.len())
        )?;
        self.missing().iter().try_for_each(|missing| writeln!(f, "  {missing}"))
    }
}

impl Coverage {
    /// As an LCOV file about the chart's source. Lines are steps and transitions, of several on one line the one covered least;
    /// functions are steps; branches are the parts of conditions, each as true and as false.
    #[must_use]
    pub fn lcov(&self, source: &str) -> String {
        let mut out = format!("TN:{}\nSF:{source}\n", self.names.chart);
        // Writing to a string cannot fail.
        let mut lines: BTreeMap<usize, u64> = BTreeMap::new();
        let mut line = |at: usize, count: u64| {
            let least = lines.entry(at).or_insert(count);
            *least = count.min(*least);
        };
        for step in &self.names.steps {
            _ = writeln!(out, "FN:{},{}", step.line, step.name);
        }
        for (step, count) in self.names.steps.iter().zip(&self.steps) {
            _ = writeln!(out, "FNDA:{count},{}", step.name);
            line(step.line, *count);
        }
        let hit = self.steps.iter().filter(|count| **count > 0).count();
        _ = writeln!(out, "FNF:{}\nFNH:{hit}", self.steps.len());
        let (mut found, mut hit) = (0, 0);
        for (block, (transition, covered)) in self.names.transitions.iter().zip(&self.transitions).enumerate() {
            line(transition.line, covered.cleared);
            let sides = covered.parts.iter().flat_map(|part| [part.when_true, part.when_false]);
            for (branch, count) in sides.enumerate() {
                found += 1;
                hit += usize::from(count > 0);
                let taken = if covered.asked == 0 { "-".to_owned() } else { count.to_string() };
                _ = writeln!(out, "BRDA:{},{block},{branch},{taken}", transition.line);
            }
        }
        _ = writeln!(out, "BRF:{found}\nBRH:{hit}");
        for (at, count) in &lines {
            _ = writeln!(out, "DA:{at},{count}");
        }
        let hit = lines.values().filter(|count| **count > 0).count();
        _ = writeln!(out, "LF:{}\nLH:{hit}\nend_of_record", lines.len());
        out
    }

    /// Ends the test where something is not covered that is not among `except`: each is a line as [`Coverage`] shows it, or the
    /// beginning of one. [`assert_covered!`](crate::assert_covered) can ask for less.
    ///
    /// # Panics
    /// Something is missing, or something excepted is covered after all.
    #[track_caller]
    pub fn assert_covered(&self, except: &[&str]) {
        self.assert_all(&[], except);
    }

    /// What [`assert_covered!`](crate::assert_covered) does: no criterion means all of them.
    #[doc(hidden)]
    #[track_caller]
    pub fn assert_all(&self, criteria: &[Criterion], except: &[&str]) {
        let asked = |missing: &&Missing| criteria.is_empty() || criteria.contains(&missing.criterion());
        let missing: Vec<String> = self.missing().iter().filter(asked).map(ToString::to_string).collect();
        let is_excepted = |line: &&String| except.iter().any(|except| line.starts_with(except));
        let open: Vec<&String> = missing.iter().filter(|line| !is_excepted(line)).collect();
        let lines: Vec<String> = open.iter().map(|line| format!("\n  {line}")).collect();
        assert!(open.is_empty(), "not covered of {}:{}", self.names.chart, lines.concat());
        let covered = except.iter().find(|except| !missing.iter().any(|line| line.starts_with(**except)));
        assert!(covered.is_none(), "excepted, but covered of {}: {}", self.names.chart, covered.unwrap_or(&""));
    }
}

impl Missing {
    /// What asks for it.
    #[must_use]
    pub fn criterion(&self) -> Criterion {
        match self {
            Self::Step(_) => Criterion::Steps,
            Self::Transition(_) => Criterion::Transitions,
            Self::Part { .. } => Criterion::Conditions,
        }
    }
}

/// Ends the test with a list of what its runs have not covered.
///
/// ```
/// use grafcet_sim::{Chart, Simulation, assert_covered};
///
/// let chart = Chart::parse("sfc Motor { input on, hot: bool; initial step Off; step On; Off -[on && !hot]-> On -[!on]-> Off; }")?;
/// let mut motor = Simulation::new(&chart)?;
/// for on in [false, true, false] {
///     motor.cycle(0, &[("on", on.into())])?;
/// }
/// let coverage = motor.coverage();
/// assert_covered!(coverage, steps, transitions);                  // not what the conditions are made of
/// assert_covered!(coverage, conditions; except
///     "`hot` never decided as true",
///     "`on` never decided as false in the condition of `Off",
///     "`on` never decided as true in the condition of `On",
/// );
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// What is asked for are `steps` (each was active), `transitions` (each cleared) and `conditions` (each part decided both ways, masking MC/DC); all three where none is named. After
/// `except` stand lines that may be missing, or their beginnings; one that is covered after all ends the test, too. The first argument is a [`Coverage`] or a reference to one.
#[macro_export]
macro_rules! assert_covered {
    (@ steps) => { $crate::Criterion::Steps };
    (@ transitions) => { $crate::Criterion::Transitions };
    (@ conditions) => { $crate::Criterion::Conditions };
    (@ $other:ident) => {
        ::core::compile_error!(::core::concat!("`", ::core::stringify!($other), "` is none of `steps`, `transitions` and `conditions`"))
    };
    ($coverage:expr $(, $criterion:ident)* $(,)?) => {
        $crate::assert_covered!($coverage $(, $criterion)*; except)
    };
    ($coverage:expr $(, $criterion:ident)*; except $($except:expr),* $(,)?) => {
        $crate::Coverage::assert_all(
            ::core::borrow::Borrow::borrow(&$coverage),
            &[$($crate::assert_covered!(@ $criterion)),*],
            &[$($except),*],
        )
    };
}
