//! What the artefacts of a chart ask of its state and its cycle, however these are made.

use proc_macro2::{Ident, TokenStream};

use super::program::Flags;
use super::state::StateEnum;
use crate::model::{StepId, Ty};
use crate::program::RegionId;

/// The state of a chart and the code of its cycle.
pub(super) struct Machine<'m> {
    /// The private types of the fields.
    pub(super) types: TokenStream,
    /// The regions whose states are enums.
    pub(super) regions: Vec<StateEnum>,
    /// `encoding flags;`: what is stored instead of them.
    pub(super) flags: Option<Flags>,
    /// What `new` writes, beside the recipe.
    pub(super) fields: Vec<Field>,
    /// The field with the clock's reading in the last cycle.
    pub(super) clock: Option<Ident>,
    /// The fields with readings at which times began: they say how much has elapsed, as seen from that.
    pub(super) began: Vec<Began>,
    /// The declared types among theirs: whether the chart is `Copy` depends on them.
    pub(super) stored: Vec<&'m Ty>,
    pub(super) cycle: TokenStream,
    /// The body of a cycle that leads into the situation that is asked for.
    pub(super) forced: Option<TokenStream>,
    /// By step: whether it is active.
    pub(super) active: Vec<TokenStream>,
    /// By step: the region whose state tells that, and the names of the states in which it is.
    pub(super) homes: Vec<(RegionId, Vec<StepId>)>,
    /// The body of `situation`.
    pub(super) situation: TokenStream,
    /// Whether the last search became stable.
    pub(super) stable: TokenStream,
    pub(super) deadline: Option<Deadline>,
    /// The steps that have a time, and what tells that it is over, where they are active.
    pub(super) late: Vec<(StepId, TokenStream)>,
    /// The values of the stored variables.
    pub(super) vars: Vec<TokenStream>,
}

/// A field of the chart's struct.
pub(super) struct Field {
    pub(super) name: Ident,
    pub(super) ty: TokenStream,
    pub(super) initial: TokenStream,
    /// What its address is a multiple of, in bytes, where that is known; of `usize` a little more than 4, as it is 8 on some machines.
    pub(super) align: Option<u8>,
}

/// The parts of `next_deadline`.
pub(super) struct Deadline {
    /// Whether the next cycle is due at once.
    pub(super) at_once: TokenStream,
    /// Statements that find the soonest time.
    pub(super) waits: TokenStream,
    /// The reading of the clock in the last cycle, where the next one is due at once.
    pub(super) reading: TokenStream,
    /// The reading from which the times count; none where what has been found is a reading itself.
    pub(super) from: Option<TokenStream>,
}

/// A field with the reading at which a time began.
pub(super) struct Began {
    pub(super) name: Ident,
    /// Whether anything is still to come of that time. Where nothing is, the field may hold whatever it was left with, or any time that is long enough.
    pub(super) awaited: TokenStream,
    /// The longest that it is compared with, in ticks.
    pub(super) longest: u32,
}
