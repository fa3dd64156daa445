//! Edges and delays in properties, on the graph of all cycles: what has been seen is a part of the state, and nothing of the prover's.
//!
//! The chart of the graph says what they look at, without them: `never Q && P;` for `never rising(P) && Q;`.

use grafcet_compiler::model::{Binary, Claim, Model, Tree};

use super::graph::Graph;
use super::responses::Edges;

/// What stands in front of the second condition.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Over {
    Rise,
    Fall,
    /// `t1/P/t2`, in ticks.
    Delay(u32, u32),
    /// `rising(t/P)`
    RiseOfDelay(u32),
}

/// The condition with it.
pub(crate) fn text(over: Over, of: &str) -> String {
    match over {
        Over::Rise => format!("rising({of})"),
        Over::Fall => format!("falling({of})"),
        Over::Delay(on, off) => format!("{on}ms/({of})/{off}ms"),
        Over::RiseOfDelay(on) => format!("rising({on}ms/({of}))"),
    }
}

/// What has been seen at the end of the cycle before.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Seen {
    of: bool,
    /// For so long, up to what a delay asks for.
    held: u32,
    output: bool,
}

/// After how many cycles `never Q && P;` is broken first, where P stands below an edge or a delay.
///
/// # Errors
/// It is no such property, or the interpreter does not understand it.
pub(crate) fn broken(model: &Model, graph: &Graph, claim: &Claim, over: Over) -> Result<Option<usize>, String> {
    let Claim::Never(condition) = claim else { return Err("no `never`".to_owned()) };
    let Tree::Binary(Binary::And, other, of) = &condition.tree else { return Err("no `&&`".to_owned()) };
    let edges = Edges::of(model, graph, of, other)?;
    let next = |seen: Option<Seen>, of: bool, other: bool, elapsed: u32| {
        let (after, holds) = step(over, seen, of, elapsed);
        (Some(after), holds && other)
    };
    Ok(edges.shortest(None, next))
}

fn step(over: Over, seen: Option<Seen>, of: bool, elapsed: u32) -> (Seen, bool) {
    // Before the first cycle there is nothing to compare with.
    let before = seen.map_or(of, |seen| seen.of);
    let (on, off) = match over {
        Over::Delay(on, off) => (on, off),
        Over::RiseOfDelay(on) => (on, 0),
        Over::Rise => return (Seen { of, held: 0, output: false }, of && !before),
        Over::Fall => return (Seen { of, held: 0, output: false }, !of && before),
    };
    let (time, was) = (if of { on } else { off }, seen.is_some_and(|seen| seen.output));
    let held = match seen {
        Some(seen) if seen.of == of => seen.held.saturating_add(elapsed).min(time),
        _ => 0,
    };
    let output = if held >= time { of } else { was };
    let holds = match over {
        Over::RiseOfDelay(_) => output && !was && seen.is_some(),
        _ => output,
    };
    (Seen { of, held, output }, holds)
}
