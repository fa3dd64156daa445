// A type that `serde` cannot write.
use grafcet::recordable;
use serde::Serialize;

#[derive(Clone, Copy, Default, PartialEq, Serialize)]
pub struct Target {
    to: i16,
}

recordable! { Target as serde in 3 bytes }

fn main() {}
