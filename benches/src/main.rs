//! Counts the instructions of every chart on an emulated board and prints one line for each:
//! `chart dialect hash busy idle bytes`.
//!
//! `hash` is that of the outputs of [`CYCLES`] cycles on random inputs, `busy` the instructions of as many such cycles,
//! `idle` those of as many with all inputs false, `bytes` the size of the chart in RAM.
#![no_std]
#![no_main]

use core::fmt::Write;
use core::hint::black_box;
use core::mem::{MaybeUninit, transmute_copy};

use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_semihosting::debug;
use cortex_m_semihosting::hio::{self, HostStream};
use grafcet_benches::{Bench, Function, Inputs, Outputs, Visitor, visit};

/// Cycles per count.
const CYCLES: usize = 4096;

/// Different inputs; they come in rounds.
const INPUTS: usize = 256;

/// Milliseconds from one cycle to the next, as the charts with time are told.
const PERIOD: u32 = 100;

/// Emulated without counters of time, an instruction takes 1 ns (`-icount shift=0`) and a tick 5 ns.
const INSTRUCTIONS_PER_TICK: u32 = 5;

core::arch::global_asm!(".global bench_nothing", ".thumb_func", "bench_nothing: bx lr");
unsafe extern "C" {
    /// Returns at once: the instructions around a call, and one.
    fn bench_nothing();
}

#[cortex_m_rt::entry]
fn main() -> ! {
    let result = run();
    debug::exit(if result.is_some() { debug::EXIT_SUCCESS } else { debug::EXIT_FAILURE });
    loop {
        cortex_m::asm::wfi();
    }
}

fn run() -> Option<()> {
    let mut timer = cortex_m::Peripherals::take()?.SYST;
    fast_clock();
    timer.set_clock_source(SystClkSource::Core);
    timer.set_reload(0xff_ffff);
    timer.clear_current();
    timer.enable_counter();
    visit(&mut Counter { console: hio::hstdout().ok()? });
    Some(())
}

/// The shortest tick of the board, 200 MHz: it divides its clock by 16 after reset.
fn fast_clock() {
    const RCC: *mut u32 = 0x400f_e060 as *mut u32;
    const SYSDIV: u32 = 0xf << 23;
    const USESYSDIV: u32 = 1 << 22;
    // SAFETY: the board's register for the clock, which nothing else uses.
    unsafe { RCC.write_volatile(RCC.read_volatile() & !SYSDIV | USESYSDIV) }
}

struct Counter {
    console: HostStream,
}

impl Visitor for Counter {
    fn visit<C, I: Inputs, O: Outputs, F: Function<C, I, O>>(&mut self, bench: &Bench<C, F>) {
        let inputs = random::<I>();
        let hash = hash(bench, &inputs);
        let busy = instructions(bench, &inputs);
        let idle = instructions(bench, &[I::from_word(0); INPUTS]);
        let Bench { chart, dialect, .. } = bench;
        let line = writeln!(self.console, "{chart} {dialect} {hash:08x} {busy} {idle} {}", size_of::<C>());
        // Where the console fails, the lines are missing.
        _ = line;
    }
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

/// FNV-1a of the outputs, and whether each cycle was stable.
fn hash<C, I, O: Outputs, F: Function<C, I, O>>(bench: &Bench<C, F>, inputs: &[I]) -> u32 {
    let mut chart = (bench.new)();
    let mut outputs = O::default();
    let mut hash = 0x811c_9dc5_u32;
    let mut see = |value: u32| hash = (hash ^ value).wrapping_mul(0x0100_0193);
    let mut now = 0;
    for inputs in inputs.iter().cycle().take(CYCLES) {
        bench.cycle.call(&mut chart, inputs, now, &mut outputs);
        now += PERIOD;
        outputs.each(&mut see);
        see(u32::from((bench.is_stable)(&chart)));
    }
    hash
}

/// The instructions of [`CYCLES`] cycles, calls and returns included, what is around them not.
fn instructions<C, I, O, F: Function<C, I, O>>(bench: &Bench<C, F>, inputs: &[I]) -> u32 {
    let mut chart = (bench.new)();
    // SAFETY: `MaybeUninit<O>` is passed as `O` is, and makes no claim about what `bench_nothing` returns; that touches
    // no argument.
    let (cycle, nothing): (F::Unread, F::Unread) =
        unsafe { (transmute_copy(bench.cycle), transmute_copy(&(bench_nothing as unsafe extern "C" fn()))) };
    let all = ticks(black_box(cycle), &mut chart, inputs);
    let around = ticks(black_box(nothing), &mut chart, inputs);
    let returns = u32::try_from(CYCLES).unwrap_or(u32::MAX);
    (all - around) * INSTRUCTIONS_PER_TICK + returns
}

#[inline(never)]
fn ticks<C, I, O, F: Function<C, I, MaybeUninit<O>>>(cycle: F, chart: &mut C, inputs: &[I]) -> u32 {
    let mut outputs = MaybeUninit::uninit();
    let mut now = 0;
    let start = SYST::get_current();
    for _ in 0..CYCLES / INPUTS {
        for inputs in inputs {
            cycle.call(chart, inputs, now, &mut outputs);
            now += PERIOD;
            black_box(&mut outputs);
        }
    }
    // It counts down.
    start.wrapping_sub(SYST::get_current()) & 0xff_ffff
}
