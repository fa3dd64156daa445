//! A record that is run again with the chart's source alone shows what the compiled chart shows.

use std::fmt::Debug;

use grafcet::record::wire::{Wire, wire_len};
use grafcet::record::{Memory, Recordable, Recorder, Records, replay};
use grafcet::{Ticks, grafcet};
use grafcet_record::branch_on_result::Sorter;
use grafcet_record::cell::{Cell, CellInputs};
use grafcet_record::line24v::Line24V;
use grafcet_record::motor::Motor;
use grafcet_record::pick_and_place::PickAndPlace;
use grafcet_record::recipe::{self, Dyer};
use grafcet_record::stroke::Press;
use grafcet_record::tickless::Crossing;
use grafcet_record::{Nobody, Storm};
use grafcet_sim::{Asked, Changed, Chart, Program, Replay, ReplayError, Trace, Value, page, table};

fn none() -> &'static mut () {
    Box::leak(Box::new(()))
}

fn source(file: &str, name: &str) -> Chart {
    Chart::in_file(file, name).unwrap_or_else(|refused| panic!("{name}: {refused}"))
}

/// What a cycle of a trace shows, as `Debug` writes the outputs of a compiled chart.
fn shown(trace: &Trace, cycle: usize) -> (u32, Vec<String>, String) {
    let (names, cycle) = (&trace.names, &trace.cycles[cycle]);
    let outputs = names.outputs.iter().zip(&cycle.outputs).map(|(output, value)| format!("{}: {value}", output.name));
    let outputs: Vec<String> = outputs.collect();
    let mut steps: Vec<String> = cycle.steps.iter().map(|step| names.steps[*step].name.clone()).collect();
    steps.sort_unstable();
    (cycle.now, steps, format!("{}Outputs {{ {} }}", names.chart, outputs.join(", ")))
}

/// Records a storm of inputs and runs the record both ways.
fn agree<C>(chart: &C, actions: fn() -> &'static mut C::Actions<'static>, file: &str)
where
    C: Recordable<Outputs: Debug>,
{
    let source = source(file, C::NAME);
    assert_eq!(source.fingerprint(), Some(C::FINGERPRINT), "{}", C::NAME);
    // In the smaller ones the beginning is overwritten.
    let sizes = [100_000, Recorder::<C, Memory<Vec<u8>>>::LEAST, 1_000, 2_500];
    for (seed, memory) in (0..10).flat_map(|seed| sizes.map(|memory| (seed, memory))) {
        let is_whole = memory == 100_000;
        let mut recorder = Recorder::new(chart.clone(), vec![0; memory]).expect("enough memory");
        let mut storm = Storm::<C::Inputs>::new(seed);
        for cycle in 0..1_500 {
            if cycle % 700 == 699 {
                recorder.change(C::init);
            }
            let (inputs, now) = storm.cycle();
            recorder.cycle(&inputs, now, actions());
        }
        recorder.flush();
        let trace =
            Replay::new().run(&source, recorder.record()).unwrap_or_else(|error| panic!("{}: {error}", C::NAME));
        assert_eq!(trace.warnings, [] as [&str; 0], "{}: no warning", C::NAME);
        let mut compiled = Vec::new();
        let records = Records::of(recorder.record()).expect("a record");
        let replayed = replay::<C>(&records, actions(), |moment| {
            let active = C::STEPS.iter().filter(|step| moment.chart.is_active(**step));
            let mut steps: Vec<String> = active.map(ToString::to_string).collect();
            steps.sort_unstable();
            compiled.push((moment.cycle, (moment.now.get(), steps, format!("{:?}", moment.outputs))));
        });
        assert_eq!(replayed, Ok(()));
        assert_eq!(compiled.len(), trace.cycles.len(), "{} {seed} {memory}", C::NAME);
        let mut number = 0;
        for (cycle, compiled) in compiled.into_iter().enumerate() {
            let missing = trace.cycles[cycle].gap.as_ref().and_then(|gap| gap.cycles).unwrap_or(0);
            number += u32::try_from(missing).expect("few") + trace.cycles[cycle].skipped;
            assert_eq!((number, shown(&trace, cycle)), compiled, "{} {seed} {memory}: cycle {cycle}", C::NAME);
            number += 1;
        }
        let begun: Vec<&str> = trace.gaps().map(|(_, gap)| gap.reason.as_str()).collect();
        if is_whole {
            assert_eq!(begun, ["the chart began anew here"; 2], "{}: `init` is told", C::NAME);
        } else if memory <= 1_000 {
            assert!(
                begun[0].ends_with("blocks of the record were overwritten or are damaged"),
                "{}: {begun:?}",
                C::NAME
            );
        }
    }
}

