//! A replay shows what has happened, on the charts of the examples.

use std::fmt::Debug;

use grafcet::record::{Damage, Recordable, Recorder, Records, ReplayError, Writer, replay};
use grafcet::{Chart as _, Ticks, grafcet, recordable};
use grafcet_record::branch_on_result::Sorter;
use grafcet_record::cell::Cell;
use grafcet_record::controller::{Called, Remote};
use grafcet_record::line24v::Line24V;
use grafcet_record::motor::{Motor, MotorInputs};
use grafcet_record::recipe::{self, Dyer};
use grafcet_record::tickless::Crossing;
use grafcet_record::{Nobody, Storm};

/// What a cycle has shown.
type Shown<C> = (<C as grafcet::Chart>::Outputs, <C as grafcet::Chart>::Situation);

/// Runs a chart with a recorder and without, and the replay of the record: everywhere the same has to happen.
fn is_replayed<C>(chart: &C, actions: fn() -> &'static mut C::Actions<'static>, memory: usize, cycles: u32)
where
    C: Recordable<Outputs: PartialEq + Debug> + Debug,
{
    for seed in 0..20 {
        let mut alone = chart.clone();
        let mut recorder = Recorder::new(chart.clone(), vec![0xaa; memory]).expect("enough memory");
        let mut storm = Storm::<C::Inputs>::new(seed);
        let mut shown: Vec<Shown<C>> = Vec::new();
        for cycle in 0..cycles {
            if cycle % 700 == 699 {
                recorder.change(C::init);
                alone.init();
            }
            let (inputs, now) = storm.cycle();
            let outputs = alone.scan(&inputs, now, actions());
            assert_eq!(recorder.cycle(&inputs, now, actions()), outputs);
            shown.push((outputs, alone.situation()));
            // The program may send the record at any time.
            if seed % 2 == 1 && cycle % 13 == 0 {
                recorder.flush();
            }
        }
        recorder.flush();

        let records = Records::of(recorder.record()).expect("a record");
        let mut next = None;
        let replayed = replay::<C>(&records, actions(), |moment| {
            let cycle = moment.cycle as usize;
            // What was skipped has shown what the cycles before and after it show.
            for skipped in next.unwrap_or(cycle)..cycle {
                assert_eq!(shown[skipped], shown[skipped - 1], "{} {seed}: skipped cycle {skipped}", C::NAME);
            }
            let now = (moment.outputs, moment.chart.situation());
            assert_eq!(now, shown[cycle], "{} {seed}: cycle {cycle}", C::NAME);
            next = Some(cycle + 1);
        });
        assert_eq!(replayed, Ok(()), "{} {seed}", C::NAME);
        assert_eq!(next, Some(cycles as usize), "{}: the record ends with the last cycle", C::NAME);
    }
}

fn none() -> &'static mut () {
    Box::leak(Box::new(()))
}

#[test]
fn charts_without_time() {
    for memory in [600, 100_000] {
        is_replayed(&Motor::new(), none, memory, 3_000);
        is_replayed(&Cell::new(), none, memory, 3_000);
        is_replayed(&Line24V::new(), none, memory, 3_000);
        is_replayed(&Sorter::new(), none, memory, 3_000);
        is_replayed(&Called::new(), || Box::leak(Box::new(Nobody)), memory, 3_000);
        is_replayed(&Remote::new(), || Box::leak(Box::new(Nobody)), memory, 3_000);
    }
}

#[test]
fn charts_with_time() {
    for memory in [600, 100_000] {
        is_replayed(&Crossing::new(), none, memory, 3_000);
        is_replayed(&Dyer::new(), || Box::leak(Box::new(Nobody)), memory, 3_000);
        is_replayed(&Dyer::with_params(recipe::WOOL), || Box::leak(Box::new(Nobody)), memory, 3_000);
        is_replayed(&Kiln::new(), none, memory, 3_000);
        is_replayed(&Bits::new(), none, memory, 3_000);
    }
}

/// A type of the program.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Mode {
    /// Nobody wants it.
    #[default]
    Off,
    /// By itself.
    Auto,
    /// By hand.
    Manual,
}

recordable! { Mode { Off, Auto, Manual } }

