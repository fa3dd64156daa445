//! From a naive program to one as an engineer would write it. Each pass sees a program and nothing of the chart; one that does not apply
//! changes nothing.
//!
//! A chart that says `forceable;` has a second cycle (A38), which begins in any state and leads to any other. It stays as it was lowered; passes that follow what fields hold
//! from one cycle to the next leave such a chart alone (`Pass::follows_cycles`).
//!
//! - `marks`: what observers are told, where nobody observes
//! - `acted`: which association acted last is asked where it makes a difference
//! - `decompose`: conditions of the user taken apart
//! - `outputs`: outputs that each cycle gives a value are no fields
//! - `peel`: what a search does in its first round alone, or in each round alike
//! - `straight`: the search of a `grafcet` that ends with its first evolution is no loop
//! - `split`: one match on the state before, one on the state after; what fields hold in each state
//! - `told`: an output that each state tells is no field
//! - `moved`: the state that the cycle began with tells whether it has moved
//! - `search`: the same in the loop of a `grafcet`, and after it
//! - `several`: of several regions, each looked at by itself as far as that is possible
//! - `rounds`: of the search over several regions, what forces and encloses first, and one match for each region
//! - `starting`: the first cycle of a `grafcet` is a state
//! - `stays`: a stored value that changes only where something moves is not compared
//! - `hoist`: what all arms do first
//! - `forward`: locals replaced by what they were set from
//! - `before`: the states that a cycle of several regions began with tell whether it has moved
//! - `shown`: outputs that end each cycle with what a field holds
//! - `begun`: a time begins only where a step becomes active that asks for it
//! - `anew`: what a field holds in a state is not stored there once more
//! - `dead`: what nobody looks at
//! - `once`: nothing is asked of the inputs twice on a way
//! - `equal`: what comes to the same in several states is done once
//! - `store`: the next state is stored once
//! - `tables`: of a long sequence a test for each condition, and a table of the next states
//! - `next`: steps that wait for the same share an arm, and a table says which step is next
//! - `passed`: a time is computed once for all states that ask for it
//! - `records`: few outputs are one constant in each state
//! - `working`: while a search goes on, the state is a local
//! - `numbers`: a number that the active step tells comes from a table
//! - `kinds`: in a long chart a table says what there is to do in a state
//! - `nested`: what one region does stands with the states of another one beside which it does something
//! - `united`: regions that have few states together share one place
//! - `arms`: what is done in one state alone stands in its arm
//! - `direct`: outputs are put together in their own places
//! - `fences`: where LLVM would make more of the code than it has to
//! - `common`: what many states ask first is asked in front of the match
//! - `limits`: whether a time has reached its limit is asked as "not less"
//!
//! Whether the actions of an `sfc` of several regions stand apart (`Apart`) is weighed after all others, which run on both; what stands once in front of the match of `split`, or after it, is weighed within it (`front`, `tail`).
//!
//! `split` and `search` stand on `flat` (the cycle as one list), `sparse` (which statements matter in which state), `engine` and `branches` (a cycle in one state) and
//! `share` (what lists have in common, `alike` what only looks different), `search` on `early` (where it ends without another look), `several` and `rounds` also on `parts` (another order, in which those of one region stand together; `belonging`, where regions only look at each other) and `among` (which
//! states of a region are possible); all of them on `uses` (effects, sameness; reads and writes in `program/uses.rs`), `many` (many arms at once) and `fold` (expressions of which something is known).

mod acted;
mod alike;
mod among;
mod anew;
mod arms;
mod before;
mod begun;
mod belonging;
mod branches;
mod common;
mod comparisons;
mod dead;
mod decompose;
mod direct;
mod early;
mod edits;
mod engine;
mod equal;
mod excluding;
mod fences;
mod flat;
mod fold;
mod forward;
mod front;
mod hoist;
mod kinds;
mod limits;
mod live;
mod many;
mod moved;
mod nested;
mod next;
mod numbers;
mod once;
mod order;
mod outputs;
mod parts;
mod passed;
mod peel;
mod records;
mod rounds;
mod search;
mod several;
mod share;
mod shown;
mod sparse;
mod split;
mod starting;
mod stays;
mod store;
mod straight;
mod tables;
mod tail;
mod told;
mod united;
mod uses;
mod working;

use several::Actions;

use super::{Program, Statement};

