//! Plays charts, prints each that shows something else than its file expects, and ends the emulator, with a failure where there is one.

use core::fmt::Write;
use core::panic::PanicInfo;

use cortex_m_semihosting::{debug, hio};

/// A chart's name and its timeline, which answers with the first line that shows something else.
pub(crate) type Chart = (&'static str, fn() -> Result<(), u32>);

/// Plays all of them.
pub(crate) fn all(charts: &[Chart]) -> ! {
    finish(play(charts))
}

fn play(charts: &[Chart]) -> Result<(), ()> {
    let mut console = hio::hstdout()?;
    let mut failed = 0;
    for (name, play) in charts {
        if let Err(line) = play() {
            failed += 1;
            writeln!(console, "{name}: line {line} shows something else").map_err(drop)?;
        }
    }
    writeln!(console, "{} charts, {failed} failed", charts.len()).map_err(drop)?;
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
