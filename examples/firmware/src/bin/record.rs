//! The flight recorder over a reset: the cell runs its script, the program panics in the middle of it and resets the board; the next start finds the record in memory that nobody
//! initialises, and sends it out as lines of hexadecimal digits. `cargo xtask record` reads them on the host.
#![no_std]
#![no_main]

use core::fmt::Write;
use core::panic::PanicInfo;
use core::ptr::{addr_of_mut, read_volatile, write_volatile};

use cortex_m::peripheral::SCB;
use cortex_m_semihosting::{debug, hio};
use grafcet::record::{Recorder, Records};
use grafcet_firmware::cell::Cell;
use grafcet_firmware::script::{self, Notes};

/// In this cycle of the script the program panics: the emergency stop has just been pressed.
const LAST: u32 = 15;

/// The time of a cycle.
const CYCLE: u32 = 10;

/// The bytes of the record.
const BYTES: usize = 512;

/// The linker script keeps this section out of what the start of the program initialises.
#[allow(unsafe_code, reason = "a section is named, whose addresses the linker script of cortex-m-rt gives")]
#[unsafe(link_section = ".uninit.record")]
static mut MEMORY: [u8; BYTES] = [0; BYTES];

/// The memory of the record, with what the last run of the program has left in it.
#[allow(unsafe_code, reason = "see below")]
fn memory() -> &'static mut [u8; BYTES] {
    // SAFETY: called once, in `main`, so nobody else has a reference. Any byte is a valid `u8`; each is read and written in a way that the compiler cannot see
    // through, so that it does not take the bytes for the zeros above.
    unsafe {
        let memory = addr_of_mut!(MEMORY);
        for index in 0..BYTES {
            let byte = memory.cast::<u8>().add(index);
            write_volatile(byte, read_volatile(byte));
        }
        &mut *memory
    }
}

#[cortex_m_rt::entry]
fn main() -> ! {
    let memory = memory();
    let result = if Records::of(memory).is_ok_and(|records| records.check::<Cell>().is_ok()) {
        send(memory)
    } else {
        work(memory)
    };
    debug::exit(if result.is_ok() { debug::EXIT_SUCCESS } else { debug::EXIT_FAILURE });
    loop {
        cortex_m::asm::wfi();
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
fn work(memory: &'static mut [u8]) -> Result<(), ()> {
    let mut console = hio::hstdout()?;
    let mut cell = Recorder::new(Cell::new(), memory).map_err(drop)?;
    let mut number = 0;
    let script = include_str!("../../../charts/cell.script");
    let played = script::play(script, &mut console, |inputs, _| {
        let outputs = cell.cycle(inputs, number * CYCLE, &mut ());
        assert_ne!(number, LAST, "the program fails");
        number += 1;
        (outputs, cell.chart().active_steps(), Notes::new())
    });
    played.map_err(drop)
}

/// The board begins anew, as after its watchdog.
#[panic_handler]
fn panicked(_: &PanicInfo<'_>) -> ! {
    SCB::sys_reset()
}
