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
pub enum Possible<'t> {
    /// Nothing: all that the state can hold.
    Unknown,
    /// One step alone.
    Alone,
    /// A row for each situation.
    Listed(&'t [u8]),
    /// A decision diagram of all situations: three bytes for each node, a step and the nodes that follow where it is inactive and where it is active. Node 0 is no
    /// situation, node 1 the end of one, and those of the table are numbered from 2 on. What lies between two steps that are asked for is inactive.
    Diagram(&'t [u8]),
    /// A row for each step: with which others it can be active.
    Pairs(&'t [u8]),
    /// The same of partial grafcets, and below it what each piece of them can be in: its steps as a row, the step without which none of them is active (255: there is
    /// none), how many nodes a [`Diagram`](Self::Diagram) of it has, and these.
    Parts(&'t [u8], &'t [u8]),
    /// A row for each step, of a chart in which as many steps as can be together always are.
    Whole(&'t [u8]),
}

impl Possible<'_> {
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
            Self::Diagram(nodes) => leads_to_the_end(nodes, steps, is_active),
            Self::Pairs(table) => (0..steps).all(|step| !is_active(step) || fits(table, step)),
            Self::Parts(table, parts) => {
                (0..steps).all(|step| !is_active(step) || fits(table, step)) && parts_allow(parts, steps, is_active)
            }
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
            Self::Diagram(nodes) => are_on_one_way(nodes, one, other),
            Self::Pairs(table) | Self::Parts(table, _) | Self::Whole(table) => together(table, row, one, other),
        }
    }
}

/// Where a diagram comes to its end.
const NOWHERE: usize = 0;
const END: usize = 1;

/// The nodes of a diagram with their numbers, each after those to which it leads: which step it asks for, and where to go on.
fn nodes(table: &[u8]) -> impl DoubleEndedIterator<Item = (usize, [usize; 3])> + '_ {
    let nodes = table.chunks_exact(3).enumerate();
    nodes.map(|(place, node)| {
        let byte = |at: usize| node.get(at).map_or(NOWHERE, |byte| usize::from(*byte));
        (place + END + 1, [byte(0), byte(1), byte(2)])
    })
}

/// Whether a situation is one of those of a diagram.
fn leads_to_the_end(table: &[u8], steps: usize, is_active: impl Fn(usize) -> bool) -> bool {
    let (mut next, mut from) = (table.len() / 3 + END, 0);
    // Each node stands after those to which it leads.
    for (number, [step, inactive, active]) in nodes(table).rev() {
        if number == next {
            if (from..step).any(&is_active) {
                return false;
            }
            next = if is_active(step) { active } else { inactive };
            from = step + 1;
        }
    }
    next == END && !(from..steps).any(is_active)
}

/// Whether each piece is in a situation of its own.
fn parts_allow(mut parts: &[u8], steps: usize, is_active: impl Fn(usize) -> bool) -> bool {
    let row = steps.div_ceil(8);
    while let Some((own, [enclosing, count, rest @ ..])) = parts.split_at_checked(row) {
        let Some((nodes, rest)) = rest.split_at_checked(3 * usize::from(*count)) else { break };
        parts = rest;
        let enclosing = usize::from(*enclosing);
        let is_own = |step: usize| in_row(own, step) && is_active(step);
        let is_possible = if enclosing >= steps || is_active(enclosing) {
            leads_to_the_end(nodes, steps, is_own)
        } else {
            !(0..steps).any(is_own)
        };
        if !is_possible {
            return false;
        }
    }
    true
}

/// Whether two different steps are active together in a situation of a diagram.
fn are_on_one_way(table: &[u8], one: usize, other: usize) -> bool {
    // Of each node, which of the two are active on the ways that begin there: a bit each for neither, for one, for the other, for both.
    let mut ways = [0_u8; 256];
    if let Some(end) = ways.get_mut(END) {
        *end = 1;
    }
    let mut last = 0;
    for (number, [step, inactive, active]) in nodes(table) {
        let of = |node: usize| ways.get(node).copied().unwrap_or(0);
        let shift = if step == one { 1 } else { 2 * u32::from(step == other) };
        last = of(inactive) | of(active) << shift;
        if let Some(way) = ways.get_mut(number) {
            *way = last;
        }
    }
    last & 8 != 0
}

/// Whether a row has the bit of a step.
fn in_row(row: &[u8], step: usize) -> bool {
    row.get(step / 8).is_some_and(|byte| byte >> (step % 8) & 1 != 0)
}

fn together(table: &[u8], row: usize, one: usize, other: usize) -> bool {
    table.get(one * row..).is_some_and(|table| in_row(table, other))
}

#[cfg(test)]
mod tests {
    use super::{ForceError, Possible};

    /// (0 or 1), and with 0 also 2 or not; 3 never; 4 alone.
    const NODES: Possible = Possible::Diagram(&[4, 0, 1, 2, 1, 1, 1, 2, 1, 0, 4, 3]);

    #[test]
    fn a_diagram_allows_its_situations_and_no_others() {
        let mut allowed = 0;
        for set in 0_u32..32 {
            let expected = matches!(set, 0b1 | 0b101 | 0b10 | 0b10000);
            assert_eq!(NODES.allows(5, |step| set >> step & 1 != 0), expected, "{set:b}");
            allowed += u32::from(expected);
        }
        assert_eq!(allowed, 4);
        assert!(Possible::Diagram(&[]).allows(2, |_| false) && !Possible::Diagram(&[]).allows(2, |step| step == 1));
    }

    /// Steps 0 and 1 exclude each other; 1 encloses 2 and 3, of which one is active, or both are.
    #[test]
    fn parts_have_situations_of_their_own() {
        let pairs = &[0b1100, 0b1100, 0b1011, 0b0111];
        let chart =
            Possible::Parts(pairs, &[0b0011, 255, 2, 1, 0, 1, 0, 2, 1, 0b1100, 1, 3, 3, 0, 1, 3, 1, 1, 2, 2, 3]);
        for set in 0_u32..16 {
            let expected = matches!(set, 0b0001 | 0b0110 | 0b1010 | 0b1110);
            assert_eq!(chart.allows(4, |step| set >> step & 1 != 0), expected, "{set:b}");
        }
        assert!(Possible::Pairs(pairs).allows(4, |step| step == 2), "pairs do not tell what is missing");
        assert!(chart.may_be_together(4, 1, 3) && !chart.may_be_together(4, 0, 1));
    }

    #[test]
    fn a_diagram_tells_which_steps_are_apart() {
        let all = [0, 1, 2, 3, 4];
        let together = |one, other| NODES.may_be_together(5, one, other);
        for one in all {
            for other in all.into_iter().filter(|other| *other != one) {
                assert_eq!(together(one, other), one.min(other) == 0 && one.max(other) == 2, "{one} {other}");
            }
        }
        assert_eq!(NODES.look(&all, &[2, 0]), Ok(()));
        assert_eq!(NODES.look(&all, &[0, 2, 1]), Err(ForceError::NeverTogether(0, 1)));
        assert_eq!(NODES.look(&all, &[2]), Err(ForceError::NoSituation));
    }
}
