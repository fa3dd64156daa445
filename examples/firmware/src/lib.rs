//! The example charts without a target: what every board runs.
#![no_std]

use core::fmt::Write;

#[path = "../../charts/branch_on_result.rs"]
pub mod branch_on_result;
#[path = "../../charts/cell.rs"]
pub mod cell;
// The queue of its messages: heapless 0.8 has it for a RISC-V without atomic instructions only with `portable-atomic`.
#[cfg(not(target_arch = "riscv32"))]
#[path = "../../charts/controller.rs"]
pub mod controller;
#[path = "../../charts/line24v.rs"]
pub mod line24v;
#[path = "../../charts/motor.rs"]
pub mod motor;
#[path = "../../charts/pick_and_place.rs"]
pub mod pick_and_place;
#[path = "../../charts/recipe.rs"]
pub mod recipe;
#[cfg(any(feature = "roots", feature = "record"))]
pub mod roots;
#[path = "../../charts/script.rs"]
pub mod script;
#[path = "../../charts/stroke.rs"]
pub mod stroke;
#[path = "../../charts/tickless.rs"]
pub mod tickless;

use script::PlayError;

/// Plays the scripts of the examples, each below a line `# name`.
///
/// # Errors
/// What ended a script, an unknown input or a failing `out`; later ones are not played.
pub fn play_all(out: &mut dyn Write) -> Result<(), PlayError<'static>> {
    macro_rules! play {
        ($($example:ident),+) => {$(
            out.write_str(concat!("# ", stringify!($example), "\n"))?;
            $example::play(include_str!(concat!("../../charts/", stringify!($example), ".script")), out)?;
        )+};
    }
    play!(motor, line24v, recipe, branch_on_result, cell, tickless, stroke, pick_and_place);
    #[cfg(not(target_arch = "riscv32"))]
    play!(controller);
    Ok(())
}
