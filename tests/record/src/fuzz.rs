//! What a fuzzer calls with any bytes (`fuzz/`), and a test with those of its corpus: nothing panics, and what is shown is true.

use std::fmt::Debug;

use grafcet::Ticks;
use grafcet::record::steer::{Command, Commands, Request, Wanted, command_len, request_len};
use grafcet::record::wire::{Follow, Seen, Wire, frame_len, wire_len};
use grafcet::record::{Reader, Record, Recordable, Recorder, Records, Writer, replay, restore, snapshot, snapshot_len};
use grafcet_sim::{Chart, Replay, Trace};

use crate::Nobody;
use crate::cell::Cell;
use crate::mixed::{Flags, Press, PressParams};
use crate::motor::Motor;
use crate::recipe::{self, Dyer};
use crate::tickless::Crossing;
use crate::wrong::{frame, record_of, snapshot_of};

/// A target, and what it is called.
pub type Target = (&'static str, fn(&[u8]));

/// All of them.
pub const TARGETS: [Target; 5] =
    [("record", record), ("frames", frames), ("snapshot", restored), ("cycles", cycles), ("commands", commands)];

/// A visitor of charts, each with its source and a way to change it from outside.
trait Visit {
    fn chart<C: Recordable<Outputs: Debug>>(
        &self,
        chart: &C,
        actions: &mut C::Actions<'_>,
        file: &'static str,
        change: fn(&mut C, u8),
        bytes: &[u8],
    );
}

/// The first byte says which chart.
fn visit(visitor: &impl Visit, bytes: &[u8]) {
    let Some((which, bytes)) = bytes.split_first() else { return };
    let mixed = include_str!("mixed.rs");
    match which % 6 {
        0 => visitor.chart(&Cell::new(), &mut (), include_str!("../../../examples/charts/cell.rs"), |_, _| {}, bytes),
        1 => {
            let file = include_str!("../../../examples/charts/recipe.rs");
            let change = |dyer: &mut Dyer, which: u8| {
                dyer.set_params(if which % 2 == 0 { recipe::WOOL } else { recipe::COTTON });
            };
            visitor.chart(&Dyer::with_params(recipe::WOOL), &mut Nobody, file, change, bytes);
        }
        2 => {
            let file = include_str!("../../../examples/charts/tickless.rs");
            visitor.chart(&Crossing::new(), &mut (), file, |_, _| {}, bytes);
        }
        3 => {
            let change = |press: &mut Press, which: u8| {
                press.set_params(PressParams { limit: Ticks::new(u32::from(which) << (which % 24)) });
            };
            visitor.chart(&Press::new(), &mut (), mixed, change, bytes);
        }
        4 => visitor.chart(&Flags::new(), &mut (), mixed, |_, _| {}, bytes),
        _ => visitor.chart(&Motor::new(), &mut (), include_str!("../../../examples/charts/motor.rs"), |_, _| {}, bytes),
    }
}

/// A chart from its source; parsed once.
fn source(file: &'static str, name: &'static str) -> &'static Chart {
    thread_local! {
        static ALL: std::cell::RefCell<Vec<(&'static str, &'static Chart)>> = const { std::cell::RefCell::new(Vec::new()) };
    }
    ALL.with_borrow_mut(|all| {
        if let Some((_, chart)) = all.iter().find(|(known, _)| *known == name) {
            return *chart;
        }
        let chart = Chart::in_file(file, name).unwrap_or_else(|refused| panic!("{name}: {refused}"));
        let chart: &'static Chart = Box::leak(Box::new(chart));
        all.push((name, chart));
        chart
    })
}

/// Bytes as a record in memory: as they are, or as blocks after the right heads and check sums.
pub fn record(bytes: &[u8]) {
    struct Reads;
    impl Visit for Reads {
        fn chart<C: Recordable<Outputs: Debug>>(
            &self,
            _: &C,
            actions: &mut C::Actions<'_>,
            file: &'static str,
            _: fn(&mut C, u8),
            bytes: &[u8],
        ) {
            let Some((how, bytes)) = bytes.split_first() else { return };
            let mended: Vec<u8>;
            let memory = match how % 8 {
                0 | 1 => bytes,
                blocks => {
                    let parts: Vec<&[u8]> = bytes.chunks(bytes.len().div_ceil(usize::from(blocks)).max(1)).collect();
                    mended = record_of::<C>(24 + 200, &parts);
                    &mended
                }
            };
            if let Ok(records) = Records::of(memory) {
                _ = replay::<C>(&records, actions, |_| {});
            }
            _ = Replay::new().run(source(file, C::NAME), memory);
        }
    }
    visit(&Reads, bytes);
}

