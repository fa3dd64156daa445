//! The charts in C, in `benches/c`: their types and functions as Rust sees them.

macro_rules! dialects {
    ($($chart:ident: $($stored:ident)?;)*) => {
        $(pub mod $chart {
            pub mod sfc {
                pub use crate::signals::$chart::*;
                #[repr(C)]
                pub struct Chart { step: u8, $($stored: bool,)? }
                impl Chart {
                    /// The initial situation is all zero in C, as statics are.
                    pub fn new() -> Self { Self { step: 0, $($stored: false,)? } }
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
                pub struct Chart { step: u8, $($stored: bool,)? unstable: bool }
                impl Chart {
                    /// The initial situation is all zero in C, as statics are.
                    pub fn new() -> Self { Self { step: 0, $($stored: false,)? unstable: false } }
                    pub fn is_stable(&self) -> bool { !self.unstable }
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
    motor: ;
    line24v: q2;
    seq4: ;
    seq16: ;
    seq64: ;
    selection: ;
    washer: locked;
}
