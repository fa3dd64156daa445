//! The charts in C, in `benches/c`: their types and functions as Rust sees them.

macro_rules! dialects {
    ($($chart:ident: $first:literal $($stored:ident)?;)*) => {
        $(pub mod $chart {
            pub mod sfc {
                pub use crate::signals::$chart::*;
                #[repr(C)]
                pub struct Chart { step: u8, $($stored: bool,)? }
                impl Chart {
                    /// `INIT`, behind the steps.
                    pub fn new() -> Self { Self { step: $first, $($stored: false,)? } }
                }
                unsafe extern "C" {
                    #[link_name = concat!(stringify!($chart), "_sfc_cycle")]
                    fn cycle(chart: &mut Chart, inputs: &ChartInputs, outputs: &mut ChartOutputs);
                }
                pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = cycle;
            }
            pub mod grafcet {
                pub use crate::signals::$chart::*;
                #[repr(C)]
                pub struct Chart { step: u8, $($stored: bool,)? stable: bool }
                impl Chart {
                    pub fn new() -> Self { Self { step: 0, $($stored: false,)? stable: true } }
                    pub fn is_stable(&self) -> bool { self.stable }
                }
                unsafe extern "C" {
                    #[link_name = concat!(stringify!($chart), "_grafcet_cycle")]
                    fn cycle(chart: &mut Chart, inputs: &ChartInputs, outputs: &mut ChartOutputs);
                }
                pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = cycle;
            }
        })*
    };
}

dialects! {
    motor: 2;
    line24v: 4 q2;
    seq4: 4;
    seq16: 16;
    seq64: 64;
    selection: 9;
    washer: 7 locked;
}