#[test]
fn what_the_source_shows_is_what_the_compiled_chart_shows() {
    agree(&Motor::new(), none, include_str!("../../../examples/charts/motor.rs"));
    agree(&Cell::new(), none, include_str!("../../../examples/charts/cell.rs"));
    agree(&Line24V::new(), none, include_str!("../../../examples/charts/line24v.rs"));
    agree(&Sorter::new(), none, include_str!("../../../examples/charts/branch_on_result.rs"));
    agree(&Crossing::new(), none, include_str!("../../../examples/charts/tickless.rs"));
    let mixed = include_str!("../src/mixed.rs");
    agree(&grafcet_record::mixed::Press::new(), none, mixed);
    agree(&grafcet_record::mixed::Flags::new(), none, mixed);
    agree(&Works::new(), none, include_str!("source.rs"));
    agree(&Batch::new(), none, include_str!("source.rs"));
    agree(&Press::new(), none, include_str!("../../../examples/charts/stroke.rs"));
    agree(&PickAndPlace::new(), none, include_str!("../../../examples/charts/pick_and_place.rs"));
    agree(&Basin::new(), none, include_str!("source.rs"));
    let file = include_str!("../../../examples/charts/recipe.rs");
    agree(&Dyer::with_params(recipe::WOOL), || Box::leak(Box::new(Nobody)), file);
}

grafcet! {
    /// What a state of an `sfc` with parallel branches can hold: flip-flops and timers of actions, edges seen by conditions and by actions, delays, blinking, variables.
    #[derive(Debug)]
    sfc Works {
        input a, b, c: bool;
        input level: u8;
        output held, late, slow, short, pulse, lamp: bool;
        output safe: bool = true;
        output count: u16 = 3;
        var n: i16 = -2;
        var armed: bool;
        initial step Idle { R held; R late; R slow; R short; }
        step One { S held; SD 2s late; L 40ms pulse; P1 n = n + 1; }
        step Two { SL 3s short; D 30ms pulse; N armed if a; }
        step Three { P1 count = count % 900 + 7; DS 20ms slow; N lamp if blink(300ms/200ms); }
        step Four { P count = count % 900 + 1 if rising(b); R safe; }
        Idle -[rising(a)]-> (One, Three);
        One -[b && One.T > 15ms]-> Two;
        Three -[20ms/c/30ms || level > 200]-> Four;
        Four -[falling(c) || armed]-> Three;
        (Two, Three) -[!a || 4s/Two || n > 300]-> Idle;
    }
}

/// A record has 64 bits for each `usize`, whoever made it; what the interpreter computes with has to fit into 32.
#[test]
fn numbers_of_the_machines_size_are_read() {
    let mut recorder = Recorder::new(Sizes::new(), vec![0; 10_000]).expect("enough memory");
    let mut seen = Vec::new();
    for cycle in 0..12_u16 {
        let (level, slope) = (30_000 * usize::from(cycle), 3 - 7_000 * isize::try_from(cycle).expect("few"));
        let inputs = SizesInputs { a: cycle % 4 > 1, level, slope };
        let outputs = recorder.cycle(&inputs, Ticks::new(cycle.into()), &mut ());
        seen.push(format!("{outputs:?}"));
    }
    recorder.flush();
    let trace = Replay::new().run(&source(include_str!("source.rs"), "Sizes"), recorder.record()).expect("a record");
    assert_eq!((0..12).map(|cycle| shown(&trace, cycle).2).collect::<Vec<_>>(), seen);
    assert!(seen[11].contains("high: true") && seen[11].contains("seen: 7"), "{}", seen[11]);
}

