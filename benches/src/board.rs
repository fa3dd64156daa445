//! Counts on an emulated board with its timer and prints one line for each chart: `chart dialect hash busy idle bytes`.
//!
//! `hash` is that of the outputs of [`CYCLES`] cycles on random inputs, `busy` the instructions of as many such cycles,
//! `idle` those of as many with all inputs false, `bytes` the size of the chart in RAM.

use core::fmt::Write;

use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_semihosting::debug;
use cortex_m_semihosting::hio::{self, HostStream};
use grafcet_benches::{Bench, Function, Inputs, Outputs, Visitor, visit_all};

use crate::{CYCLES, counts, hash, idle, random};

/// Emulated without counters of time, an instruction takes 1 ns (`-icount shift=0`) and a tick 5 ns.
const INSTRUCTIONS_PER_TICK: u32 = 5;

core::arch::global_asm!(".global bench_nothing", ".thumb_func", "bench_nothing: bx lr");

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
    visit_all(&mut Counter { console: hio::hstdout().ok()? });
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
        let busy = instructions(counts(bench, &inputs, ticks));
        let idle = instructions(counts(bench, &idle(), ticks));
        let Bench { chart, dialect, .. } = bench;
        let line = writeln!(self.console, "{chart} {dialect} {hash:08x} {busy} {idle} {}", size_of::<C>());
        // Where the console fails, the lines are missing.
        _ = line;
    }
}

/// The instructions of [`CYCLES`] cycles, calls and returns included, what is around them not.
fn instructions([all, around]: [u32; 2]) -> u32 {
    let returns = u32::try_from(CYCLES).unwrap_or(u32::MAX);
    (all - around) * INSTRUCTIONS_PER_TICK + returns
}

fn ticks(work: &mut dyn FnMut()) -> u32 {
    let start = SYST::get_current();
    work();
    // It counts down.
    start.wrapping_sub(SYST::get_current()) & 0xff_ffff
}
