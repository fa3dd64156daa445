//! The two ways in which a chart can have a controller for it: Table 2 of the source document on sequential function
//! charts.
//!
//! Called by an action, the controller needs nothing but a place for its state, and computes once in a cycle. An autonomous
//! one keeps its own time, as fast as it has to, however long a cycle of the chart takes; it is switched on and off by
//! messages.

use core::fmt::Write;

use grafcet::heapless::spsc::{Consumer, Producer, Queue};
use grafcet::{Phase, grafcet};

use super::script::{self, Notes, PlayError, signals};

grafcet! {
    /// An oven whose controller is called by the chart.
    pub sfc Called {
        input start, stop: bool;
        /// In °C.
        input temperature: i16;
        output ready, hot: bool;
        /// In °C.
        param setpoint: i16 = 100;
        /// Computes the power of the heating from the temperature that is wanted and the one that is there, in °C.
        action control(setpoint: i16, temperature: i16);

        initial step Off { N ready; }
        step HeatUp { N control(setpoint, temperature); }
        step Hold { N hot; N control(setpoint, temperature); }

        Off -[rising(start)]-> HeatUp;
        HeatUp -[stop]-> Off;
        HeatUp -[temperature >= setpoint - 2]-> Hold -[stop]-> Off;
    }
}

grafcet! {
    /// The same oven, whose controller is autonomous: single actions send it messages.
    pub sfc Remote {
        input start, stop: bool;
        /// In °C.
        input temperature: i16;
        output ready, hot: bool;
        /// In °C.
        param setpoint: i16 = 100;
        /// Sends a message to the controller.
        action send(message: Message);

        // At power-up too: whatever the controller has been doing, it stops.
        initial step Off { N ready; P1 send(Message::Stop); }
        step HeatUp { P1 send(Message::Start(setpoint)); }
        step Hold { N hot; }

        Off -[rising(start)]-> HeatUp;
        HeatUp -[stop]-> Off;
        HeatUp -[temperature >= setpoint - 2]-> Hold -[stop]-> Off;
    }
}

signals!(CalledInputs: start, stop, temperature);
signals!(CalledOutputs: ready, hot);
signals!(RemoteInputs: start, stop, temperature);
signals!(RemoteOutputs: ready, hot);

/// A PID controller in whole numbers: 2 % of power for each degree of the deviation, 1/4 % for each of its sum, which adds
/// at most 50 %, and 1 % for each of its change.
#[derive(Clone, Copy, Default)]
pub struct Pid {
    sum: i32,
    last: i32,
    /// Of the heating, in %.
    pub power: i32,
}

impl Pid {
    const SUM: i32 = 200;

    /// One that starts at this deviation: it has no past.
    #[must_use]
    pub fn start(setpoint: i16, temperature: i16) -> Self {
        Self { last: deviation(setpoint, temperature), ..Self::default() }
    }

    /// One step of the controller.
    pub fn compute(&mut self, setpoint: i16, temperature: i16) {
        let deviation = deviation(setpoint, temperature);
        self.sum = (self.sum + deviation).clamp(-Self::SUM, Self::SUM);
        self.power = (2 * deviation + self.sum / 4 + (deviation - self.last)).clamp(0, 100);
        self.last = deviation;
    }
}

fn deviation(setpoint: i16, temperature: i16) -> i32 {
    i32::from(setpoint) - i32::from(temperature)
}

/// The first call initialises and computes, the last one switches off.
impl CalledActions for Pid {
    fn control(&mut self, phase: Phase, setpoint: i16, temperature: i16) {
        match phase {
            Phase::First => {
                *self = Self::start(setpoint, temperature);
                self.compute(setpoint, temperature);
            }
            Phase::Repeated => self.compute(setpoint, temperature),
            Phase::Final => *self = Self::default(),
        }
    }
}

/// What the chart tells the autonomous controller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Message {
    /// To keep this temperature, in °C.
    Start(i16),
    /// To switch the heating off.
    Stop,
}

