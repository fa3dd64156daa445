//! The suites that `cargo grafcet tests` has written of the examples, run with the compiled charts; one of them is that of a chart that asks its program, where a person has written
//! how it answers. `cargo-grafcet/tests/suite.rs` sees to it that they
//! are what it writes.

#![allow(
    dead_code,
    unreachable_pub,
    reason = "the examples can be played and are for others, too, which is not done here"
)]

#[path = "suites/program/asked.rs"]
mod asked;
#[path = "../examples/charts/branch_on_result.rs"]
mod branch_on_result;
#[path = "../examples/charts/cell.rs"]
mod cell;
#[path = "../examples/charts/line24v.rs"]
mod line24v;
#[path = "../examples/charts/motor.rs"]
mod motor;
#[path = "../examples/charts/pick_and_place.rs"]
mod pick_and_place;
#[path = "../examples/charts/recipe.rs"]
mod recipe;
#[path = "../examples/charts/script.rs"]
mod script;
#[path = "../examples/charts/stroke.rs"]
mod stroke;
#[path = "../examples/charts/tickless.rs"]
mod tickless;

#[rustfmt::skip]
#[path = "suites/asked.rs"]
mod suite_of_asked;
#[rustfmt::skip]
#[path = "suites/branch_on_result.rs"]
mod suite_of_branch_on_result;
#[rustfmt::skip]
#[path = "suites/cell.rs"]
mod suite_of_cell;
#[rustfmt::skip]
#[path = "suites/line24v.rs"]
mod suite_of_line24v;
#[rustfmt::skip]
#[path = "suites/motor.rs"]
mod suite_of_motor;
#[rustfmt::skip]
#[path = "suites/pick_and_place.rs"]
mod suite_of_pick_and_place;
#[rustfmt::skip]
#[path = "suites/recipe.rs"]
mod suite_of_recipe;
#[rustfmt::skip]
#[path = "suites/stroke.rs"]
mod suite_of_stroke;
#[rustfmt::skip]
#[path = "suites/tickless.rs"]
mod suite_of_tickless;
