//! What the generated modules name.

use core::fmt::Write as _;

pub(crate) use grafcet::{Chart, Forceable, Phase, Ticks};

/// The calls of one cycle as text: `first heat(80); `. More than fit are cut off, and then differ from what is expected.
#[derive(Default)]
pub(crate) struct Calls(grafcet::heapless::String<512>);

impl Calls {
    pub(crate) fn note(&mut self, phase: Phase, action: &str, args: &[i64]) {
        let phase = match phase {
            Phase::First => "first",
            Phase::Repeated => "repeated",
            Phase::Final => "final",
        };
        _ = write!(self.0, "{phase} {action}(");
        for (index, arg) in args.iter().enumerate() {
            _ = write!(self.0, "{}{arg}", if index > 0 { "," } else { "" });
        }
        _ = self.0.push_str("); ");
    }

    pub(crate) fn are(&self, expected: &str) -> bool {
        self.0 == expected
    }
}

/// Whether exactly these steps are active.
pub(crate) fn steps_are<C: Chart>(chart: &C, expected: &[C::Step]) -> bool {
    C::STEPS.iter().all(|step| chart.is_active(*step) == expected.contains(step))
}

/// An `sfc` is always stable; a chart that can say so says it itself.
pub(crate) trait Stable {
    fn is_stable(&self) -> bool {
        true
    }
}

impl<C: Chart> Stable for C {}