grafcet! {
    /// Numbers of the machine's size, which a record keeps with 64 bits on each.
    #[derive(Debug)]
    sfc Sizes {
        input a: bool;
        input level: usize;
        input slope: isize;
        output high: bool;
        output seen: usize = 0;
        param limit: usize = 70_000;
        initial step Low;
        step High { high if slope < 0; P1 seen = if level > 1_000 { 7 } else { 3 }; }
        Low -[a && level > limit]-> High -[!a]-> Low;
    }
}

grafcet! {
    /// The same of a `grafcet`: stored outputs, edges of steps, an order, an enclosing step, a macro-step.
    #[derive(Debug)]
    grafcet Batch {
        input a, b, stop: bool;
        input level: i8;
        output valve, heat, alarm: bool;
        output count: u16;
        var n: u8 = 1;
        partial Guard {
            initial step Ready;
            step Stopped { force Main {INIT}; alarm; }
            Ready -[stop]-> Stopped -[!stop && 50ms/Stopped]-> Ready;
        }
        partial Main {
            initial step Rest { R valve; }
            step Fill { S valve; heat if 20ms/a/40ms; P1 n = n % 40 + 3; }
            step Heat { heat if blink(100ms/100ms); on rising(b) count = count + 1; }
            Rest -[rising(a)]-> Fill -[level > 20 || 3s/Fill]-> Heat -[falling(b) || Heat.T > 2s && n > 4]-> Rest;
        }
    }
}

#[derive(Clone, Copy, Default, PartialEq, Debug)]
enum Duty {
    #[default]
    Off,
    Eco,
    Full,
}

grafcet! {
    /// Levels that are floats, and enums that begin as their name and go on as an input's, in lists of two orders and in none.
    #[derive(Debug)]
    sfc Basin {
        input level: f32;
        input duty: Duty in {Off, Eco, Full};
        input ack: bool;
        output pump, alarm: bool;
        output shows: Duty = Duty::Off;
        var kept: Duty in {Off, Eco, Full} = Duty::Eco;
        var last: Duty in {Full, Off, Eco} = Duty::Full;
        var peak: f32 = -1.5;
        param low: f32 = 0.1;
        param base: Duty in {Off, Eco, Full} = Duty::Eco;
        initial step Rest;
        step Fill { N pump; P1 peak = level * 0.1 + peak; }
        step Done within 2s { P1 last = kept; P1 kept = duty; N alarm if kept == base && last != kept; P1 shows = last; }
        Rest -[level < low || ack]-> Fill -[duty != Duty::Off && peak < 1e30]-> Done;
        Fill -[3s/Fill]-> Rest;
        Done -[Done.late || kept == Duty::Full && !ack]-> Rest;
    }
}

grafcet! {
    /// Waits for a delay alone.
    sfc Slow {
        input a, other: bool;
        output lamp: bool;
        initial step Off;
        step On { N lamp; }
        Off -[1s/a]-> On -[!a && other]-> Off;
    }
}

