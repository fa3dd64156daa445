//! Facts about the model. Pure: no spans, no errors, no tokens.

pub mod circles;
pub mod combinational;
mod concurrency;
mod differences;
pub mod explore;
mod facts;
pub mod hierarchy;
mod logic;
pub(crate) mod meeting;
mod mixed;
mod nesting;
mod numbers;
mod pairs;
mod races;
mod relation;
mod stability;
mod terms;
mod union;
mod unlisted;
pub mod visible;

pub use concurrency::Concurrency;
pub use facts::Facts;
pub use logic::{Answer, Condition, Logic};
pub use mixed::mixed;
pub use nesting::Nesting;
pub use races::{Meet, Races, Writer};
pub use relation::Relation;
pub use stability::{Ends, Stability, is_constant_read};
pub use union::Union;
pub(crate) use unlisted::{Unlisted, unlisted, unlisted_of};