/// Room for seven messages: that often a chart may switch on and off before the controller reads.
pub type Messages = Queue<Message, 8>;

/// The chart's end of the queue.
pub struct Sender<'q> {
    /// Where the messages go.
    pub messages: Producer<'q, Message, 8>,
    /// Whether the controller has not read them in time.
    pub lost: bool,
}

impl RemoteActions for Sender<'_> {
    fn send(&mut self, _: Phase, message: Message) {
        self.lost |= self.messages.enqueue(message).is_err();
    }
}

/// The controller's end, and the controller. Its loop may be a thread, an interrupt, or another loop of the program.
pub struct Autonomous<'q> {
    /// Where the messages come from.
    pub messages: Consumer<'q, Message, 8>,
    /// What to keep; `None` while it is switched off.
    pub setpoint: Option<i16>,
    /// Its state.
    pub pid: Pid,
}

impl Autonomous<'_> {
    /// One round of its loop.
    pub fn run(&mut self, temperature: i16) {
        while let Some(message) = self.messages.dequeue() {
            (self.setpoint, self.pid) = match message {
                Message::Start(setpoint) => (Some(setpoint), Pid::start(setpoint, temperature)),
                Message::Stop => (None, Pid::default()),
            };
        }
        if let Some(setpoint) = self.setpoint {
            self.pid.compute(setpoint, temperature);
        }
    }
}

/// Plays a script on an oven of either kind, one after the other; one plain line per cycle goes to `out`.
///
/// # Errors
/// As [`script::play`].
pub fn play<'s>(script: &'s str, out: &mut dyn Write) -> Result<(), PlayError<'s>> {
    out.write_str("## called by the chart\n")?;
    play_called(script, out)?;
    out.write_str("## autonomous\n")?;
    play_remote(script, out)
}

/// A controller that takes down its calls.
#[derive(Default)]
struct Noted<A> {
    by: A,
    notes: Notes,
}

impl CalledActions for Noted<Pid> {
    fn control(&mut self, phase: Phase, setpoint: i16, temperature: i16) {
        self.by.control(phase, setpoint, temperature);
        self.notes.call("control", phase, format_args!("{setpoint}, {temperature}"));
    }
}

impl RemoteActions for Noted<Sender<'_>> {
    fn send(&mut self, phase: Phase, message: Message) {
        self.by.send(phase, message);
        self.notes.call("send", phase, format_args!("{message:?}"));
    }
}

fn play_called<'s>(script: &'s str, out: &mut dyn Write) -> Result<(), PlayError<'s>> {
    let mut oven = Called::new();
    let mut pid = Noted::<Pid>::default();
    script::play(script, out, |inputs, _| {
        let outputs = oven.cycle(inputs, &mut pid);
        let mut notes = core::mem::take(&mut pid.notes);
        notes.add(format_args!("power {}", pid.by.power));
        (outputs, oven.active_steps(), notes)
    })
}

/// How often the loop of the autonomous controller turns in a cycle of the chart, where a script has to be repeatable.
const ROUNDS: usize = 3;

fn play_remote<'s>(script: &'s str, out: &mut dyn Write) -> Result<(), PlayError<'s>> {
    let mut queue = Messages::new();
    let (messages, received) = queue.split();
    let mut oven = Remote::new();
    let mut sender = Noted { by: Sender { messages, lost: false }, notes: Notes::new() };
    let mut controller = Autonomous { messages: received, setpoint: None, pid: Pid::default() };
    script::play(script, out, |inputs: &RemoteInputs, _| {
        let outputs = oven.cycle(inputs, &mut sender);
        (0..ROUNDS).for_each(|_| controller.run(inputs.temperature));
        let mut notes = core::mem::take(&mut sender.notes);
        notes.add(format_args!("power {}", controller.pid.power));
        (outputs, oven.active_steps(), notes)
    })
}