/// The beginning is overwritten while a delay is under way: it goes on from there.
#[test]
fn a_delay_that_was_under_way_goes_on() {
    let mut recorder =
        Recorder::new(Slow::new(), [0; Recorder::<Slow, Memory<[u8; 0]>>::LEAST]).expect("enough memory");
    for cycle in 0..115_u32 {
        let inputs = SlowInputs { a: cycle >= 10, other: cycle % 2 == 0 };
        recorder.cycle(&inputs, cycle * 10, &mut ());
    }
    recorder.flush();
    let slow = source(include_str!("source.rs"), "Slow");
    let trace = Replay::new().run(&slow, recorder.record()).expect("a record");
    let begins = trace.cycles[0].now;
    assert!((150..1_100).contains(&begins), "a delay is under way at {begins}");
    // True since 100 ms.
    let lit = trace.cycles.iter().find(|cycle| cycle.outputs[0].is_true()).expect("it is lit");
    assert_eq!(lit.now, 1_100);
}

const CELL: &str = include_str!("../../../examples/charts/cell.rs");

/// A record of the cell with these inputs.
fn recorded(memory: usize, inputs: impl IntoIterator<Item = CellInputs>) -> Vec<u8> {
    let mut recorder = Recorder::new(Cell::new(), vec![0; memory]).expect("enough memory");
    for inputs in inputs {
        recorder.cycle(&inputs, 0_u32, &mut ());
    }
    recorder.flush();
    recorder.record().to_vec()
}

fn storm(cycles: usize) -> impl Iterator<Item = CellInputs> {
    let mut storm = Storm::<CellInputs>::new(3);
    std::iter::repeat_with(move || storm.cycle().0).take(cycles)
}

#[test]
fn another_version_is_no_silent_replay() {
    let record = recorded(100_000, storm(3_000));
    let changed = CELL.replace("Manual -[rising(auto)]-> Auto", "Manual -[auto]-> Auto");
    assert_ne!(changed, CELL);
    let changed = source(&changed, "Cell");
    let refused = Replay::new().run(&changed, &record);
    assert!(
        matches!(refused, Err(ReplayError::OtherChart { recorded, .. }) if recorded == Cell::FINGERPRINT),
        "{refused:?}"
    );
    let trace = Replay::new().even_if_changed().run(&changed, &record).expect("the same inputs");
    assert!(trace.warnings[0].starts_with("the record is of another chart or version"), "{:?}", trace.warnings);
    assert!(table(&trace).starts_with("! the record is of another chart or version"));
    // The first cycle that differs, for a regression test.
    let before = Replay::new().run(&source(CELL, "Cell"), &record).expect("a record");
    let difference = before.first_difference(&trace).expect("a difference");
    let (here, there) = (shown(&before, difference.cycle), shown(&trace, difference.cycle));
    assert_ne!(here, there);
    assert!((0..difference.cycle).all(|cycle| shown(&before, cycle) == shown(&trace, cycle)), "{difference}");
    assert_eq!(Replay::new().run(&changed, &[0; 500]), Err(ReplayError::NoRecord));
    // With fewer inputs or parameters than there were, nobody knows which of them is which.
    let fewer = [("estop, ack, auto", "estop, auto"), ("input estop", "input more: u8; input estop")];
    let fewer = fewer.map(|(from, to)| {
        assert!(CELL.contains(from), "{from}");
        let text = CELL.replace(from, to).replace("rising(ack)", "auto");
        Replay::new().even_if_changed().run(&source(&text, "Cell"), &record).err()
    });
    assert_eq!(fewer, [Some(ReplayError::More), Some(ReplayError::Values("estop".to_owned()))]);
}

