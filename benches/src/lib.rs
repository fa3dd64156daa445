//! The same charts three times: generated, written by hand in Rust, and in C. A build holds one of the three, chosen by
//! its feature, under names that are the same in all.
//!
//! For each chart and dialect there is a root, a static that points to the cycle function and is exported as
//! `chart_dialect`. What the linker keeps for a root alone is what that cycle costs in flash.
#![no_std]

#[macro_use]
mod signals;
#[cfg(feature = "c")]
mod c;
#[cfg(feature = "generated")]
mod generated;
#[cfg(feature = "hand")]
mod hand;
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

/// Takes the lowest bit.
fn next_bit(bits: &mut u32) -> bool {
    let bit = *bits & 1 != 0;
    *bits >>= 1;
    bit
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
    ($($chart:ident)*) => {
        $(pub mod $chart {
            benches!(@dialect sfc $chart |_| true);
            benches!(@dialect grafcet $chart Chart::is_stable);
        })*

        /// Shows all charts to a visitor.
        pub fn visit(visitor: &mut impl Visitor) {
            $($chart::sfc::visit(visitor); $chart::grafcet::visit(visitor);)*
        }
    };
    (@dialect $dialect:ident $chart:ident $stable:expr) => {
        pub mod $dialect {
            use crate::implementation::$chart::$dialect::{CYCLE, Chart, ChartInputs, ChartOutputs};

            /// What the linker starts from.
            #[unsafe(export_name = concat!(stringify!($chart), "_", stringify!($dialect)))]
            pub static ROOT: crate::Cycle<Chart, ChartInputs, ChartOutputs> = CYCLE;

            pub(crate) fn visit(visitor: &mut impl crate::Visitor) {
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

benches!(motor line24v seq4 seq16 seq64 chain10 chain100 chain1000 par8 selection washer);

/// A root that keeps nothing: the image all others are compared with.
#[unsafe(no_mangle)]
pub static nothing_root: u32 = 0;

#[cfg(target_os = "none")]
#[panic_handler]
fn panicked(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
