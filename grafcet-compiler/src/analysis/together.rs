//! Which situations a chart can be in, as a table by which one that comes from outside is looked at: a stored one, or one that is asked for by hand.

use super::diagram::diagram;
use super::explore::{Limits, Wanted};
use super::{Concurrency, Facts, explore};
use crate::list::{List, PushAll};
use crate::model::{Id, Model, Name, Read, StepId};
use crate::sorted::Set;

/// Of charts with more steps a stored situation is not looked at: a table of pairs grows with the square of their number.
const MOST_STEPS: usize = 256;

/// More situations are not looked for.
const MOST_SITUATIONS: usize = 50_000;

/// How many units of work it is worth to find them, where the chart has no `budget` of its own.
const WORK: u64 = 200_000;

/// What is known of the situations; in each table, a row has a bit for each step, in whole bytes.
pub enum Situations {
    /// Nothing.
    Unknown,
    /// Each has one step, or none.
    Alone,
    /// A row for each.
    Listed(Vec<u8>),
    /// A decision diagram of them, where that is shorter.
    Diagram(Vec<u8>),
    /// A row for each step: with which others it can be active.
    Pairs(Vec<u8>),
    /// The same, and after it what each piece can be in: its steps as a row, the step without which none of them is active (or 255), how many nodes, and these.
    Parts(Vec<u8>, Vec<u8>),
    /// A row for each step, and as many as can be together always are: so it is in a chart that is well nested, whose branches exclude each other.
    Whole(Vec<u8>),
}

impl Situations {
    /// Whether one that was stored is looked at: not where the table takes much.
    pub(crate) fn are_stored(model: &Model) -> bool {
        model.steps.len() <= MOST_STEPS
    }

    /// Whatever the table takes.
    #[must_use]
    pub fn of(model: &Model, facts: &Facts<'_>) -> Self {
        let row = model.steps.len().div_ceil(8);
        if let Some(all) = Self::all(model, facts, row) {
            return all;
        }
        let exclusive = Concurrency::of_exclusive_branches(model);
        let concurrency = facts.concurrency.across_partials_from(model, &facts.initial, &Set::new());
        let mut is_whole = facts.nesting(model).is_some();
        let mut table = Vec::with_capacity(row * model.steps.len());
        for a in model.steps.ids() {
            let mut others = Vec::new();
            for b in model.steps.ids() {
                let together = a != b && concurrency.together(a, b);
                is_whole &= a == b || together == exclusive.together(a, b);
                if together {
                    others.push(b);
                }
            }
            table.push_all(bits(&others, row));
        }
        if is_whole {
            return Self::Whole(table);
        }
        let parts = parts(model, facts, row);
        if parts.is_empty() { Self::Pairs(table) } else { Self::Parts(table, parts) }
    }

    /// Those and no others, where they are found.
    fn all(model: &Model, facts: &Facts<'_>, row: usize) -> Option<Self> {
        let found = explore::situations(model, facts, wanted(model))?;
        let diagram = diagram(&found.iter().map(|steps| &steps[..]).list())?;
        // One of a few rows has few nodes.
        let is_listed = found.len() * row <= diagram.len();
        let rows = || found.iter().flat(|steps| bits(steps, row)).list();
        Some(if is_listed { Self::Listed(rows()) } else { Self::Diagram(diagram) })
    }
}

fn wanted(model: &Model) -> Wanted {
    let work = model.budget.map_or(WORK, |count| Limits::situations(count).work);
    Wanted { work, most: MOST_SITUATIONS, by_hand: forgets(model) }
}

/// The pieces of partial grafcets, where the chart is too large for its situations to be found as a whole.
fn parts(model: &Model, facts: &Facts<'_>, row: usize) -> Vec<u8> {
    let mut parts = Vec::new();
    // A number of its own says that nothing encloses a piece.
    if model.steps.len() > usize::from(NOTHING) {
        return parts;
    }
    for piece in explore::pieces(model, facts, wanted(model)) {
        let Some(nodes) = diagram(&piece.situations.iter().map(|steps| &steps[..]).list()) else { continue };
        let byte = |number: usize| u8::try_from(number).unwrap_or(NOTHING);
        parts.push_all(bits(&piece.steps, row));
        parts.push(piece.enclosed_by.map_or(NOTHING, |step| byte(step.index())));
        parts.push(byte(nodes.len() / 3));
        parts.push_all(nodes);
    }
    parts
}

/// What stands for a step where there is none.
const NOTHING: u8 = u8::MAX;

/// Whether a cycle by hand (A38) leaves behind what no way of the chart's own does, and some condition asks for it: another value, an edge of a step.
fn forgets(model: &Model) -> bool {
    let is_of_inputs = |read: &Read| matches!(read, Read::Name(Name::Input(_) | Name::Param(_)));
    let stays = |read: &Read| match read {
        Read::Rising(id) | Read::Falling(id) => model.edges[*id].of.reads.iter().all(is_of_inputs),
        Read::Name(Name::Var(_) | Name::Output(_)) | Read::Delay(_) => false,
        // When times are over is taken to be open.
        _ => true,
    };
    model.forceable && !model.transitions.values().all(|transition| transition.condition.reads.iter().all(stays))
}

/// A row with the bits of these steps.
fn bits(steps: &[StepId], row: usize) -> Vec<u8> {
    let mut bytes = vec![0; row];
    for step in steps {
        bytes[step.index() / 8] |= 1_u8 << (step.index() % 8);
    }
    bytes
}