/// What a record has become a test for.
#[test]
fn the_first_cycle_that_a_change_changes_is_told() {
    let (record, expected) = (include_bytes!("cell_stopped.record"), include_str!("cell_stopped.expected"));
    let compared = |from: &str, to: &str| {
        assert!(CELL.contains(from), "{from}");
        Replay::new().compare(&source(&CELL.replace(from, to), "Cell"), record, expected)
    };
    assert_eq!(compared("Feed", "Feed"), Ok(()));
    let changed =
        compared("Manual -[rising(auto)]-> Auto", "Manual -[rising(part)]-> Auto").expect_err("another chart");
    let said =
        "cycle 2 at 20 with the inputs auto is the first that differs\n  when recorded: steps Auto, Feed, Ready; ";
    assert!(changed.to_string().starts_with(said), "{changed}");
    let changed = compared("alarm", "alarm_").expect_err("another output");
    assert!(matches!(changed, Changed::Cycle { cycle: 0, .. }), "{changed}");
    let changed = compared("ack", "acknowledge").map_err(|changed| changed.to_string());
    assert_eq!(changed, Ok(()), "an input may have another name");
    let longer = expected.replace("16 cycles", "17 cycles");
    let changed = Replay::new().compare(&source(CELL, "Cell"), record, &longer);
    assert!(matches!(changed, Err(Changed::Cycles { expected: 17, found: 16, .. })), "{changed:?}");
    let torn = Replay::new().compare(&source(CELL, "Cell"), record, "0 steps Manual, Ready");
    assert_eq!(torn, Err(Changed::Expected(2)));
    let none = Replay::new().compare(&source(CELL, "Cell"), &[0; 99], expected);
    assert_eq!(none, Err(Changed::Replay(ReplayError::NoRecord)));
}

#[test]
fn a_wrapped_ring_says_what_is_missing() {
    let record = recorded(600, storm(3_000));
    let cell = source(CELL, "Cell");
    let trace = Replay::new().run(&cell, &record).expect("a record");
    let gap = trace.cycles[0].gap.as_ref().expect("a gap in front of the first cycle that is left");
    assert!(gap.reason.ends_with("blocks of the record were overwritten or are damaged"), "{gap:?}");
    assert!(gap.cycles.is_some_and(|cycles| cycles > 2_000), "{gap:?}");
    assert!(page(&cell, &trace).contains("overwritten"), "the page says so");
    assert!(table(&trace).contains("cycles, "), "the table says how many");
}

#[test]
fn a_state_from_outside_is_told() {
    let mut recorder = Recorder::new(Cell::new(), vec![0; 5_000]).expect("enough memory");
    recorder.cycle(&CellInputs::default(), 0_u32, &mut ());
    // A state that no inputs of the record explain.
    recorder.change(|cell| _ = cell.cycle(&CellInputs { auto: true, ..CellInputs::default() }));
    recorder.cycle(&CellInputs { auto: true, ..CellInputs::default() }, 0_u32, &mut ());
    recorder.flush();
    let trace = Replay::new().run(&source(CELL, "Cell"), recorder.record()).expect("a record");
    assert_eq!(trace.cycles.len(), 2);
    let said = "the chart was changed from outside after 1 cycles: active are Auto, Feed, Ready in the record, Manual, Ready in the replay";
    let gap = trace.cycles[1].gap.as_ref().expect("it is told in front of the next cycle");
    assert_eq!(gap.reason, said);
    // It goes on from where it was put: without a part it feeds, in `Auto`.
    assert_eq!(shown(&trace, 1).1, ["Auto", "Feed", "Ready"]);
}

const fn near(height: u8) -> bool {
    height > 100
}

grafcet! {
    /// Asks a function of the program.
    sfc Lift {
        input height: u8;
        output stop: bool;
        initial step Up;
        step Down { N stop; }
        Up -[near(height)]-> Down -[height == 0]-> Up;
    }
}

grafcet! {
    /// An output of which a part is stored.
    sfc Beside {
        input on: bool;
        output lamp: bool;
        initial step A { N lamp; }
        step B { S lamp; }
        step C { R lamp; }
        A -[on]-> B -[on]-> C -[!on]-> A;
    }
}

