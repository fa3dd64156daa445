//! The charts in C, in `benches/c`: their types and functions as Rust sees them.

macro_rules! dialects {
    ($($chart:ident: $step:ident $first:literal $($stored:ident)?;)*) => {
        $(pub mod $chart {
            pub mod sfc {
                pub use crate::signals::$chart::*;
                #[repr(C)]
                pub struct Chart { step: $step, $($stored: bool,)? }
                impl Chart {
                    /// `INIT`, after the steps.
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
                pub struct Chart { step: $step, $($stored: bool,)? stable: bool }
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
    motor: u8 2;
    line24v: u8 4 q2;
    seq4: u8 4;
    seq16: u8 16;
    seq64: u8 64;
    chain10: u8 10;
    chain100: u8 100;
    chain1000: u16 1000;
    selection: u8 9;
    washer: u8 7 locked;
}

/// Its state in both dialects is one for the forks and one for each branch.
pub mod par8 {
    pub mod sfc {
        pub use crate::signals::par8::*;
        #[repr(C)]
        pub struct Chart {
            main: u8,
            branches: [u8; 8],
        }
        impl Chart {
            pub fn new() -> Self {
                Self { main: 0, branches: [0; 8] }
            }
        }
        unsafe extern "C" {
            #[link_name = "par8_sfc_cycle"]
            fn cycle(chart: &mut Chart, inputs: &ChartInputs, outputs: &mut ChartOutputs);
        }
        pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = cycle;
    }
    pub mod grafcet {
        pub use crate::signals::par8::*;
        #[repr(C)]
        pub struct Chart {
            main: u8,
            branches: [u8; 8],
            stable: bool,
        }
        impl Chart {
            pub fn new() -> Self {
                Self { main: 1, branches: [0; 8], stable: true }
            }
            pub fn is_stable(&self) -> bool {
                self.stable
            }
        }
        unsafe extern "C" {
            #[link_name = "par8_grafcet_cycle"]
            fn cycle(chart: &mut Chart, inputs: &ChartInputs, outputs: &mut ChartOutputs);
        }
        pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = cycle;
    }
}

/// In both dialects the same.
pub mod crossing {
    #[repr(C)]
    pub struct State {
        since: u32,
        step: u8,
        wait: bool,
    }
    impl State {
        /// `INIT`, after the steps.
        const INITIAL: Self = Self { since: 0, step: 6, wait: false };
    }
    pub mod sfc {
        pub use super::State as Chart;
        pub use crate::signals::crossing::*;
        impl Chart {
            pub fn new() -> Self {
                Self::INITIAL
            }
            /// Its times end every search.
            pub fn is_stable(&self) -> bool {
                true
            }
        }
        unsafe extern "C" {
            #[link_name = "crossing_sfc_cycle"]
            fn cycle(chart: &mut Chart, inputs: &ChartInputs, now: u32, outputs: &mut ChartOutputs);
        }
        pub const CYCLE: crate::TimedCycle<Chart, ChartInputs, ChartOutputs> = cycle;
    }
    pub mod grafcet {
        pub use super::State as Chart;
        pub use crate::signals::crossing::*;
        unsafe extern "C" {
            #[link_name = "crossing_grafcet_cycle"]
            fn cycle(chart: &mut Chart, inputs: &ChartInputs, now: u32, outputs: &mut ChartOutputs);
        }
        pub const CYCLE: crate::TimedCycle<Chart, ChartInputs, ChartOutputs> = cycle;
    }
}

/// In both dialects the same but for the first step.
pub mod mixed {
    pub mod sfc {
        pub use crate::signals::mixed::*;
        #[repr(C)]
        pub struct Chart {
            since: [u32; 2],
            steps: [u8; 3],
            stored: [bool; 3],
        }
        impl Chart {
            /// `INIT`, after the steps.
            pub fn new() -> Self {
                Self { since: [0; 2], steps: [9, 0, 0], stored: [false; 3] }
            }
        }
        unsafe extern "C" {
            #[link_name = "mixed_sfc_cycle"]
            fn cycle(chart: &mut Chart, inputs: &ChartInputs, now: u32, outputs: &mut ChartOutputs);
        }
        pub const CYCLE: crate::TimedCycle<Chart, ChartInputs, ChartOutputs> = cycle;
    }
    pub mod grafcet {
        pub use crate::signals::mixed::*;
        #[repr(C)]
        pub struct Chart {
            since: [u32; 2],
            steps: [u8; 3],
            stored: [bool; 3],
        }
        impl Chart {
            pub fn new() -> Self {
                Self { since: [0; 2], steps: [0; 3], stored: [false; 3] }
            }
            /// Its times end every search.
            pub fn is_stable(&self) -> bool {
                true
            }
        }
        unsafe extern "C" {
            #[link_name = "mixed_grafcet_cycle"]
            fn cycle(chart: &mut Chart, inputs: &ChartInputs, now: u32, outputs: &mut ChartOutputs);
        }
        pub const CYCLE: crate::TimedCycle<Chart, ChartInputs, ChartOutputs> = cycle;
    }
}

pub mod cell {
    pub mod grafcet {
        pub use crate::signals::cell::*;
        #[repr(C)]
        pub struct Chart {
            parts: u16,
            steps: [u8; 5],
            clamp: bool,
            edges: [bool; 2],
        }
        impl Chart {
            /// The inputs of the edges are seen as on before the first cycle: there is no edge in it.
            pub fn new() -> Self {
                Self { parts: 0, steps: [0, 1, 0, 0, 0], clamp: false, edges: [true; 2] }
            }
            /// A part cannot be clamped and not clamped: every search ends.
            pub fn is_stable(&self) -> bool {
                true
            }
        }
        unsafe extern "C" {
            #[link_name = "cell_grafcet_cycle"]
            fn cycle(chart: &mut Chart, inputs: &ChartInputs, outputs: &mut ChartOutputs);
        }
        pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = cycle;
    }
}

/// The charts whose times end every search, as their C files declare them: the fields in their order, and what the two
/// dialects begin with. Who has one dialect alone leaves the other out.
macro_rules! timed {
    ($($chart:ident { $($field:ident: $type:ty = $value:expr,)* } $($dialect:ident $first:literal)+;)*) => {
        $(pub mod $chart {
            #[repr(C)]
            pub struct State { $($field: $type),* }
            impl State {
                fn new(step: u8) -> Self {
                    let mut state = Self { $($field: $value),* };
                    state.step = step;
                    state
                }
            }
            $(pub mod $dialect {
                pub use crate::signals::$chart::*;
                #[repr(transparent)]
                pub struct Chart(super::State);
                impl Chart {
                    pub fn new() -> Self { Self(super::State::new($first)) }
                    #[allow(dead_code)]
                    pub fn is_stable(&self) -> bool { true }
                }
                unsafe extern "C" {
                    #[link_name = concat!(stringify!($chart), "_", stringify!($dialect), "_cycle")]
                    fn cycle(chart: &mut Chart, inputs: &ChartInputs, now: u32, outputs: &mut ChartOutputs);
                }
                pub const CYCLE: crate::TimedCycle<Chart, ChartInputs, ChartOutputs> = cycle;
            })+
        })*
    };
}

timed! {
    laundry { since: u32 = 0, step: u8 = 0, turns: u8 = 0, rinses: u8 = 0, locked: bool = false, } sfc 25 grafcet 0;
    plating {
        since: u32 = 0, parts: u16 = 0, step: u8 = 0, dips: u8 = 0, tries: u8 = 0, grip: bool = false,
    } sfc 40 grafcet 0;
    reactor { since: u32 = 0, stirring_since: u32 = 0, step: u8 = 0, stirring: u8 = 5, } sfc 6 grafcet 0;
    picker { since: u32 = 0, step: u8 = 0, tries: u8 = 0, suck: bool = false, } sfc 16 grafcet 0;
    packer {
        taping_since: u32 = 0, moving_since: u32 = 0, cartons: u16 = 0, step: u8 = 0, outfeed: u8 = 0, bottles: u8 = 0,
        ack: bool = true, auto: bool = true,
    } grafcet 1;
}
