//! The example charts without a target: what every board runs.
#![no_std]

use core::fmt::Write;

#[path = "../../charts/line24v.rs"]
pub mod line24v;
#[path = "../../charts/motor.rs"]
pub mod motor;
#[path = "../../charts/script.rs"]
pub mod script;

use script::PlayError;

/// Plays the scripts of the examples, each below a line `# name`.
///
/// # Errors
/// What ended a script, an unknown input or a failing `out`; later ones are not played.
pub fn play_all(out: &mut dyn Write) -> Result<(), PlayError<'static>> {
    out.write_str("# motor\n")?;
    motor::play(include_str!("../../charts/motor.script"), out)?;
    out.write_str("# line24v\n")?;
    line24v::play(include_str!("../../charts/line24v.script"), out)
}
