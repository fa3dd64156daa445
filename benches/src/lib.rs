//! The same charts several times: generated, written by hand in Rust and in C, and with other crates. A build holds one of
//! them, chosen by its feature, under names that are the same in all.
//!
//! For each chart and dialect there is a root, a static that points to the cycle function and is exported as
//! `chart_dialect`. What the linker keeps for a root alone is what that cycle costs in flash.
#![no_std]

use core::mem::MaybeUninit;

#[macro_use]
mod signals;
#[cfg_attr(any(feature = "c", feature = "tables"), path = "c.rs")]
#[cfg_attr(feature = "flags", path = "flags.rs")]
#[cfg_attr(feature = "generated", path = "generated/mod.rs")]
#[cfg_attr(feature = "hand", path = "hand/mod.rs")]
#[cfg_attr(feature = "smlang", path = "smlang.rs")]
#[cfg_attr(feature = "statig", path = "statig.rs")]
// Of the charts in C some are tables.
#[cfg_attr(feature = "tables", allow(dead_code))]
mod implementation;

/// The cycle function of a chart, as its language writes it: Rust returns the outputs, C writes them where it is told.
#[cfg(not(any(feature = "c", feature = "tables")))]
pub type Cycle<C, I, O> = fn(&mut C, &I) -> O;
/// The cycle function of a chart, as its language writes it: Rust returns the outputs, C writes them where it is told.
#[cfg(any(feature = "c", feature = "tables"))]
pub type Cycle<C, I, O> = unsafe extern "C" fn(&mut C, &I, &mut O);

/// The cycle function of a chart that uses time.
#[cfg(not(any(feature = "c", feature = "tables")))]
pub type TimedCycle<C, I, O> = fn(&mut C, &I, u32) -> O;
/// The cycle function of a chart that uses time.
#[cfg(any(feature = "c", feature = "tables"))]
pub type TimedCycle<C, I, O> = unsafe extern "C" fn(&mut C, &I, u32, &mut O);

/// A cycle function of whatever shape.
pub trait Function<C, I, O>: Copy {
    /// The same of outputs that nobody reads: it makes no claim about what the function returns.
    type Unread: Function<C, I, MaybeUninit<O>>;

    /// Calls it; a chart without time is not told of it.
    fn call(self, chart: &mut C, inputs: &I, now: u32, outputs: &mut O);
}

impl<C, I, O> Function<C, I, O> for Cycle<C, I, O> {
    type Unread = Cycle<C, I, MaybeUninit<O>>;

    #[inline(always)]
    fn call(self, chart: &mut C, inputs: &I, _: u32, outputs: &mut O) {
        #[cfg(not(any(feature = "c", feature = "tables")))]
        {
            *outputs = self(chart, inputs);
        }
        // SAFETY: the functions in `benches/c` keep to their types.
        #[cfg(any(feature = "c", feature = "tables"))]
        unsafe {
            self(chart, inputs, outputs);
        }
    }
}

impl<C, I, O> Function<C, I, O> for TimedCycle<C, I, O> {
    type Unread = TimedCycle<C, I, MaybeUninit<O>>;

    #[inline(always)]
    fn call(self, chart: &mut C, inputs: &I, now: u32, outputs: &mut O) {
        #[cfg(not(any(feature = "c", feature = "tables")))]
        {
            *outputs = self(chart, inputs, now);
        }
        // SAFETY: as above.
        #[cfg(any(feature = "c", feature = "tables"))]
        unsafe {
            self(chart, inputs, now, outputs);
        }
    }
}

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
    /// Hands the value of each output to `see`, in their order.
    fn each(&self, see: &mut impl FnMut(u32));
}

/// A chart of one dialect with all it takes to run it.
pub struct Bench<C: 'static, F: 'static> {
    pub chart: &'static str,
    pub dialect: &'static str,
    pub new: fn() -> C,
    pub cycle: &'static F,
    pub is_stable: fn(&C) -> bool,
}

/// Does something with every chart.
pub trait Visitor {
    fn visit<C, I: Inputs, O: Outputs, F: Function<C, I, O>>(&mut self, bench: &Bench<C, F>);
}

