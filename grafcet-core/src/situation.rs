//! A situation as text. For the code that the macro generates.

use core::fmt::{Alignment, Formatter, Result, Write};

use crate::description::ActiveSteps;

/// Writes the names of the active steps, as in `Fill, Heat`, filled up as the format asks; `names` are those of all steps.
///
/// # Errors
/// What is written to takes no more.
pub fn write(
    situation: &impl ActiveSteps,
    names: impl Iterator<Item = &'static str> + Clone,
    f: &mut Formatter<'_>,
) -> Result {
    let active = names.enumerate().filter(|(step, _)| situation.is_active_at(*step));
    let characters = active.clone().map(|(_, name)| name.chars().count() + 2).sum::<usize>().saturating_sub(2);
    let missing = f.width().unwrap_or(0).saturating_sub(characters);
    let before = match f.align() {
        Some(Alignment::Right) => missing,
        Some(Alignment::Center) => missing / 2,
        Some(Alignment::Left) | None => 0,
    };
    let fill = f.fill();
    (0..before).try_for_each(|_| f.write_char(fill))?;
    let mut between = "";
    for (_, name) in active {
        f.write_str(between)?;
        f.write_str(name)?;
        between = ", ";
    }
    (before..missing).try_for_each(|_| f.write_char(fill))
}
