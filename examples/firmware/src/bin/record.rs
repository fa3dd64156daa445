//! The flight recorder over resets: the cell runs its script, the program fails in the middle of it, and the board begins anew; the next start finds the record in memory that nobody
//! initialises, and sends it out as lines of hexadecimal digits. It fails twice: the first time it panics, the second time it hangs, and the board's watchdog resets it. While it runs, the same record
//! goes out over the serial line, frame by frame. `cargo xtask record` reads both on the host.
#![no_std]
#![no_main]

use core::convert::Infallible;
use core::fmt::Write;
use core::panic::PanicInfo;
use core::ptr::{addr_of_mut, read_volatile, write_volatile};

use cortex_m::peripheral::SCB;
use cortex_m_semihosting::{debug, hio};
use grafcet::record::wire::{Wire, wire_len};
use grafcet::record::{Recorder, Records};
use grafcet_firmware::cell::Cell;
use grafcet_firmware::script::{self, Notes};

/// In this cycle of the script the program fails: the emergency stop has just been pressed.
const LAST: u32 = 15;

/// The time of a cycle.
const CYCLE: u32 = 10;

/// The bytes of the record.
const BYTES: usize = 512;

/// What outlives a reset.
struct Left {
    record: [u8; BYTES],
    /// How many times the program has failed, where this is [`FAILED`] plus a small number.
    failed: u32,
}

/// Memory that nobody has written holds something else.
const FAILED: u32 = 0x6ca1_ce70;

/// The linker script keeps this section out of what the start of the program initialises.
#[allow(unsafe_code, reason = "a section is named, whose addresses the linker script of cortex-m-rt gives")]
#[unsafe(link_section = ".uninit.record")]
static mut LEFT: Left = Left { record: [0; BYTES], failed: 0 };

/// That memory, with what the last run of the program has left in it.
#[allow(unsafe_code, reason = "see below")]
fn left() -> &'static mut Left {
    // SAFETY: called once, in `main`, so nobody else has a reference. Any bytes are a valid `Left`; each is read and written in a way that the compiler cannot see
    // through, so that it does not take the bytes for the zeros above.
    unsafe {
        let left = addr_of_mut!(LEFT);
        for index in 0..size_of::<Left>() {
            let byte = left.cast::<u8>().add(index);
            write_volatile(byte, read_volatile(byte));
        }
        &mut *left
    }
}

#[cortex_m_rt::entry]
fn main() -> ! {
    let left = left();
    let result = run(left);
    debug::exit(if result.is_ok() { debug::EXIT_SUCCESS } else { debug::EXIT_FAILURE });
    loop {
        cortex_m::asm::wfi();
    }
}

fn run(left: &'static mut Left) -> Result<(), ()> {
    let is_whole = Records::of(&left.record).is_ok_and(|records| records.check::<Cell>().is_ok());
    let failed = if is_whole { left.failed.wrapping_sub(FAILED) } else { 0 };
    if failed > 0 {
        send(&left.record)?;
    }
    left.failed = FAILED + failed + 1;
    match failed {
        0 => work(&mut left.record, "panic", || panic!("the program fails")),
        1 => {
            watchdog::start();
            work(&mut left.record, "watchdog", || {
                loop {
                    cortex_m::asm::nop();
                }
            })
        }
        _ => Ok(()),
    }
}

/// What the last run has left.
fn send(record: &[u8]) -> Result<(), ()> {
    let mut console = hio::hstdout()?;
    for line in record.chunks(32) {
        _ = console.write_str("record ");
        for byte in line {
            _ = write!(console, "{byte:02x}");
        }
        _ = console.write_str("\n");
    }
    Ok(())
}

/// The cell at work, until the program fails.
fn work(memory: &'static mut [u8], how: &str, fail: fn() -> !) -> Result<(), ()> {
    let mut console = hio::hstdout()?;
    writeln!(console, "# {how}").map_err(drop)?;
    let wire = Wire::new(Serial, [0; wire_len::<Cell>()]);
    let mut cell = Recorder::both(Cell::new(), memory, wire).map_err(drop)?;
    let mut number = 0;
    let script = include_str!("../../../charts/cell.script");
    let played = script::play(script, &mut console, |inputs, _| {
        watchdog::feed();
        let outputs = cell.cycle(inputs, number * CYCLE, &mut ());
        if number == LAST {
            fail();
        }
        number += 1;
        (outputs, cell.chart().active_steps(), Notes::new())
    });
    played.map_err(drop)
}

/// The first serial line of the board, which takes a byte at any time: the emulator is never slow.
struct Serial;

impl embedded_io::ErrorType for Serial {
    type Error = Infallible;
}

impl embedded_io::Write for Serial {
    #[allow(unsafe_code, reason = "the data register of the serial line, which nothing else uses")]
    fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
        const DATA: *mut u32 = 0x4000_c000 as *mut u32;
        for byte in bytes {
            // SAFETY: see above.
            unsafe { DATA.write_volatile(u32::from(*byte)) };
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

/// The board's watchdog.
mod watchdog {
    const LOAD: *mut u32 = 0x4000_0000 as *mut u32;
    const CONTROL: *mut u32 = 0x4000_0008 as *mut u32;
    /// Counts down and asks for an interrupt at zero; where nobody answers until it is there again, it resets the board.
    const COUNTS: u32 = 1;
    const RESETS: u32 = 2;
    /// 80 ms of the board's clock.
    const TICKS: u32 = 1_000_000;

    #[allow(unsafe_code, reason = "registers of the watchdog, which nothing else uses")]
    pub(super) fn start() {
        // SAFETY: see above.
        unsafe {
            LOAD.write_volatile(TICKS);
            CONTROL.write_volatile(COUNTS | RESETS);
        }
    }

    #[allow(unsafe_code, reason = "as above")]
    pub(super) fn feed() {
        // SAFETY: as above. It counts anew from what is written.
        unsafe { LOAD.write_volatile(TICKS) };
    }
}

/// The board begins anew.
#[panic_handler]
fn panicked(_: &PanicInfo<'_>) -> ! {
    SCB::sys_reset()
}
