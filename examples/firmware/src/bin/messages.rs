//! An interrupt that hands a chart its inputs as messages, through a queue without locks.
//!
//! SysTick samples a light barrier every millisecond and queues each edge with its time. The loop runs one cycle for each
//! message: it is slower than a part in front of the barrier, and counts every one of them all the same. The emulated
//! board has no light barrier, so the interrupt computes what one would see.
#![no_std]
#![no_main]

use core::cell::Cell;
use core::fmt::Write;
use core::panic::PanicInfo;
use core::sync::atomic::{AtomicU32, Ordering};

use cortex_m::interrupt::{self, Mutex};
use cortex_m::peripheral::Peripherals;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_rt::{entry, exception};
use cortex_m_semihosting::{debug, hio};
use grafcet::grafcet;
use grafcet::heapless::spsc::{Producer, Queue};

grafcet! {
    /// Counts parts into boxes of three.
    sfc Packer {
        input part: bool;
        output full: bool;
        var parts: u8 = 0;

        initial step Free;
        step Part { P1 parts = parts + 1; }
        step Full { N full; P0 parts = 0; }

        Free -[part]-> Part;
        Part -[!part && parts < 3]-> Free;
        Part -[!part && parts >= 3]-> Full -[part]-> Part;
    }
}

/// What the interrupt tells the chart.
struct Edge {
    /// When, in ms of the interrupt's count.
    at: u32,
    /// Whether there is a part in front of the barrier now.
    part: bool,
}

/// Room for seven edges: more than come while the loop turns once.
const EDGES: usize = 8;

/// The interrupt's end of the queue, until the interrupt has taken it.
static HANDED_OVER: Mutex<Cell<Option<Producer<'static, Edge, EDGES>>>> = Mutex::new(Cell::new(None));

/// How many milliseconds the interrupt has counted.
static MS: AtomicU32 = AtomicU32::new(0);

const CLOCK_HZ: u32 = 12_000_000;

/// A part every 20 ms, and in front of the barrier for 5 ms.
fn barrier(ms: u32) -> bool {
    ms % 20 < 5
}

#[exception]
fn SysTick() {
    static mut EDGES_OUT: Option<Producer<'static, Edge, EDGES>> = None;
    static mut SEEN: bool = false;

    if EDGES_OUT.is_none() {
        *EDGES_OUT = interrupt::free(|cs| HANDED_OVER.borrow(cs).take());
    }
    let Some(edges) = EDGES_OUT else { return };
    let at = MS.load(Ordering::Relaxed);
    let part = barrier(at);
    if part != *SEEN && edges.enqueue(Edge { at, part }).is_ok() {
        // A full queue gets the edge a millisecond later.
        *SEEN = part;
    }
    MS.store(at.wrapping_add(1), Ordering::Relaxed);
}

#[entry]
fn main() -> ! {
    finish(run())
}

fn run() -> Result<(), ()> {
    let mut console = hio::hstdout()?;
    let queue = cortex_m::singleton!(: Queue<Edge, EDGES> = Queue::new()).ok_or(())?;
    let (edges_out, mut edges) = queue.split();
    interrupt::free(|cs| HANDED_OVER.borrow(cs).set(Some(edges_out)));
    start_ticking()?;

    let mut packer = Packer::new();
    // The first cycle enters the initial step; only then there is something to tell the chart.
    packer.cycle(&PackerInputs::default());
    let (mut parts, mut boxes) = (0, 0);
    while boxes < 4 {
        while let Some(Edge { at, part }) = edges.dequeue() {
            let outputs = packer.cycle(&PackerInputs { part });
            parts += u32::from(part);
            if outputs.full {
                boxes += 1;
                writeln!(console, "{at} ms: box {boxes} is full, {parts} parts").map_err(drop)?;
            }
        }
        something_else();
    }
    Ok(())
}

/// What else the program does takes 30 ms: three edges come meanwhile.
fn something_else() {
    let begin = MS.load(Ordering::Relaxed);
    while MS.load(Ordering::Relaxed).wrapping_sub(begin) < 30 {
        cortex_m::asm::wfi();
    }
}

/// SysTick every millisecond.
fn start_ticking() -> Result<(), ()> {
    let mut clock = Peripherals::take().ok_or(())?.SYST;
    clock.set_clock_source(SystClkSource::Core);
    clock.set_reload(CLOCK_HZ / 1000 - 1);
    clock.clear_current();
    clock.enable_interrupt();
    clock.enable_counter();
    Ok(())
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
