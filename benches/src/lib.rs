//! The same charts three times: generated, written by hand in Rust, and in C. A build holds one of the three, chosen by
//! its feature, under names that are the same in all.
//!
//! For each chart and dialect there is a root, a static that points to the cycle function and is exported as
//! `chart_dialect`. What the linker keeps for a root alone is what that cycle costs in flash.
#![no_std]

#[cfg(feature = "c")]
mod c;
#[cfg(feature = "generated")]
mod generated;
#[cfg(feature = "hand")]
mod hand;
#[cfg(any(feature = "hand", feature = "c"))]
mod signals;

#[cfg(feature = "c")]
use c as implementation;
#[cfg(feature = "generated")]
use generated as implementation;
#[cfg(feature = "hand")]
use hand as implementation;

/// The cycle function as its language writes it: Rust returns the outputs, C writes them where it is told.
#[cfg(not(feature = "c"))]
pub type Cycle<C, I, O> = fn(&mut C, &I) -> O;
/// The cycle function as its language writes it: Rust returns the outputs, C writes them where it is told.
#[cfg(feature = "c")]
pub type Cycle<C, I, O> = unsafe extern "C" fn(&mut C, &I, &mut O);

/// Inputs that can be made of random bits.
pub trait Inputs: Copy {
    fn from_word(word: u32) -> Self;
}

/// Outputs that can be compared with those of another implementation.
pub trait Outputs: Copy + Default {
    fn to_word(&self) -> u32;
}

/// A chart of one dialect with all it takes to run it.
pub struct Bench<C: 'static, I: 'static, O: 'static> {
    pub chart: &'static str,
    pub dialect: &'static str,
    pub new: fn() -> C,
    pub cycle: &'static Cycle<C, I, O>,
    pub is_stable: fn(&C) -> bool,
}

/// Does something with every chart.
pub trait Visitor {
    fn visit<C, I: Inputs, O: Outputs>(&mut self, bench: &Bench<C, I, O>);
}

macro_rules! benches {
    ($($chart:ident: $($input:ident),* $({ $extra:ident: $value:expr })? => $($output:ident),*;)*) => {
        $(pub mod $chart {
            benches!(@dialect sfc $chart [$($input)*] [$($extra: $value)?] [$($output)*] |_| true);
            benches!(@dialect grafcet $chart [$($input)*] [$($extra: $value)?] [$($output)*] Chart::is_stable);
        })*

        /// Shows all charts to a visitor.
        pub fn visit(visitor: &mut impl Visitor) {
            $($chart::sfc::visit(visitor); $chart::grafcet::visit(visitor);)*
        }
    };
    (@dialect $dialect:ident $chart:ident [$($input:ident)*] [$($extra:ident: $value:expr)?] [$($output:ident)*]
        $stable:expr) => {
        pub mod $dialect {
            use crate::implementation::$chart::$dialect::{Chart, ChartInputs, ChartOutputs};

            /// What the linker starts from.
            #[unsafe(export_name = concat!(stringify!($chart), "_", stringify!($dialect)))]
            pub static ROOT: crate::Cycle<Chart, ChartInputs, ChartOutputs> =
                crate::implementation::$chart::$dialect::CYCLE;

            impl crate::Inputs for ChartInputs {
                fn from_word(word: u32) -> Self {
                    let mut bits = word;
                    $(let $input = bits & 1 != 0; bits >>= 1;)*
                    Self { $($input,)* $($extra: $value(bits))? }
                }
            }

            impl crate::Outputs for ChartOutputs {
                fn to_word(&self) -> u32 {
                    [$(self.$output),*].into_iter().fold(0, |word, bit| word << 1 | u32::from(bit))
                }
            }

            pub(super) fn visit(visitor: &mut impl crate::Visitor) {
                visitor.visit(&crate::Bench {
                    chart: stringify!($chart),
                    dialect: stringify!($dialect),
                    new: Chart::new,
                    cycle: &ROOT,
                    is_stable: $stable,
                });
            }
        }
    };
}

benches! {
    motor: on, off, over_temp => relay, green, red;
    line24v: b1, b2, b3, b4, b5 => q1, q2, q3;
    seq4: x0, x1, x2, x3 => q0, q1, q2, q3;
    seq16: x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11, x12, x13, x14, x15
        => q0, q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15;
    seq64: x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11, x12, x13, x14, x15
        => q0, q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15;
    selection: start, done { recipe: |bits| 1 + (bits % 8) as u8 }
        => ready, pump, v1, v2, v3, v4, v5, v6, v7, v8;
    washer: start, full, hot, washed, empty, again, spun
        => ready, locked, valve, heater, drum, pump, spin;
}

/// A root that keeps nothing: the image all others are compared with.
#[unsafe(no_mangle)]
pub static nothing_root: u32 = 0;

#[cfg(target_os = "none")]
#[panic_handler]
fn panicked(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