#[test]
fn the_stored_part_of_an_output_is_not_taken_for_the_output() {
    let mut recorder = Recorder::new(Beside::new(), vec![0; 5_000]).expect("enough memory");
    for on in [false, false, true, true, false, false, true] {
        recorder.cycle(&BesideInputs { on }, 0_u32, &mut ());
        // The record has the state here.
        recorder.change(|_| ());
    }
    let trace = Replay::new().run(&source(include_str!("source.rs"), "Beside"), recorder.record()).expect("a record");
    assert_eq!((trace.warnings.as_slice(), trace.gaps().count(), trace.cycles.len()), (&[][..], 0, 7));
}

#[test]
fn a_function_that_is_not_the_same_is_found() {
    let mut recorder = Recorder::new(Lift::new(), vec![0; 5_000]).expect("enough memory");
    for height in [0, 50, 120, 120, 120, 0, 0, 60, 60, 60] {
        recorder.cycle(&LiftInputs { height }, 0_u32, &mut ());
    }
    recorder.flush();
    let lift = source(include_str!("source.rs"), "Lift");
    let limit = |limit: i128| {
        let near = move |asked: &Asked<'_>| match asked.value("height")? {
            Value::Int(height) => Some(Value::Bool(height >= limit)),
            _ => None,
        };
        Replay::new().beside(Program::new().function(near)).run(&lift, recorder.record())
    };
    assert!(
        matches!(Replay::new().run(&lift, recorder.record()), Err(ReplayError::Chart(_))),
        "nobody says what it is"
    );
    assert_eq!(limit(101).expect("a record").warnings, [] as [&str; 0]);
    let other = limit(55).expect("a record");
    let said = "the replay differs from the record after 10 cycles: active are Up in the record, Down in the replay";
    assert!(other.warnings.iter().any(|text| text.contains(said)), "{:?}", other.warnings);
}

/// What came over a wire is run as a record in memory is.
#[test]
fn frames_show_what_the_record_shows() {
    let wire = Wire::new(Vec::new(), vec![0; wire_len::<Cell>()]).every(8, 30);
    let mut recorder = Recorder::both(Cell::new(), vec![0; 100_000], wire).expect("enough memory");
    let mut ends = Vec::new();
    for inputs in storm(1_000) {
        recorder.cycle(&inputs, 0_u32, &mut ());
        ends.push(recorder.keep().1.writer().len());
    }
    recorder.flush();
    let (record, bytes) = (recorder.keep().0.bytes(), recorder.keep().1.writer());
    let cell = source(CELL, "Cell");
    let expected = Replay::new().run(&cell, record).expect("a record");
    let trace = Replay::new().frames(&cell, bytes).expect("frames");
    assert_eq!((trace.warnings.len(), trace.gaps().count()), (0, 0), "{:?}", trace.warnings);
    assert_eq!(trace.first_difference(&expected), None);
    assert_eq!(trace.cycles.len(), expected.cycles.len());

    let motor = Motor::new();
    let other = Recorder::over(motor, Wire::new(Vec::new(), vec![0; wire_len::<Motor>()])).expect("enough memory");
    assert!(matches!(
        Replay::new().frames(&cell, other.keep().writer()),
        Err(ReplayError::OtherChart { recorded, .. }) if recorded == Motor::FINGERPRINT
    ));
    assert_eq!(Replay::new().frames(&cell, &bytes[..20]), Err(ReplayError::NoRecord));

    // A damaged byte in the middle: what was shown before is left, and what follows is a gap until the next state.
    let mut damaged = [&bytes[..], bytes].concat();
    damaged[ends[500] - 2] ^= 0x10;
    let trace = Replay::new().frames(&cell, &damaged).expect("frames");
    let reasons: Vec<&str> = trace.gaps().map(|(_, gap)| gap.reason.as_str()).collect();
    assert_eq!(reasons, ["a frame was damaged; a frame was lost", "the chart began anew here"]);
    let missing = 2 * expected.cycles.len() - trace.cycles.len();
    // A state comes after 30 cycles that are sent, and one more stands for those in front of it that did nothing.
    assert!((1..=31).contains(&missing), "{missing}");
}
