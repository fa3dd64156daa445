//! A pedestrian crossing whose controller sleeps until the chart has to be scanned, beside one that never sleeps.

use core::fmt::Write;

use grafcet::grafcet;

use super::script::{self, Notes, PlayError, signals};

grafcet! {
    /// A pedestrian crossing with a button.
    pub sfc Crossing {
        clock 1ms;
        input button: bool;
        output green, yellow, red, wait, walk, chirp, hurry: bool;

        initial step Cars { N green; }
        step Asked { N green; N wait; }
        step Yellow { N yellow; N wait; }
        step Stop { N red; N wait; }
        step Walk { N red; N walk; L 1s chirp; D 6s hurry; }
        step Clear { N red; }

        Cars -[rising(button)]-> Asked -[5s/Asked]-> Yellow -[3s/Yellow]-> Stop -[2s/Stop]-> Walk
             -[8s/Walk]-> Clear -[4s/Clear]-> Cars;
    }
}

signals!(CrossingInputs: button);
signals!(CrossingOutputs: green, yellow, red, wait, walk, chirp, hurry);

/// Two controllers of one crossing: one scans the chart at every tick of the clock, the other one only when the chart
/// asks for it or an input changes.
pub struct Controllers {
    scanner: Crossing,
    /// The chart of the one that sleeps.
    pub sleeper: Crossing,
    /// Its outputs, which it holds while it sleeps.
    pub outputs: CrossingOutputs,
    inputs: CrossingInputs,
    /// In how many ticks it wakes up; `None`: when an input changes.
    wakes: Option<u32>,
    /// The reading of the clock at the next tick, in ms.
    pub now: u32,
    /// How often the chart of the one that sleeps has been scanned.
    pub scans: u32,
    /// In how many ticks the two differed.
    pub differences: u32,
}

impl Controllers {
    /// Both before their first cycle, which no deadline asks for.
    #[must_use]
    pub fn new() -> Self {
        Self {
            scanner: Crossing::new(),
            sleeper: Crossing::new(),
            outputs: CrossingOutputs::default(),
            inputs: CrossingInputs::default(),
            wakes: Some(0),
            now: 0,
            scans: 0,
            differences: 0,
        }
    }

    /// A tick of the clock. Answers whether it has woken the one that sleeps.
    pub fn tick(&mut self, inputs: CrossingInputs) -> bool {
        let woken = inputs != self.inputs || self.wakes == Some(0);
        if woken {
            self.outputs = self.sleeper.cycle(&inputs, self.now);
            self.scans += 1;
            // A deadline that is now asks for a scan at once, and that is the next tick.
            self.wakes = self.sleeper.next_deadline().map(|deadline| deadline.since(self.now.into()).get().max(1));
        }
        self.wakes = self.wakes.map(|ticks| ticks - 1);
        self.inputs = inputs;
        let scanned = self.scanner.cycle(&inputs, self.now);
        let same = scanned == self.outputs && self.scanner.situation() == self.sleeper.situation();
        self.differences += u32::from(!same);
        self.now += 1;
        woken
    }
}

impl Default for Controllers {
    fn default() -> Self {
        Self::new()
    }
}

/// Plays a script on a crossing of its own: the inputs of a line are those from its time on. One plain line for each of
/// the script goes to `out`.
///
/// # Errors
/// As [`script::play`].
pub fn play<'s>(script: &'s str, out: &mut dyn Write) -> Result<(), PlayError<'s>> {
    let mut both = Controllers::new();
    script::play(script, out, |inputs, now| {
        while both.now < now {
            both.tick(both.inputs);
        }
        both.tick(*inputs);
        let mut notes = Notes::new();
        notes.add(format_args!("{} scans in {} ticks, {} differ", both.scans, both.now, both.differences));
        (both.outputs, both.sleeper.active_steps(), notes)
    })
}
