//! An oven with its controller called by the chart, and the same with an autonomous controller in a thread of its own.
//! `cargo run --example controller -- --help` tells what else it can do.

#[path = "charts/controller.rs"]
pub mod controller;
#[path = "charts/script.rs"]
pub mod script;
pub(crate) mod shared;

use std::io::{self, Write};
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, AtomicI16, AtomicI32, AtomicU32, Ordering};
use std::thread;
use std::time::Duration;

use anstyle::{AnsiColor, Style};

use controller::{
    Autonomous, Called, CalledInputs, CalledStep, Messages, Pid, Remote, RemoteInputs, RemoteStep, Sender,
};
use shared::{Example, Timeline};

/// The example, of which the command line chooses what is shown.
pub(crate) const EXAMPLE: Example = Example {
    name: "controller",
    about: "An oven, twice: an SFC that calls a PID controller, and one that sends\nmessages to an autonomous one.",
    charts: &[&Called::CHART, &Remote::CHART],
    show,
    play: controller::play,
};

fn main() -> ExitCode {
    EXAMPLE.main()
}

/// When the operator starts.
const START: usize = 2;

/// An oven, of which a step of time is as long as it likes.
struct Oven {
    /// In 1/10 °C.
    heat: i32,
}

impl Oven {
    /// In 1/10 °C.
    const COLD: i32 = 200;

    fn new() -> Self {
        Self { heat: Self::COLD }
    }

    /// A step of time with so many % of its power.
    fn run(&mut self, power: i32) {
        self.heat += power / 2 - (self.heat - Self::COLD) / 40;
    }

    /// In °C.
    fn temperature(&self) -> i16 {
        i16::try_from(self.heat / 10).unwrap_or(i16::MAX)
    }
}

/// `████████████         58 %`, with a block for 10 °C.
fn picture(temperature: i16, power: i32) -> String {
    let style = AnsiColor::Yellow.on_default();
    let bar: String = (0..temperature / 10).map(|_| '█').collect();
    format!("{style}{bar:12}{style:#} {power:3} %")
}

fn show(out: &mut dyn Write) -> io::Result<()> {
    show_called(out)?;
    writeln!(out)?;
    show_remote(out)
}

fn show_called(out: &mut dyn Write) -> io::Result<()> {
    const STOP: usize = 36;
    const CYCLES: usize = 40;
    let legend = "A PID controller that an action calls: once a cycle.";
    let mut timeline = Timeline::<Called>::new(out, colour, legend, "oven and power", &[])?;
    let (mut chart, mut pid, mut oven) = (Called::new(), Pid::default(), Oven::new());
    for cycle in 0..CYCLES {
        let step = chart.situation();
        let inputs = CalledInputs { start: cycle == START, stop: cycle == STOP, temperature: oven.temperature() };
        let outputs = chart.cycle(&inputs, &mut pid);
        let remark = match (step, chart.situation()) {
            (CalledStep::Off, CalledStep::HeatUp) => "the first call initialises",
            (CalledStep::HeatUp, CalledStep::Hold) => "the same action goes on",
            (CalledStep::Hold, CalledStep::Off) => "the final call switches off",
            _ => "",
        };
        timeline.show(&chart, &inputs, &outputs, picture(inputs.temperature, pid.power), remark)?;
        oven.run(pid.power);
    }
    Ok(())
}

/// What the thread of the autonomous controller shares with that of the chart, beside the messages.
#[derive(Default)]
struct Shared {
    /// In °C.
    temperature: AtomicI16,
    /// In %.
    power: AtomicI32,
    /// How often the controller has computed.
    computed: AtomicU32,
    /// The program ends.
    end: AtomicBool,
}

impl Shared {
    fn new(oven: &Oven) -> Self {
        Self { temperature: oven.temperature().into(), ..Self::default() }
    }
}

/// How long the thread of the controller waits between two rounds.
const ROUND: Duration = Duration::from_millis(1);

/// The thread of the controller: it has the oven to itself.
fn control(mut controller: Autonomous<'_>, mut oven: Oven, shared: &Shared) {
    while !shared.end.load(Ordering::Acquire) {
        controller.run(oven.temperature());
        oven.run(controller.pid.power);
        shared.computed.fetch_add(controller.setpoint.is_some().into(), Ordering::Relaxed);
        shared.power.store(controller.pid.power, Ordering::Relaxed);
        shared.temperature.store(oven.temperature(), Ordering::Relaxed);
        thread::sleep(ROUND);
    }
}

fn show_remote(out: &mut dyn Write) -> io::Result<()> {
    let mut queue = Messages::new();
    let (messages, received) = queue.split();
    let controller = Autonomous { messages: received, setpoint: None, pid: Pid::default() };
    let oven = Oven::new();
    let shared = Shared::new(&oven);
    thread::scope(|scope| {
        scope.spawn(|| control(controller, oven, &shared));
        let shown = show_chart(out, Sender { messages, lost: false }, &shared);
        // Also where nothing could be written: the scope waits for the thread.
        shared.end.store(true, Ordering::Release);
        shown
    })
}

/// The thread of the chart.
fn show_chart(out: &mut dyn Write, mut sender: Sender<'_>, shared: &Shared) -> io::Result<()> {
    /// A cycle of the chart takes several rounds of the controller.
    const CYCLE: Duration = Duration::from_millis(4);
    /// For so many cycles the operator keeps the oven hot.
    const HOT: usize = 6;
    /// However slow the machine is, there is an end.
    const CYCLES: usize = 1000;
    let legend = "A controller in a thread of its own, started and stopped by messages.";
    let mut timeline = Timeline::<Remote>::new(out, colour, legend, "oven, power, computed", &[])?;
    let mut chart = Remote::new();
    let mut hot = 0;
    for cycle in 0..CYCLES {
        let step = chart.situation();
        let temperature = shared.temperature.load(Ordering::Relaxed);
        let inputs = RemoteInputs { start: cycle == START, stop: hot == HOT, temperature };
        let outputs = chart.cycle(&inputs, &mut sender);
        let remark = match (step, chart.situation()) {
            _ if sender.lost => "a message is lost",
            (RemoteStep::Off, RemoteStep::HeatUp) => "a message starts it",
            (RemoteStep::HeatUp, RemoteStep::Hold) => "no message is needed",
            (RemoteStep::Hold, RemoteStep::Off) => "a message stops it",
            _ => "",
        };
        let power = shared.power.load(Ordering::Relaxed);
        let picture = format!("{} {:4}", picture(temperature, power), shared.computed.load(Ordering::Relaxed));
        timeline.show(&chart, &inputs, &outputs, picture, remark)?;
        hot += usize::from(outputs.hot);
        if hot > 0 && chart.is_active(RemoteStep::Off) && power == 0 {
            break;
        }
        thread::sleep(CYCLE);
    }
    Ok(())
}

fn colour(output: &str) -> Style {
    match output {
        "ready" => AnsiColor::Green.on_default().bold(),
        _ => AnsiColor::Red.on_default().bold(),
    }
}
