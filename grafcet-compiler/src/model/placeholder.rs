//! The identifiers that stand in a user's expression for what is not Rust: `Off.X`, `5s/Heat`, `rising(a)`, `5s`.

use proc_macro2::{Ident, Span};

use super::{Blink, Blinker, Id, Read, TimeRef};

/// The placeholder of `read`, located at the user's tokens and invisible to them.
/// `None` for a declared name, which stands for itself.
#[must_use]
pub fn ident(read: Read, at: Span) -> Option<Ident> {
    let name = match read {
        // A name stands for itself, and no code is made of a property.
        Read::Name(_) | Read::Memory(_) => return None,
        Read::Active(step) => format!("active_{}", step.index()),
        Read::Since(step) => format!("since_{}", step.index()),
        Read::MacroActive(id) => format!("macro_active_{}", id.index()),
        Read::MacroSince(id) => format!("macro_since_{}", id.index()),
        Read::Rising(edge) => format!("rising_{}", edge.index()),
        Read::Falling(edge) => format!("falling_{}", edge.index()),
        Read::Delay(delay) => format!("delay_{}", delay.index()),
        Read::Ticks(ticks) => format!("ticks_{ticks}"),
        Read::Elapsed(time, step) => format!("elapsed_{}_{}", time_name(time), step.index()),
        Read::MacroElapsed(time, id) => format!("macro_elapsed_{}_{}", time_name(time), id.index()),
        Read::Blink(Blink { of, on, off }) => match of {
            Blinker::Step(step) => format!("blink_{on}_{off}_{}", step.index()),
            Blinker::Macro(id) => format!("macro_blink_{on}_{off}_{}", id.index()),
        },
    };
    // It is bound like a local of the generated code, so it ends as all of these do.
    Some(Ident::new(&format!("{name}_"), Span::mixed_site().located_at(at)))
}

fn time_name(time: TimeRef) -> String {
    match time {
        TimeRef::Ticks(ticks) => ticks.to_string(),
        TimeRef::Param(id) => format!("param_{}", id.index()),
        TimeRef::Var(id) => format!("var_{}", id.index()),
    }
}
