//! The recorder on a chart that is written by hand: a program may look at the record, or tell the state, between any two cycles.

use core::fmt;

use grafcet_core::record::{Reader, Record, Recordable, Recorder, Records, Writer, replay};
use grafcet_core::{Chart, Possible, Ticks};

/// A lamp that changes every ten ticks while it is on.
#[derive(Clone, Default)]
struct Lamp {
    lit: bool,
    elapsed: u32,
    now: Ticks,
}

const PERIOD: u32 = 10;

#[derive(Clone, Copy, Default)]
struct On(bool);

impl Record for On {
    const BITS: usize = 1;

    fn write(&self, to: &mut Writer<'_>) {
        self.0.write(to);
    }

    fn read(from: &mut Reader<'_>) -> Option<Self> {
        bool::read(from).map(Self)
    }

    fn is_same(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Nothing;

impl fmt::Display for Nothing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("nothing")
    }
}

impl Chart for Lamp {
    type Inputs = On;
    type Outputs = bool;
    type Step = Nothing;
    type Transition = Nothing;
    type Situation = Nothing;
    type Actions<'a> = ();

    const NAME: &'static str = "Lamp";
    const STEPS: &'static [Nothing] = &[];
    const TRANSITIONS: &'static [Nothing] = &[];

    fn scan(&mut self, inputs: &On, now: Ticks, (): &mut ()) -> bool {
        self.elapsed += now.since(self.now).get();
        self.now = now;
        if !inputs.0 {
            (self.lit, self.elapsed) = (false, 0);
        } else if self.elapsed >= PERIOD {
            (self.lit, self.elapsed) = (!self.lit, 0);
        }
        self.lit
    }

    fn init(&mut self) {
        *self = Self { now: self.now, ..Self::default() };
    }

    fn is_active(&self, _: Nothing) -> bool {
        false
    }

    fn situation(&self) -> Nothing {
        Nothing
    }
}

impl Recordable for Lamp {
    const FINGERPRINT: u32 = 1;
    const LAYOUT: u32 = 1;
    const TIMED: bool = true;
    const POSSIBLE: Possible<'static> = Possible::Unknown;
    const PARAM_BITS: usize = 0;
    const STATE_BITS: usize = 33;

    fn write_params(&self, _: &mut Writer<'_>) {}

    fn write_state(&self, to: &mut Writer<'_>) {
        (self.lit, self.elapsed).write(to);
    }

    fn read(_: &mut Reader<'_>, state: &mut Reader<'_>, now: Ticks) -> Option<Self> {
        let (lit, elapsed) = Record::read(state)?;
        Some(Self { lit, elapsed, now })
    }

    fn begun_anew(&self) -> Self {
        Self::default()
    }

    fn is_same_state(&self, other: &Self) -> bool {
        (self.lit, self.elapsed) == (other.lit, other.elapsed)
    }

    fn reading(&self) -> Ticks {
        self.now
    }

    fn wakes_at(&self) -> Option<Ticks> {
        Some(self.now.after(Ticks::new(PERIOD - self.elapsed)))
    }
}

/// The chart is due when it was due before, however often its state is written down meanwhile.
#[test]
fn a_state_that_is_written_lets_no_cycle_be_missed() {
    for every in 1..=PERIOD {
        let mut recorder = Recorder::new(Lamp::default(), [0; 4_000]).expect("enough memory");
        let mut shown = Vec::new();
        for now in 0..200 {
            if now % every == 0 {
                recorder.flush();
            }
            shown.push(recorder.cycle(&On(true), now, &mut ()));
        }
        recorder.flush();
        let records = Records::of(recorder.record()).expect("a record");
        let (mut next, mut last) = (0, false);
        let replayed = replay::<Lamp>(&records, &mut (), |moment| {
            let cycle = moment.cycle as usize;
            assert!(shown[next..cycle].iter().all(|lit| *lit == last), "every {every}: skipped {next} to {cycle}");
            assert_eq!(moment.outputs, shown[cycle], "every {every}: cycle {cycle}");
            (next, last) = (cycle + 1, moment.outputs);
        });
        assert_eq!(replayed, Ok(()), "every {every}");
        assert!(shown[next..].iter().all(|lit| *lit == last), "every {every}: skipped {next} to the end");
    }
}