/// Writes the passes as an enum and as a list, so that no pass is in one of them alone.
macro_rules! passes {
    ($($(#[$doc:meta])* $pass:ident,)*) => {
        /// A pass that can be left out.
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        pub enum Pass {
            $($(#[$doc])* $pass,)*
        }

        impl Pass {
            /// In their order.
            pub const ALL: [Self; [$(stringify!($pass)),*].len()] = [$(Self::$pass),*];
        }
    };
}

passes! {
    Marks,
    Acted,
    Decompose,
    Outputs,
    Peel,
    Straight,
    Split,
    /// What fields hold in each state, within `Split`.
    Known,
    /// What ways have in common, within `Split`.
    Join,
    /// An output that each state tells is no field, within `Split` and `Search`.
    Told,
    /// The state before tells whether the cycle has moved, within `Split`.
    Moved,
    Search,
    Several,
    /// The actions of several regions after the evolution, within `Several`, if that is shorter.
    Apart,
    Rounds,
    Starting,
    Stays,
    Hoist,
    Forward,
    Before,
    Shown,
    Begun,
    Anew,
    Dead,
    Once,
    Equal,
    Store,
    Tables,
    Next,
    Passed,
    Records,
    Working,
    Numbers,
    Kinds,
    Nested,
    United,
    Arms,
    Direct,
    Fences,
    Common,
    Limits,
}

impl Pass {
    /// Whether it takes for granted that a state is entered by the ways of the chart's own cycle alone.
    fn follows_cycles(self) -> bool {
        matches!(
            self,
            Self::Known
                | Self::Told
                | Self::Moved
                | Self::Before
                | Self::Begun
                | Self::Anew
                | Self::Equal
                | Self::Nested
                | Self::United
        )
    }
}

/// The same cycle in fewer words, by the passes that are wanted.
pub fn optimise(program: &mut Program<'_>, wanted: &[Pass]) {
    let is_forced = program.forced.is_some();
    let wants = |pass: Pass| wanted.contains(&pass) && !(is_forced && pass.follows_cycles());
    for (at, pass) in Pass::ALL.into_iter().enumerate() {
        if pass == Pass::Several && wants(pass) && wants(Pass::Apart) {
            apart(program, &Pass::ALL[at..], &wants);
            return;
        }
        if wants(pass) {
            apply(pass, program, &wants);
        }
    }
}

/// The rest of the passes on the cycle as it is, and on those whose actions stand apart: the shortest one is left.
fn apart(program: &mut Program<'_>, passes: &[Pass], wants: &dyn Fn(Pass) -> bool) {
    let rest = |program: &mut Program<'_>| {
        for pass in passes.iter().copied().skip(1).filter(|pass| wants(*pass)) {
            apply(pass, program, wants);
        }
    };
    let lowered = program.clone();
    apply(Pass::Several, program, wants);
    rest(program);
    for actions in [Actions::Apart, Actions::AllApart] {
        let is_worth_trying = if actions == Actions::Apart { program.is_short() } else { program.is_long() };
        if !is_worth_trying {
            continue;
        }
        let Some(mut other) = several::apart(&lowered, actions) else { continue };
        rest(&mut other);
        if other.is_shorter(program) {
            *program = other;
        }
    }
}

/// What stands within another pass is asked for there.
fn apply(pass: Pass, program: &mut Program<'_>, wants: &dyn Fn(Pass) -> bool) {
    match pass {
        Pass::Marks => {
            for cycle in program.cycles_mut() {
                edits::remove(cycle, &|one| matches!(one, Statement::Mark(_)));
                without_empty(cycle);
            }
        }
        Pass::Split => {
            let [known, join, told, moved] = [Pass::Known, Pass::Join, Pass::Told, Pass::Moved].map(wants);
            split::pass(program, &split::Options { known, join, told, moved });
        }
        Pass::Known | Pass::Join | Pass::Told | Pass::Moved | Pass::Apart => {}
        Pass::Search => search::pass(program, wants(Pass::Told)),
        Pass::Acted => acted::pass(program),
        Pass::Decompose => decompose::pass(program),
        Pass::Outputs => outputs::pass(program),
        Pass::Peel => peel::pass(program),
        Pass::Straight => straight::pass(program),
        Pass::Several => several::pass(program),
        Pass::Rounds => rounds::pass(program),
        Pass::Starting => starting::pass(program),
        Pass::Stays => stays::pass(program),
        Pass::Hoist => hoist::pass(program),
        Pass::Forward => forward::pass(program),
        Pass::Before => before::pass(program),
        Pass::Shown => shown::pass(program),
        Pass::Begun => begun::pass(program),
        Pass::Anew => anew::pass(program),
        Pass::Dead => dead::pass(program),
        Pass::Once => once::pass(program),
        Pass::Equal => equal::pass(program),
        Pass::Store => store::pass(program),
        Pass::Tables => tables::pass(program),
        Pass::Next => next::pass(program),
        Pass::Passed => passed::pass(program),
        Pass::Records => records::pass(program),
        Pass::Working => working::pass(program),
        Pass::Numbers => numbers::pass(program),
        Pass::Kinds => kinds::pass(program),
        Pass::Nested => nested::pass(program),
        Pass::United => united::pass(program),
        Pass::Arms => arms::pass(program),
        Pass::Direct => direct::pass(program),
        Pass::Fences => fences::pass(program),
        Pass::Common => common::pass(program),
        Pass::Limits => limits::pass(program),
    }
}

/// Nobody observes.
/// A condition of which nothing is left to do is not asked.
fn without_empty(statements: &mut Vec<Statement<'_>>) {
    for block in statements.iter_mut().flat_map(edits::blocks_mut) {
        without_empty(block);
    }
    statements.retain(|statement| match statement {
        Statement::Part(_, body) => !body.is_empty(),
        Statement::If(condition, then, otherwise) => {
            !(then.is_empty() && otherwise.is_empty() && uses::is_pure(condition))
        }
        _ => true,
    });
}