grafcet! {
    /// Inputs of many types, more than a byte; edges, delays, parallel branches, a search that may have no end.
    #[derive(Debug, PartialEq)]
    grafcet Kiln {
        input mode: Mode;
        input heat: f32;
        input a, b, c, d: bool;
        input level: u16;
        input pair: (u8, bool);
        output fire: bool;
        output seen: Mode = Mode::Off;
        output count: u16;
        var n: u8 = 3;
        param limit: time = 3s;

        initial step Idle;
        step One { fire if 1s/a/2s; P1 seen = mode; } step Two { D 500ms fire; }
        step Three { P1 count = count + level % 7; P1 n = n % 50 + pair.0 % 3; } step Four;

        Idle -[mode != Mode::Off && rising(b)]-> (One, Three);
        One -[heat > 1.5 || limit/One]-> Two;
        Three -[c]-> Four -[d && n > 2 && !c]-> Three;
        (Two, Four) -[!(a || d && n > 2 && !c)]-> Idle;
    }
}

grafcet! {
    /// More bits of inputs than are compared byte by byte, flags, and what blinks.
    grafcet Bits {
        encoding flags;
        input a, b: bool;
        input many: [u32; 9];
        output lamp, horn: bool;
        initial step Idle;
        step Busy { lamp if blink(300ms/200ms); L 2s horn; }
        step Other;
        Idle -[a]-> Busy -[b && many[8] % 3 != 1]-> Other -[1s/Other]-> Idle;
    }
}

/// In each bit of a record, one after the other, something goes wrong: what is shown then is still what has happened.
#[test]
fn no_wrong_bit_shows_what_was_not() {
    let mut recorder = Recorder::new(Cell::new(), [0; 700]).expect("enough memory");
    let mut storm = Storm::new(7);
    let mut shown = Vec::new();
    for _ in 0..400 {
        let (inputs, now) = storm.cycle();
        shown.push((inputs, recorder.cycle(&inputs, now, &mut ()), recorder.chart().situation()));
    }
    let record = recorder.record().to_vec();
    let (mut whole, mut least) = (0, usize::MAX);
    for bit in 0..=record.len() * 8 {
        let mut record = record.clone();
        if let Some(byte) = record.get_mut(bit / 8) {
            *byte ^= 1 << (bit % 8);
        }
        let records = Records::of(&record).expect("other blocks");
        let mut count = 0;
        let replayed = replay::<Cell>(&records, &mut (), |moment| {
            let now = (*moment.inputs, moment.outputs, moment.chart.situation());
            assert_eq!(now, shown[moment.cycle as usize], "bit {bit}");
            count += 1;
        });
        assert!(
            matches!(replayed, Ok(()) | Err(ReplayError::Damage(Damage::OtherChart { .. }))),
            "{bit}: {replayed:?}"
        );
        (whole, least) = (count, least.min(count));
    }
    // The last one has no error.
    assert!(least < whole && least > whole / 2, "{least} of {whole}");
}

/// The program ends in the middle of a store: the memory is the old one up to a byte, and the new one before it.
#[test]
fn what_is_torn_is_told() {
    let mut recorder = Recorder::new(Kiln::new(), [0; 900]).expect("enough memory");
    let mut storm = Storm::new(3);
    let mut shown = Vec::new();
    let mut torn = 0;
    for cycle in 0..300_usize {
        let (inputs, now) = storm.cycle();
        let before = recorder.record().to_vec();
        shown.push((recorder.cycle(&inputs, now, &mut ()), recorder.chart().situation()));
        let after = recorder.record();
        for cut in 0..after.len() {
            if before[cut] == after[cut] {
                continue;
            }
            for (first, last) in [(&before[..], after), (after, &before[..])] {
                let mixed = [&first[..cut], &last[cut..]].concat();
                let records = Records::of(&mixed).expect("a record");
                torn += records.blocks().filter(|block| block.as_ref().is_ok_and(|block| block.torn)).count();
                let replayed = replay::<Kiln>(&records, &mut (), |moment| {
                    let now = (moment.outputs, moment.chart.situation());
                    assert_eq!(now, shown[moment.cycle as usize], "cycle {cycle}, cut at {cut}");
                });
                assert_eq!(replayed, Ok(()), "cycle {cycle}, cut at {cut}");
            }
        }
    }
    assert!(torn > 100, "{torn}");
}

#[test]
fn a_record_of_another_chart_is_refused() {
    let recorder = Recorder::new(Motor::new(), [0; 500]).expect("enough memory");
    let records = Records::of(recorder.record()).expect("a record");
    assert_eq!(records.check::<Motor>(), Ok(()));
    let other = Damage::OtherChart { fingerprint: Motor::FINGERPRINT };
    assert_eq!(records.check::<Cell>(), Err(other));
    assert_eq!(replay::<Cell>(&records, &mut (), |_| {}), Err(ReplayError::Damage(other)));
    assert_eq!(Records::of(&[0; 500]).err(), Some(Damage::NoRecord));
    assert_eq!(Records::of(&[0x47; 3]).err(), Some(Damage::NoRecord));
}

