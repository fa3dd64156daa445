//! A chart as an Embassy task. The task sleeps until the chart's next deadline, or until it is handed another state of the
//! button; nothing scans in between.
//!
//! On the emulated board nobody can press a button: a second task does it. What the chart switches is printed on the
//! host's console.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_semihosting::{debug, hprintln};
use embassy_executor::Spawner;
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::channel::Channel;
use embassy_time::{Duration, Instant, Timer, with_deadline};
use grafcet::grafcet;
use panic_semihosting as _;
use systick_timer::SystickDriver;

grafcet! {
    /// The light of a staircase: 30 s from the last press of a button, the last 5 s of them dimmed as a warning.
    sfc Staircase {
        // The unit of the time driver below.
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

/// Edges of the button that the chart has not seen yet: four are two presses within one cycle.
static EDGES: Channel<CriticalSectionRawMutex, bool, 4> = Channel::new();

// A controller with a HAL of Embassy has its time from there.
embassy_time_driver::time_driver_impl!(static DRIVER: SystickDriver<4> = SystickDriver::new_default(12_000_000));

#[cortex_m_rt::exception]
fn SysTick() {
    DRIVER.systick_interrupt();
}

/// Here a controller would switch its lamps.
fn write_pins(ms: u64, step: StaircaseStep, StaircaseOutputs { light, dimmed }: StaircaseOutputs) {
    hprintln!("{}.{} s {:?} {} {}", ms / 1000, ms / 100 % 10, step, light, dimmed);
}

#[embassy_executor::main]
async fn main(spawner: Spawner) {
    let mut peripherals = Peripherals::take().expect("nobody has taken them before");
    DRIVER.start(&mut peripherals.SYST);
    spawner.spawn(staircase().expect("spawned once"));
    visitor().await;
}

#[embassy_executor::task]
async fn staircase() {
    let mut chart = Staircase::new();
    let mut inputs = StaircaseInputs::default();
    let mut written = None;
    loop {
        let now = Instant::now();
        let outputs = chart.cycle(&inputs, now);
        if written.replace(outputs) != Some(outputs) {
            write_pins(now.as_millis(), chart.situation(), outputs);
        }
        // Without a deadline only an input can change something.
        let edge = match chart.next_deadline() {
            Some(deadline) => {
                let rest = Duration::from_millis(deadline.since(now.into()).get().into());
                with_deadline(now + rest, EDGES.receive()).await.ok()
            }
            None => Some(EDGES.receive().await),
        };
        if let Some(button) = edge {
            inputs.button = button;
        }
    }
}

/// Presses the button, and ends the emulator when the light has gone out again.
async fn visitor() {
    for press in [1_000, 20_000, 47_000] {
        for (at, level) in [(press, true), (press + 200, false)] {
            Timer::at(Instant::from_millis(at)).await;
            EDGES.send(level).await;
        }
    }
    Timer::after_secs(35).await;
    debug::exit(debug::EXIT_SUCCESS);
}
