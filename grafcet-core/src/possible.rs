//! Which situations a chart can be in, as far as the compiler knows.

use core::fmt::{self, Display};

use crate::Chart;

/// A chart that can be put into a situation by hand: one that says `forceable;`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be put into a situation by hand",
    label = "not forceable",
    note = "write `forceable;` in the chart"
)]
pub trait Forceable: Chart {
    /// One cycle that leads into a situation, whatever the transition conditions say.
    ///
    /// This is for commissioning, with somebody beside the machine: what the chart makes sure of on its ways, and what the compiler has proved of
    /// them, does not hold on this one. Steps that were active and are not named are left, steps that were not are entered, each with its actions;
    /// steps that stay go on. No transition clears, and nothing of the steps in between runs. It is decision A38 on the page of the meaning.
    ///
    /// # Errors
    /// The chart is never in exactly these steps; then nothing has happened, and no cycle was made.
    fn force(
        &mut self,
        steps: &[Self::Step],
        inputs: &Self::Inputs,
        now: crate::Ticks,
        actions: &mut Self::Actions<'_>,
    ) -> Result<Self::Outputs, ForceError<Self::Step>>;
}

/// Why a chart was not put into a situation.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ForceError<S> {
    /// These two steps are never active together.
    NeverTogether(S, S),
    /// These steps are active together with others at most: one is missing, or the combination does not occur.
    NoSituation,
}

impl<S: Display> Display for ForceError<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NeverTogether(one, other) => write!(f, "`{one}` and `{other}` are never active together"),
            Self::NoSituation => f.write_str("the chart has no situation of exactly these steps"),
        }
    }
}

impl<S: Display + fmt::Debug> core::error::Error for ForceError<S> {}

/// What the compiler knows of a chart's situations; in each, a row has a bit for each step, in whole bytes.
#[derive(Clone, Copy, Debug)]
pub enum Possible {
    /// Nothing: all that the state can hold.
    Unknown,
    /// One step alone.
    Alone,
    /// A row for each situation.
    Listed(&'static [u8]),
    /// A row for each step: with which others it can be active.
    Pairs(&'static [u8]),
    /// The same of a chart in which as many steps as can be together always are.
    Whole(&'static [u8]),
}

impl Possible {
    /// Whether the chart can be in this situation.
    pub fn allows(self, steps: usize, is_active: impl Fn(usize) -> bool) -> bool {
        let row = steps.div_ceil(8);
        let fits = |table: &[u8], step: usize| {
            (0..steps).all(|other| other == step || !is_active(other) || together(table, row, step, other))
        };
        match self {
            Self::Unknown => true,
            Self::Alone => (0..steps).filter(|step| is_active(*step)).nth(1).is_none(),
            Self::Listed(rows) => {
                rows.chunks_exact(row.max(1)).any(|row| (0..steps).all(|step| in_row(row, step) == is_active(step)))
            }
            Self::Pairs(table) => (0..steps).all(|step| !is_active(step) || fits(table, step)),
            // Where nothing is missing no step could be active beside these.
            Self::Whole(table) => (0..steps).all(|step| is_active(step) == fits(table, step)),
        }
    }

    /// What is wrong with a situation that is asked for; `all` are the steps of the chart.
    ///
    /// # Errors
    /// The chart can never be in it.
    pub fn look<S: Copy + PartialEq>(self, all: &[S], steps: &[S]) -> Result<(), ForceError<S>> {
        let is_active = |step: usize| all.get(step).is_some_and(|step| steps.contains(step));
        if self.allows(all.len(), is_active) {
            return Ok(());
        }
        let place = |step: &S| all.iter().position(|other| other == step);
        let apart = |one: &S, other: &S| match (place(one), place(other)) {
            (Some(one), Some(other)) => one != other && !self.may_be_together(all.len(), one, other),
            _ => false,
        };
        let first = steps.iter().find_map(|one| Some((*one, *steps.iter().find(|other| apart(one, other))?)));
        Err(first.map_or(ForceError::NoSituation, |(one, other)| ForceError::NeverTogether(one, other)))
    }

    fn may_be_together(self, steps: usize, one: usize, other: usize) -> bool {
        let row = steps.div_ceil(8);
        match self {
            Self::Unknown => true,
            Self::Alone => false,
            Self::Listed(rows) => rows.chunks_exact(row.max(1)).any(|row| in_row(row, one) && in_row(row, other)),
            Self::Pairs(table) | Self::Whole(table) => together(table, row, one, other),
        }
    }
}

/// Whether a row has the bit of a step.
fn in_row(row: &[u8], step: usize) -> bool {
    row.get(step / 8).is_some_and(|byte| byte >> (step % 8) & 1 != 0)
}

fn together(table: &[u8], row: usize, one: usize, other: usize) -> bool {
    table.get(one * row..).is_some_and(|table| in_row(table, other))
}
