//! The example charts on a Cortex-M, with the host's console through semihosting: prints the plain lines of all scripts
//! and ends QEMU, with a failure where a script or the console fails or the program panics.
#![no_std]
#![no_main]

use core::fmt::Write;
use core::panic::PanicInfo;

use cortex_m_semihosting::{debug, hio};

#[cortex_m_rt::entry]
fn main() -> ! {
    finish(run())
}

fn run() -> Result<(), ()> {
    let mut console = hio::hstdout()?;
    grafcet_firmware::play_all(&mut console).map_err(|error| {
        // Where the console itself fails, the exit status says so.
        _ = writeln!(console, "{error}");
    })
}

#[panic_handler]
fn panicked(info: &PanicInfo<'_>) -> ! {
    if let Ok(mut console) = hio::hstderr() {
        _ = writeln!(console, "{info}");
    }
    finish(Err(()))
}

fn finish(result: Result<(), ()>) -> ! {
    debug::exit(if result.is_ok() { debug::EXIT_SUCCESS } else { debug::EXIT_FAILURE });
    loop {
        cortex_m::asm::wfi();
    }
}