/// What changes the chart past the recorder is found.
#[test]
fn what_the_record_does_not_know_is_found() {
    thread_local! { static TRUTH: std::cell::Cell<bool> = const { std::cell::Cell::new(false) }; }
    fn moody(_: bool) -> bool {
        TRUTH.get()
    }
    grafcet! {
        sfc Moody {
            input a: bool;
            output b: bool;
            initial step One;
            step Two { N b; }
            One -[a && moody(a)]-> Two -[!a]-> One;
        }
    }
    let mut recorder = Recorder::new(Moody::new(), [0; 500]).expect("enough memory");
    TRUTH.set(true);
    for cycle in 0..100 {
        recorder.cycle(&MoodyInputs { a: cycle % 4 < 2 }, Ticks::ZERO, &mut ());
    }
    recorder.cycle(&MoodyInputs { a: true }, Ticks::ZERO, &mut ());
    recorder.cycle(&MoodyInputs { a: true }, Ticks::ZERO, &mut ());
    recorder.cycle(&MoodyInputs { a: true }, Ticks::ZERO, &mut ());
    recorder.flush();
    let records = Records::of(recorder.record()).expect("a record");
    assert_eq!(replay::<Moody>(&records, &mut (), |_| {}), Ok(()));
    TRUTH.set(false);
    let replayed = replay::<Moody>(&records, &mut (), |_| {});
    assert!(matches!(replayed, Err(ReplayError::Diverged { .. })), "{replayed:?}");
}

/// What is full says how much is missing.
#[test]
fn what_was_overwritten_is_counted() {
    let mut recorder = Recorder::new(Motor::new(), [0; 500]).expect("enough memory");
    for cycle in 0..2_000 {
        recorder.cycle(&MotorInputs { on: cycle % 2 == 0, ..Default::default() }, Ticks::ZERO, &mut ());
    }
    let records = Records::of(recorder.record()).expect("a record");
    let blocks: Vec<_> = records.blocks().map(|block| block.expect("a block")).collect();
    assert!(blocks[0].missing > 10 && blocks[0].key.cycle > 1_000);
    assert!(blocks[1..].iter().all(|block| block.missing == 0 && !block.torn));
    assert!(Recorder::new(Motor::new(), [0; 90]).is_err_and(|small| small.needed <= 500));
}

grafcet! {
    /// Two branches, and a step that waits on when its time is over.
    pub grafcet Waiter {
        input a, b: bool;
        initial step Idle {}
        step Left {}
        step Right {}
        step Rest {}
        Idle -[a]-> (Left, Right);
        (Left, Right) -[a]-> Rest;
        Rest -[5ms/Rest && b]-> Idle;
    }
}

#[test]
fn a_time_that_nobody_awaits_may_stand_anywhere() {
    let mut recorder = Recorder::new(Waiter::new(), vec![0; 4_000]).expect("enough memory");
    // From 1009 on the step waits for `b`, which is only counted, and the reading goes on; the replay does not do these cycles.
    let cycles = [(1000, true, false), (1008, false, false), (1009, false, false), (1012, false, false)];
    for (now, a, b) in cycles.into_iter().chain([(1013, false, true), (1014, false, true)]) {
        recorder.cycle(&WaiterInputs { a, b }, Ticks::new(now), &mut ());
    }
    recorder.flush();
    let records = Records::of(recorder.record()).expect("a record");
    let mut written = Vec::new();
    let replayed = replay::<Waiter>(&records, &mut (), |moment| written = bytes(moment.chart));
    assert_eq!(replayed, Ok(()));
    // Of these the hash is made that a recorder sends.
    assert_eq!(written, bytes(recorder.chart()));
}

fn bytes(chart: &Waiter) -> Vec<u8> {
    let mut bytes = vec![0; Waiter::STATE_BITS.div_ceil(8)];
    chart.write_state(&mut Writer::new(&mut bytes));
    bytes
}

#[test]
fn a_time_that_is_awaited_tells_states_apart() {
    let after = |elapsed: u32| {
        let mut chart = Waiter::new();
        for now in [1000, 1000 + elapsed] {
            chart.scan(&WaiterInputs { a: now == 1000, b: false }, Ticks::new(now), &mut ());
        }
        chart
    };
    assert!(after(3).is_same_state(&after(3)));
    assert!(!after(3).is_same_state(&after(4)));
    assert!(after(6).is_same_state(&after(9)), "the time is over");
}