/// Bytes as what comes over a wire: as they are, or each 0xff ending a frame with the right check sum.
pub fn frames(bytes: &[u8]) {
    struct Follows;
    impl Visit for Follows {
        fn chart<C: Recordable<Outputs: Debug>>(
            &self,
            _: &C,
            actions: &mut C::Actions<'_>,
            file: &'static str,
            _: fn(&mut C, u8),
            bytes: &[u8],
        ) {
            let Some((how, bytes)) = bytes.split_first() else { return };
            let sent: Vec<u8> = match how % 4 {
                0 => bytes.to_vec(),
                // Right numbers, kinds, fingerprints and layouts, so that what follows is looked at.
                1 => bytes
                    .split(|byte| *byte == 0xff)
                    .enumerate()
                    .flat_map(|(n, part)| frame(&mended::<C>(n, part)))
                    .collect(),
                _ => bytes.split(|byte| *byte == 0xff).flat_map(frame).collect(),
            };
            let mut follow = Follow::<C, _>::new(vec![0; frame_len::<C>()]);
            follow.bytes(&sent, actions, |_| {});
            _ = Replay::new().frames(source(file, C::NAME), &sent);
        }
    }
    visit(&Follows, bytes);
}

/// What a frame with this number says, of a kind that its first byte chooses.
fn mended<C: Recordable>(number: usize, part: &[u8]) -> Vec<u8> {
    let (kind, rest) = part.split_first().map_or((0, part), |(kind, rest)| (kind % 4, rest));
    let kind = if number == 0 { 1 } else { kind.max(1) };
    let mut content = vec![0x10 | kind];
    content.extend(u16::try_from(number).unwrap_or(1).to_le_bytes());
    if kind == 1 {
        content.extend([C::FINGERPRINT.to_le_bytes(), C::LAYOUT.to_le_bytes()].concat());
    }
    content.extend(rest);
    content
}

/// Bytes as the values of a snapshot: what is taken is a state that is stored in the same way, and from which the chart can go on.
pub fn restored(bytes: &[u8]) {
    struct Restores;
    impl Visit for Restores {
        fn chart<C: Recordable<Outputs: Debug>>(
            &self,
            _: &C,
            actions: &mut C::Actions<'_>,
            _: &'static str,
            _: fn(&mut C, u8),
            bytes: &[u8],
        ) {
            _ = restore::<C>(bytes, 0);
            let stored = snapshot_of::<C>(bytes);
            let now = bytes.iter().fold(0_u32, |now, byte| now.rotate_left(5) ^ u32::from(*byte));
            let Ok(mut chart) = restore::<C>(&stored, now) else { return };
            // What a time was left with of which nothing is to come is not stored, so the first one may have held something else there.
            let (mut first, mut second) = (vec![0; snapshot_len::<C>()], vec![0; snapshot_len::<C>()]);
            let again =
                snapshot(&chart, &mut first).and_then(|stored| restore::<C>(stored, now).ok()).expect("restored again");
            assert!(again.is_same_state(&chart));
            assert_eq!(snapshot(&again, &mut second), Some(&first[..]));
            let inputs = C::Inputs::default();
            for cycle in 0..4 {
                _ = chart.wakes_at();
                _ = chart.situation();
                chart.scan(&inputs, Ticks::new(now).after(Ticks::new(cycle * 700)), actions);
            }
        }
    }
    visit(&Restores, bytes);
}

/// So many cycles the controller has made that reads commands, and so many old one is at most.
const CYCLES: u32 = 1_000;
const OLDEST: u32 = 300;

