//! Facts about the model. Pure: no spans, no errors, no tokens.

pub mod circles;
pub mod combinational;
mod concurrency;
pub mod explore;
pub mod hierarchy;
mod logic;
mod pairs;
mod relation;
mod stability;
pub mod visible;

pub use concurrency::Concurrency;
pub use logic::{Answer, Condition, Logic};
pub use relation::Relation;
pub use stability::Stability;
