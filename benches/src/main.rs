//! Has the instructions of every chart counted, on an emulated board (`board.rs`) or on the host (`host.rs`): the same runs
//! on the same inputs, busy on random ones and idle with all of them false.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
mod board;
#[cfg(not(target_os = "none"))]
mod host;

use core::hint::black_box;
use core::mem::{MaybeUninit, transmute_copy};

use grafcet_benches::{Bench, Function, Inputs, Outputs};

/// Cycles per count.
const CYCLES: usize = 4096;

/// Different inputs; they come in rounds.
const INPUTS: usize = 256;

/// For so many cycles inputs are held.
const HELD: usize = 64;

/// Milliseconds from one cycle to the next, as the charts with time are told.
const PERIOD: u32 = 100;

unsafe extern "C" {
    /// Returns at once: the instructions around a call, and one.
    fn bench_nothing();
}

#[cfg(not(target_os = "none"))]
fn main() {
    host::run();
}

/// The same for every implementation: xorshift.
fn random<I: Inputs>() -> [I; INPUTS] {
    let mut state = 0x2545_f491_u32;
    [(); INPUTS].map(|()| {
        state ^= state << 13;
        state ^= state >> 17;
        state ^= state << 5;
        // The lowest bits of a xorshift are the poorest.
        I::from_word(state >> 7)
    })
}

/// All inputs false.
fn idle<I: Inputs>() -> [I; INPUTS] {
    [I::from_word(0); INPUTS]
}

/// FNV-1a of the outputs, and whether each cycle was stable: of inputs that change in every cycle, and of the same held for
/// so long that times pass.
fn hash<C, I, O: Outputs, F: Function<C, I, O>>(bench: &Bench<C, F>, inputs: &[I]) -> u32 {
    let mut chart = (bench.new)();
    let mut outputs = O::default();
    let mut hash = 0x811c_9dc5_u32;
    let mut see = |value: u32| hash = (hash ^ value).wrapping_mul(0x0100_0193);
    let mut now = 0;
    for (rounds, held) in [(CYCLES / INPUTS, 1), (1, HELD)] {
        for _ in 0..rounds {
            for inputs in inputs {
                for _ in 0..held {
                    bench.cycle.call(&mut chart, inputs, now, &mut outputs);
                    now += PERIOD;
                    outputs.each(&mut see);
                    see(u32::from((bench.is_stable)(&chart)));
                }
            }
        }
    }
    hash
}

/// Counts [`CYCLES`] cycles, and as many calls of what returns at once: what is more in the first count are the chart's
/// instructions, calls and returns included, but for one return a cycle.
fn counts<C, I, O, F: Function<C, I, O>, T>(
    bench: &Bench<C, F>,
    inputs: &[I],
    count: impl Fn(&mut dyn FnMut()) -> T,
) -> [T; 2] {
    let mut chart = (bench.new)();
    // SAFETY: `MaybeUninit<O>` is passed as `O` is, and makes no claim about what `bench_nothing` returns; that touches
    // no argument.
    let functions: [F::Unread; 2] =
        unsafe { [transmute_copy(bench.cycle), transmute_copy(&(bench_nothing as unsafe extern "C" fn()))] };
    functions.map(|function| count(&mut || cycles(black_box(function), &mut chart, inputs)))
}

#[inline(never)]
fn cycles<C, I, O, F: Function<C, I, MaybeUninit<O>>>(cycle: F, chart: &mut C, inputs: &[I]) {
    let mut outputs = MaybeUninit::uninit();
    let mut now = 0;
    for _ in 0..CYCLES / INPUTS {
        for inputs in inputs {
            cycle.call(chart, inputs, now, &mut outputs);
            now += PERIOD;
            black_box(&mut outputs);
        }
    }
}