/// Bytes as what a controller hears: as they are, or each 0xff ending a frame with the right check sum. What it takes is new, and what a host writes who wants the same.
pub fn commands(bytes: &[u8]) {
    struct Hears;
    impl Visit for Hears {
        fn chart<C: Recordable<Outputs: Debug>>(
            &self,
            _: &C,
            _: &mut C::Actions<'_>,
            _: &'static str,
            _: fn(&mut C, u8),
            bytes: &[u8],
        ) {
            let Some((how, bytes)) = bytes.split_first() else { return };
            let sent: Vec<u8> = match how % 4 {
                0 => bytes.to_vec(),
                // For this chart, with the next number and not too old, so that what follows is looked at.
                1 | 2 => bytes
                    .split(|byte| *byte == 0xff)
                    .enumerate()
                    .flat_map(|(n, part)| frame(&command::<C>(n, part)))
                    .collect(),
                _ => bytes.split(|byte| *byte == 0xff).flat_map(frame).collect(),
            };
            let (mut commands, mut last) = (hearing::<C>(), 0);
            for byte in sent {
                match commands.push(byte, CYCLES) {
                    None => {}
                    Some(Err(answer)) => assert!(answer.outcome.is_err(), "{answer:?}"),
                    Some(Ok(command)) => {
                        assert!(command.number > last, "{} after {last}", command.number);
                        last = command.number;
                        is_heard_again::<C>(&command);
                    }
                }
            }
            assert!(commands.last() >= last);
        }
    }
    visit(&Hears, bytes);
}

fn hearing<C: Recordable>() -> Commands<C, Vec<u8>, Vec<C::Step>> {
    Commands::new(vec![0; command_len::<C>()], C::STEPS.to_vec(), OLDEST)
}

/// The content of a command with what `part` wants.
fn command<C: Recordable>(number: usize, part: &[u8]) -> Vec<u8> {
    let (age, wanted) = part.split_first().map_or((0, part), |(age, wanted)| (*age, wanted));
    let (number, seen) = (number as u64 + 1, CYCLES - u32::from(age));
    [&[0x15][..], &number.to_le_bytes(), &C::FINGERPRINT.to_le_bytes(), &seen.to_le_bytes(), wanted].concat()
}

/// A host that wants what was taken writes a command that is taken as the same.
fn is_heard_again<C: Recordable>(taken: &Command<'_, C::Step>) {
    let place = |step: &C::Step| C::STEPS.iter().position(|other| other == step);
    let placed = |wanted: &Wanted<'_, C::Step>| match wanted {
        Wanted::Force(steps) => steps.iter().filter_map(place).collect(),
        Wanted::Init | Wanted::Push | Wanted::Mode(_) => Vec::new(),
    };
    let steps: Vec<usize> = placed(&taken.wanted);
    let wanted = match taken.wanted {
        Wanted::Init => Wanted::Init,
        Wanted::Push => Wanted::Push,
        Wanted::Mode(mode) => Wanted::Mode(mode),
        Wanted::Force(_) => Wanted::Force(&steps),
    };
    let all = C::STEPS.len();
    let request = Request { number: taken.number, fingerprint: C::FINGERPRINT, steps: all, seen: CYCLES, wanted };
    let mut buffer = vec![0; request_len(all)];
    let sent = request.write(&mut buffer).expect("as many bytes as it takes");
    let mut commands = hearing::<C>().after(taken.number - 1);
    let mut heard = 0;
    for byte in sent {
        let Some(found) = commands.push(*byte, CYCLES) else { continue };
        let again = found.expect("what was taken");
        let kinds = [&again.wanted, &taken.wanted].map(std::mem::discriminant);
        assert_eq!((again.number, placed(&again.wanted), kinds[0]), (taken.number, steps.clone(), kinds[1]));
        if let (Wanted::Mode(one), Wanted::Mode(other)) = (again.wanted, taken.wanted) {
            assert_eq!(one, other);
        }
        heard += 1;
    }
    assert_eq!(heard, 1);
}

/// How much time passes in front of a cycle.
const STEPS: [u32; 8] = [0, 1, 10, 500, 5_000, 40_000, 1 << 30, LONGEST];
/// The longest time between two cycles.
const LONGEST: u32 = (1 << 31) - 1;

/// Bytes as inputs, recipes, `init`, and jumps of the clock: what the compiled chart shows is what its source shows, by its record and by its frames.
pub fn cycles(bytes: &[u8]) {
    struct Runs;
    impl Visit for Runs {
        fn chart<C: Recordable<Outputs: Debug>>(
            &self,
            chart: &C,
            actions: &mut C::Actions<'_>,
            file: &'static str,
            change: fn(&mut C, u8),
            bytes: &[u8],
        ) {
            runs(chart, actions, source(file, C::NAME), change, bytes);
        }
    }
    visit(&Runs, bytes);
}

/// More cycles of one run show nothing new.
const MOST: usize = 400;

