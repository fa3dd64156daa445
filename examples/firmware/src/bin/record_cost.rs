//! What the flight recorder costs on the emulated board: for each example the instructions of a cycle, alone and recorded, without and with a change of its inputs, and
//! with a change also sent as frames; and its RAM. `cargo xtask record cost` reads the lines `chart alone recorded alone recorded sent bytes`.
#![no_std]
#![no_main]

use core::convert::Infallible;
use core::fmt::Write;
use core::hint::black_box;
use core::panic::PanicInfo;

use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_semihosting::debug;
use cortex_m_semihosting::hio::{self, HostStream};
use grafcet::Ticks;
use grafcet::record::wire::Wire;
use grafcet::record::{Keep, Memory, Reader, Record, Recordable, Recorder, Writer};
use grafcet_firmware::roots::Idle;
use grafcet_firmware::{branch_on_result, cell, controller, line24v, motor, pick_and_place, recipe, stroke, tickless};

/// Cycles per count.
const CYCLES: u32 = 1000;

/// Emulated without counters of time, an instruction takes 1 ns (`-icount shift=0`) and a tick 5 ns.
const INSTRUCTIONS_PER_TICK: u32 = 5;

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
    let mut console = hio::hstdout().ok()?;
    measure(&mut console, "motor", &motor::Motor::new(), &mut ())?;
    measure(&mut console, "line24v", &line24v::Line24V::new(), &mut ())?;
    measure(&mut console, "branch_on_result", &branch_on_result::Sorter::new(), &mut ())?;
    measure(&mut console, "cell", &cell::Cell::new(), &mut ())?;
    measure(&mut console, "tickless", &tickless::Crossing::new(), &mut ())?;
    measure(&mut console, "stroke", &stroke::Press::new(), &mut ())?;
    measure(&mut console, "pick_and_place", &pick_and_place::PickAndPlace::new(), &mut ())?;
    measure(&mut console, "recipe", &recipe::Dyer::new(), &mut Idle)?;
    measure(&mut console, "controller", &controller::Called::new(), &mut Idle)
}

/// The shortest tick of the board, 200 MHz: it divides its clock by 16 after reset.
#[allow(unsafe_code, reason = "the board's register for the clock, which nothing else uses")]
fn fast_clock() {
    const RCC: *mut u32 = 0x400f_e060 as *mut u32;
    const SYSDIV: u32 = 0xf << 23;
    const USESYSDIV: u32 = 1 << 22;
    // SAFETY: see above.
    unsafe { RCC.write_volatile(RCC.read_volatile() & !SYSDIV | USESYSDIV) }
}

/// Inputs that differ in their first bit.
fn inputs<I: Record + Default>() -> Option<[I; 2]> {
    let mut bytes = [0; 64];
    I::default().write(&mut Writer::new(&mut bytes));
    *bytes.first_mut()? ^= 1;
    Some([I::default(), I::read(&mut Reader::new(&bytes))?])
}

fn measure<C: Recordable>(console: &mut HostStream, name: &str, chart: &C, actions: &mut C::Actions<'_>) -> Option<()> {
    let inputs = inputs::<C::Inputs>()?;
    let mut memory = [0; 1024];
    let mut figures = [0; 4];
    for (figures, which) in figures.chunks_exact_mut(2).zip([[0, 0], [0, 1]]) {
        let [one, other] = which.map(|place| &inputs[place]);
        let mut alone = chart.clone();
        let mut recorder = Recorder::new(chart.clone(), &mut memory[..]).ok()?;
        // Until it does nothing but repeat itself.
        for _ in 0..10 {
            _ = alone_cycle(&mut alone, one, actions);
            _ = recorded_cycle(&mut recorder, one, actions);
        }
        figures[0] = ticks(one, other, |inputs| _ = black_box(alone_cycle(&mut alone, inputs, actions)));
        figures[1] = ticks(one, other, |inputs| _ = black_box(recorded_cycle(&mut recorder, inputs, actions)));
    }
    let sent = sent(chart, [&inputs[0], &inputs[1]], actions)?;
    let [alone, recorded, alone_changed, recorded_changed] = figures;
    let bytes = size_of::<Recorder<C, Memory<&mut [u8]>>>() - size_of::<C>();
    writeln!(console, "{name} {alone} {recorded} {alone_changed} {recorded_changed} {sent} {bytes}").ok()
}

#[inline(never)]
fn alone_cycle<C: Recordable>(chart: &mut C, inputs: &C::Inputs, actions: &mut C::Actions<'_>) -> C::Outputs {
    chart.scan(inputs, Ticks::ZERO, actions)
}

#[inline(never)]
fn recorded_cycle<C: Recordable, K: Keep>(
    recorder: &mut Recorder<C, K>,
    inputs: &C::Inputs,
    actions: &mut C::Actions<'_>,
) -> C::Outputs {
    recorder.cycle(inputs, Ticks::ZERO, actions)
}

/// A line that takes all at once.
struct Line;

impl embedded_io::ErrorType for Line {
    type Error = Infallible;
}

impl embedded_io::Write for Line {
    fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
        Ok(black_box(bytes).len())
    }

    fn flush(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

/// The instructions of cycles with a change of which each is sent, with a hash after each sixteenth and a state in front of each 256th.
fn sent<C: Recordable>(chart: &C, [one, other]: [&C::Inputs; 2], actions: &mut C::Actions<'_>) -> Option<u32> {
    let mut buffer = [0; 1024];
    let mut recorder = Recorder::over(chart.clone(), Wire::new(Line, &mut buffer[..])).ok()?;
    for _ in 0..10 {
        _ = recorded_cycle(&mut recorder, one, actions);
    }
    Some(ticks(one, other, |inputs| _ = black_box(recorded_cycle(&mut recorder, inputs, actions))))
}

/// The instructions of so many cycles, with what is around them.
fn ticks<I>(one: &I, other: &I, mut cycle: impl FnMut(&I)) -> u32 {
    let start = SYST::get_current();
    for _ in 0..CYCLES / 2 {
        cycle(black_box(one));
        cycle(black_box(other));
    }
    // It counts down.
    (start.wrapping_sub(SYST::get_current()) & 0xff_ffff) * INSTRUCTIONS_PER_TICK
}

#[panic_handler]
fn panicked(_: &PanicInfo<'_>) -> ! {
    debug::exit(debug::EXIT_FAILURE);
    loop {}
}