/// The charts of one build: their names, the shapes of their functions, their dialects.
macro_rules! benches {
    ($($chart:ident: $function:ident $($dialect:ident)*;)*) => {
        $(#[cfg(any(every_chart, $chart))]
        pub mod $chart {
            $(pub mod $dialect {
                use crate::implementation::$chart::$dialect::{CYCLE, Chart, ChartInputs, ChartOutputs};

                /// What the linker starts from.
                #[unsafe(export_name = concat!(stringify!($chart), "_", stringify!($dialect)))]
                pub static ROOT: crate::$function<Chart, ChartInputs, ChartOutputs> = CYCLE;

                pub(crate) fn visit(visitor: &mut impl crate::Visitor) {
                    let bench = crate::Bench {
                        chart: stringify!($chart),
                        dialect: stringify!($dialect),
                        new: Chart::new,
                        cycle: &ROOT,
                        is_stable: benches!(@is_stable $dialect),
                    };
                    visitor.visit::<_, ChartInputs, ChartOutputs, _>(&bench);
                }
            })*
        })*

        /// Shows all charts to a visitor.
        pub fn visit(visitor: &mut impl crate::Visitor) {
            $(#[cfg(any(every_chart, $chart))]
            {
                $($chart::$dialect::visit(visitor);)*
            })*
        }
    };
    (@is_stable sfc) => { |_| true };
    (@is_stable grafcet) => { Chart::is_stable };
}

#[cfg(feature = "generated")]
benches! {
    motor: Cycle sfc grafcet;
    line24v: Cycle sfc grafcet;
    seq4: Cycle sfc grafcet;
    seq16: Cycle sfc grafcet;
    seq64: Cycle sfc grafcet;
    seq64_size: Cycle sfc grafcet;
    chain10: Cycle sfc grafcet;
    chain100: Cycle sfc grafcet;
    chain100_size: Cycle sfc grafcet;
    chain100_flags: Cycle sfc grafcet;
    chain1000: Cycle sfc grafcet;
    par8: Cycle sfc grafcet;
    par16: Cycle sfc grafcet;
    selection: Cycle sfc grafcet;
    washer: Cycle sfc grafcet;
    crossing: TimedCycle sfc grafcet;
    mixed: TimedCycle sfc grafcet;
    cell: Cycle grafcet;
    laundry: TimedCycle sfc grafcet;
    plating: TimedCycle sfc grafcet;
    plating_size: TimedCycle sfc grafcet;
    reactor: TimedCycle sfc grafcet;
    packer: TimedCycle grafcet;
    picker: TimedCycle sfc grafcet;
    picker_size: TimedCycle sfc grafcet;
}

/// Charts that take the compiler long.
#[cfg(feature = "long")]
pub mod long {
    benches! {
        chain5000: Cycle sfc grafcet;
    }
}

/// Shows all charts to a visitor, those that take long after the others.
pub fn visit_all(visitor: &mut impl Visitor) {
    visit(visitor);
    #[cfg(feature = "long")]
    long::visit(visitor);
}

#[cfg(any(feature = "hand", feature = "c"))]
benches! {
    motor: Cycle sfc grafcet;
    line24v: Cycle sfc grafcet;
    seq4: Cycle sfc grafcet;
    seq16: Cycle sfc grafcet;
    seq64: Cycle sfc grafcet;
    chain10: Cycle sfc grafcet;
    chain100: Cycle sfc grafcet;
    chain1000: Cycle sfc grafcet;
    par8: Cycle sfc grafcet;
    selection: Cycle sfc grafcet;
    washer: Cycle sfc grafcet;
    crossing: TimedCycle sfc grafcet;
    mixed: TimedCycle sfc grafcet;
    cell: Cycle grafcet;
    laundry: TimedCycle sfc grafcet;
    plating: TimedCycle sfc grafcet;
    reactor: TimedCycle sfc grafcet;
    packer: TimedCycle grafcet;
    picker: TimedCycle sfc grafcet;
}

// One event, one transition: what these crates do in a cycle is what an `sfc` does.
#[cfg(any(feature = "smlang", feature = "statig"))]
benches! {
    motor: Cycle sfc;
    line24v: Cycle sfc;
    chain10: Cycle sfc;
    chain100: Cycle sfc;
    chain1000: Cycle sfc;
    par8: Cycle sfc;
}

#[cfg(feature = "flags")]
benches! {
    chain100: Cycle sfc;
}

// What follows a rule.
#[cfg(feature = "tables")]
benches! {
    chain10: Cycle sfc grafcet;
    chain100: Cycle sfc grafcet;
    chain1000: Cycle sfc grafcet;
    par8: Cycle sfc grafcet;
}

/// A root that keeps nothing: the image all others are compared with.
#[unsafe(no_mangle)]
pub static nothing_root: u32 = 0;

/// A root that can panic: what looks for such has to find it.
#[unsafe(no_mangle)]
pub static panic_root: fn(&[u8], usize) -> u8 = |bytes, place| bytes[place];

/// A root that keeps the description of a chart: what looks for such has to find it.
#[cfg(all(feature = "generated", every_chart))]
#[unsafe(no_mangle)]
pub static description_root: &grafcet::description::Description<'static> = &implementation::mixed::sfc::Chart::CHART;

#[cfg(target_os = "none")]
#[panic_handler]
fn panicked(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
