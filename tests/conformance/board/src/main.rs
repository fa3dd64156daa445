//! The conformance corpus on a Cortex-M, with the host's console behind semihosting: prints each chart that shows something
//! else than its file expects, and ends QEMU, with a failure where there is one.
#![no_std]
#![no_main]

mod check;

use core::fmt::Write;
use core::panic::PanicInfo;

use cortex_m_semihosting::{debug, hio};

#[allow(warnings, clippy::all, clippy::pedantic, missing_docs, reason = "written by the build script")]
mod corpus {
    include!(concat!(env!("OUT_DIR"), "/corpus.rs"));
}

#[cortex_m_rt::entry]
fn main() -> ! {
    finish(run())
}

fn run() -> Result<(), ()> {
    let mut console = hio::hstdout()?;
    let mut failed = 0;
    for (name, play) in corpus::ALL {
        if let Err(line) = play() {
            failed += 1;
            writeln!(console, "{name}: line {line} shows something else").map_err(drop)?;
        }
    }
    writeln!(console, "{} charts, {failed} failed", corpus::ALL.len()).map_err(drop)?;
    if failed == 0 { Ok(()) } else { Err(()) }
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