fn runs<C: Recordable<Outputs: Debug>>(
    chart: &C,
    actions: &mut C::Actions<'_>,
    source: &Chart,
    change: fn(&mut C, u8),
    bytes: &[u8],
) {
    let wire = Wire::new(Vec::new(), vec![0; wire_len::<C>()]).every(6, 40);
    let mut recorder = Recorder::both(chart.clone(), vec![0; 1 << 16], wire).expect("enough memory");
    let mut written = vec![0; C::Inputs::BITS.div_ceil(8)];
    C::Inputs::default().write(&mut Writer::new(&mut written));
    let (mut inputs, mut now) = (C::Inputs::default(), 0_u32);
    let mut seen = Vec::new();
    let mut bytes = bytes.iter().copied();
    while let (Some(what), true) = (bytes.next(), seen.len() < MOST) {
        match what >> 5 {
            0 if what == 0 => recorder.change(C::init),
            0 => recorder.change(|chart| change(chart, what)),
            1 | 2 => {
                // Another bit, if that is an input.
                let bit = usize::from(what & 0x3f) % C::Inputs::BITS.max(1);
                let mut other = written.clone();
                other[bit / 8] ^= 1 << (bit % 8);
                if let Some(read) = C::Inputs::read(&mut Reader::new(&other)) {
                    (inputs, written) = (read, other);
                }
                continue;
            }
            _ => {
                let step = STEPS[usize::from(what & 7)] + u32::from(what >> 3 & 3);
                now = now.wrapping_add(step.min(LONGEST));
            }
        }
        let outputs = recorder.cycle(&inputs, now, actions);
        seen.push(shown(recorder.chart(), now, &outputs));
    }
    recorder.flush();
    let (memory, wire) = recorder.keep();
    let (record, sent) = (memory.bytes(), wire.writer());
    let by_frames = Replay::new().frames(source, sent);
    let records = Records::of(record).expect("a record");
    let mut moments = 0;
    let replayed = replay::<C>(&records, actions, |moment| {
        assert_eq!(shown(moment.chart, moment.now.get(), &moment.outputs).1, seen[moment.cycle as usize].1);
        moments += 1;
    });
    assert_eq!(replayed, Ok(()));
    let mut follow = Follow::<C, _>::new(vec![0; frame_len::<C>()]);
    follow.bytes(sent, actions, |what| {
        if let Seen::Trouble(trouble) = what {
            panic!("{trouble:?}");
        }
    });
    for trace in [Replay::new().run(source, record), by_frames] {
        // Arithmetic that leaves its type is an error there.
        let Ok(trace) = trace else { continue };
        assert_eq!(trace.warnings, [] as [&str; 0]);
        let mut number = 0;
        for (index, cycle) in trace.cycles.iter().enumerate() {
            number += cycle.skipped as usize;
            let (then, expected) = &seen[number];
            assert!(!C::TIMED || cycle.now == *then, "cycle {number} at {then}, and not at {}", cycle.now);
            assert_eq!(traced(&trace, index), *expected, "cycle {number} at {then}");
            number += 1;
        }
        assert_eq!(number, seen.len(), "all cycles are shown");
    }
}

/// The time, and active steps and outputs as text.
fn shown<C: Recordable<Outputs: Debug>>(chart: &C, now: u32, outputs: &C::Outputs) -> (u32, String) {
    let steps: Vec<C::Step> = C::STEPS.iter().copied().filter(|step| chart.is_active(*step)).collect();
    (now, told(&steps, outputs))
}

/// Steps, in the order of their names, and outputs as text.
pub fn told(steps: &[impl ToString], outputs: &impl Debug) -> String {
    let mut steps: Vec<String> = steps.iter().map(ToString::to_string).collect();
    steps.sort_unstable();
    format!("{} {outputs:?}", steps.join(" "))
}

/// A cycle of a trace in the same form.
#[must_use]
pub fn traced(trace: &Trace, cycle: usize) -> String {
    let (names, cycle) = (&trace.names, &trace.cycles[cycle]);
    let mut steps: Vec<&str> = cycle.steps.iter().map(|step| names.steps[*step].name.as_str()).collect();
    steps.sort_unstable();
    let outputs = names.outputs.iter().zip(&cycle.outputs).map(|(output, value)| format!("{}: {value}", output.name));
    let outputs: Vec<String> = outputs.collect();
    let outputs = if outputs.is_empty() { String::new() } else { format!(" {{ {} }}", outputs.join(", ")) };
    format!("{} {}Outputs{outputs}", steps.join(" "), names.chart)
}
