//! A chart as an RTIC task. The task sleeps until the chart's next deadline, or until an interrupt hands it another
//! state of the button; nothing scans in between.
//!
//! On the emulated board nobody can press a button: a second task does it, by setting what a pin would read and pending
//! the interrupt of the port. What the chart switches is printed on the host's console.
#![no_std]
#![no_main]

use core::sync::atomic::{AtomicBool, Ordering};

use cortex_m_semihosting::{debug, hprintln};
use grafcet::grafcet;
use lm3s6965::Interrupt;
use panic_semihosting as _;
use rtic_monotonics::systick::prelude::*;
use rtic_sync::channel::{Receiver, Sender};
use rtic_sync::make_channel;

grafcet! {
    /// The light of a staircase: 30 s from the last press of a button, the last 5 s of them dimmed as a warning.
    sfc Staircase {
        // The unit of the monotonic below.
        clock 1ms;
        input button: bool;
        output light, dimmed: bool;

        initial step Dark;
        step Lit { N light; }
        step Warning { N light; N dimmed; }

        Dark -[rising(button)]-> Lit;
        // Left and entered at once, the step begins anew, and with it its time.
        Lit -[rising(button)]-> Lit;
        Lit -[25s/Lit]-> Warning;
        Warning -[rising(button)]-> Lit;
        Warning -[5s/Warning]-> Dark;
    }
}

systick_monotonic!(Mono, 1_000);

/// Edges of the button that the chart has not seen yet: four are two presses within one cycle.
const EDGES: usize = 4;

/// What the pin of the button reads.
static PIN: AtomicBool = AtomicBool::new(false);

/// Here a controller would switch its lamps.
fn write_pins(ms: u32, step: StaircaseStep, StaircaseOutputs { light, dimmed }: StaircaseOutputs) {
    hprintln!("{}.{} s {:?} {} {}", ms / 1000, ms / 100 % 10, step, light, dimmed);
}

#[rtic::app(device = lm3s6965, dispatchers = [UART0])]
mod app {
    use super::*;

    #[shared]
    struct Shared {}

    #[local]
    struct Local {
        edges: Sender<'static, bool, EDGES>,
    }

    #[init]
    fn init(cx: init::Context) -> (Shared, Local) {
        Mono::start(cx.core.SYST, 12_000_000);
        let (edges, received) = make_channel!(bool, EDGES);
        // Each task is spawned once, so there is room for it.
        _ = staircase::spawn(received);
        _ = visitor::spawn();
        (Shared {}, Local { edges })
    }

    /// The core sleeps whenever no task has anything to do.
    #[idle]
    fn idle(_: idle::Context) -> ! {
        loop {
            cortex_m::asm::wfi();
        }
    }

    /// Both edges of the button.
    #[task(binds = GPIOA, priority = 2, local = [edges])]
    fn button(cx: button::Context) {
        if cx.local.edges.try_send(PIN.load(Ordering::Relaxed)).is_err() {
            hprintln!("an edge is lost");
        }
    }

    #[task(priority = 1)]
    async fn staircase(_: staircase::Context, mut edges: Receiver<'static, bool, EDGES>) {
        let mut chart = Staircase::new();
        let mut inputs = StaircaseInputs::default();
        let mut written = None;
        loop {
            let now = Mono::now();
            let outputs = chart.cycle(&inputs, now);
            if written.replace(outputs) != Some(outputs) {
                write_pins(now.as_ticks(), chart.situation(), outputs);
            }
            // Without a deadline only an input can change something.
            let edge = match chart.next_deadline() {
                Some(deadline) => {
                    let rest = deadline.since(now.into()).get();
                    Mono::timeout_at(now + rest.millis(), edges.recv()).await.ok()
                }
                None => Some(edges.recv().await),
            };
            if let Some(Ok(button)) = edge {
                inputs.button = button;
            }
        }
    }

    /// Presses the button, and ends the emulator when the light has gone out again.
    #[task(priority = 1)]
    async fn visitor(_: visitor::Context) {
        let start = Mono::now();
        for press in [1_000, 20_000, 47_000] {
            for (at, level) in [(press, true), (press + 200, false)] {
                Mono::delay_until(start + at.millis()).await;
                PIN.store(level, Ordering::Relaxed);
                rtic::pend(Interrupt::GPIOA);
            }
        }
        Mono::delay(35.secs()).await;
        debug::exit(debug::EXIT_SUCCESS);
    }
}
