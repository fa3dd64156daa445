//! What comes over a wire shows what has happened, or says that it does not know.

use std::fmt::Debug;

use embedded_io::ErrorType;
use grafcet::grafcet;
use grafcet::record::wire::{Follow, Seen, Trouble, Wire, frame_len, wire_len};
use grafcet::record::{Damage, Recordable, Recorder, Records, replay};
use grafcet_record::branch_on_result::Sorter;
use grafcet_record::cell::{Cell, CellInputs};
use grafcet_record::controller::{Called, Remote};
use grafcet_record::line24v::Line24V;
use grafcet_record::motor::{Motor, MotorInputs};
use grafcet_record::recipe::{self, Dyer};
use grafcet_record::tickless::Crossing;
use grafcet_record::{Nobody, Storm};

/// What a cycle has shown.
type Shown<C> = (<C as grafcet::Chart>::Outputs, <C as grafcet::Chart>::Situation);

fn none() -> &'static mut () {
    Box::leak(Box::new(()))
}

fn wire<C: Recordable>() -> Wire<Vec<u8>, Vec<u8>> {
    Wire::new(Vec::new(), vec![0xaa; wire_len::<C>()])
}

fn follow<C: Recordable>() -> Follow<C, Vec<u8>> {
    Follow::new(vec![0x55; frame_len::<C>()])
}

/// What was seen of a chart, cycle by cycle as far as it is known, and all the rest in words.
struct Seeing<'s, C: Recordable> {
    shown: &'s [Shown<C>],
    /// The cycle after the last that was seen.
    next: Option<usize>,
    seen: usize,
    /// What was missing, and the cycle that was seen before.
    troubles: Vec<(Trouble, Option<usize>)>,
    begins: usize,
}

impl<'s, C: Recordable<Outputs: PartialEq + Debug>> Seeing<'s, C> {
    fn of(shown: &'s [Shown<C>]) -> Self {
        Self { shown, next: None, seen: 0, troubles: Vec::new(), begins: 0 }
    }

    fn see(&mut self, seen: Seen<'_, C>) {
        match seen {
            Seen::Cycle(moment) => {
                let cycle = moment.cycle as usize;
                for skipped in self.next.unwrap_or(cycle)..cycle {
                    assert_eq!(self.shown[skipped], self.shown[skipped - 1], "{}: skipped cycle {skipped}", C::NAME);
                }
                let now = (moment.outputs, moment.chart.situation());
                assert_eq!(now, self.shown[cycle], "{}: cycle {cycle}", C::NAME);
                self.next = Some(cycle + 1);
                self.seen += 1;
            }
            Seen::Begins => self.begins += 1,
            Seen::Trouble(trouble) => {
                self.troubles.push((trouble, self.next));
                self.next = None;
            }
        }
    }
}

/// Runs a chart whose record goes over a wire: the host sees all of it.
fn is_seen<C>(chart: &C, actions: fn() -> &'static mut C::Actions<'static>)
where
    C: Recordable<Outputs: PartialEq + Debug>,
{
    for seed in 0..10 {
        let mut alone = chart.clone();
        let mut recorder = Recorder::both(chart.clone(), vec![0; 800], wire::<C>()).expect("enough memory");
        let mut storm = Storm::<C::Inputs>::new(seed);
        let mut shown: Vec<Shown<C>> = Vec::new();
        for cycle in 0..2_000 {
            if cycle % 700 == 699 {
                recorder.change(C::init);
                alone.init();
            }
            let (inputs, now) = storm.cycle();
            let outputs = alone.scan(&inputs, now, actions());
            assert_eq!(recorder.cycle(&inputs, now, actions()), outputs);
            shown.push((outputs, alone.situation()));
            if seed % 2 == 1 && cycle % 13 == 0 {
                recorder.tell_state();
            }
        }
        recorder.flush();
        let mut seeing = Seeing::<C>::of(&shown);
        let mut host = follow::<C>();
        host.bytes(recorder.keep().1.writer(), actions(), |seen| seeing.see(seen));
        assert_eq!(seeing.troubles, [], "{} {seed}", C::NAME);
        assert_eq!((seeing.begins, seeing.next), (1, Some(2_000)), "{} {seed}", C::NAME);
        // The record in memory is as good as without the wire.
        let records = Records::of(recorder.keep().0.bytes()).expect("a record");
        let replayed = replay::<C>(&records, actions(), |moment| {
            assert_eq!((moment.outputs, moment.chart.situation()), shown[moment.cycle as usize]);
        });
        assert_eq!(replayed, Ok(()), "{} {seed}", C::NAME);
    }
}

#[test]
fn the_host_sees_what_happens() {
    is_seen(&Motor::new(), none);
    is_seen(&Cell::new(), none);
    is_seen(&Line24V::new(), none);
    is_seen(&Sorter::new(), none);
    is_seen(&Crossing::new(), none);
    is_seen(&Dyer::with_params(recipe::WOOL), || Box::leak(Box::new(Nobody)));
    is_seen(&Called::new(), || Box::leak(Box::new(Nobody)));
    is_seen(&Remote::new(), || Box::leak(Box::new(Nobody)));
}

/// A storm over the cell: what it has shown, and the bytes on the wire.
fn storm(cycles: usize) -> (Vec<Shown<Cell>>, Vec<u8>) {
    let mut recorder = Recorder::over(Cell::new(), wire::<Cell>().every(4, 20)).expect("enough memory");
    let mut storm = Storm::<CellInputs>::new(7);
    let shown = (0..cycles).map(|_| {
        let (inputs, now) = storm.cycle();
        (recorder.cycle(&inputs, now, &mut ()), recorder.chart().situation())
    });
    (shown.collect(), recorder.keep().writer().clone())
}

fn seen<'s>(shown: &'s [Shown<Cell>], bytes: &[u8]) -> Seeing<'s, Cell> {
    let mut seeing = Seeing::of(shown);
    follow::<Cell>().bytes(bytes, &mut (), |seen| seeing.see(seen));
    seeing
}

/// One bit after the other is wrong: nothing is shown that was not, the error is told, and what follows is seen again.
#[test]
fn every_wrong_bit_is_told() {
    let (shown, bytes) = storm(300);
    let whole = seen(&shown, &bytes);
    assert!(whole.seen > 80 && whole.troubles.is_empty(), "{}", whole.seen);
    // What stands after the last state can be lost without a frame that tells.
    let last_state = bytes.len() - 200;
    for bit in 0..bytes.len() * 8 {
        let mut bytes = bytes.clone();
        bytes[bit / 8] ^= 1 << (bit % 8);
        let found = seen(&shown, &bytes);
        assert!(bit < 8 || !found.troubles.is_empty() || bit / 8 > last_state, "bit {bit}");
        assert!(found.seen + 60 > whole.seen, "bit {bit}: {} of {}", found.seen, whole.seen);
        assert!(found.next == whole.next || bit / 8 > last_state, "bit {bit}");
    }
}

/// A frame is missing, or comes twice, or after the next one.
#[test]
fn every_lost_frame_is_told() {
    let (shown, bytes) = storm(300);
    let frames: Vec<&[u8]> = bytes.split_inclusive(|byte| *byte == 0).collect();
    // A zero in front of all that is sent, and the state at the begin.
    for missing in 1..frames.len() - 1 {
        let without = [&frames[..missing], &frames[missing + 1..]].concat().concat();
        let found = seen(&shown, &without);
        // Whoever comes late does not miss anything that the wire could tell.
        let expected: &[Trouble] = if missing == 1 { &[] } else { &[Trouble::Lost { frames: 1 }] };
        assert!(found.troubles.iter().map(|trouble| &trouble.0).eq(expected), "{missing}: {:?}", found.troubles);
        let twice = [&frames[..=missing], &frames[missing..]].concat().concat();
        assert!(missing == 1 || !seen(&shown, &twice).troubles.is_empty(), "{missing}");
        let mut swapped = frames.clone();
        swapped.swap(missing, missing + 1);
        assert!(!seen(&shown, &swapped.concat()).troubles.is_empty(), "{missing}");
    }
    for begin in 0..bytes.len() - 1 {
        let found = seen(&shown, &bytes[begin..]);
        assert!(found.troubles.iter().all(|trouble| trouble.0 == Trouble::Damaged), "{:?}", found.troubles);
        assert!(begin > bytes.len() - 400 || found.next.is_some(), "{begin}");
    }
}

#[test]
fn a_number_that_wraps_around_is_no_loss() {
    let mut recorder = Recorder::over(Motor::new(), wire::<Motor>().every(0, 100)).expect("enough memory");
    let mut host = follow::<Motor>();
    let (mut sent, mut shown) = (0, 0);
    for cycle in 0..70_000_u32 {
        recorder.cycle(&MotorInputs { on: cycle % 2 == 0, ..MotorInputs::default() }, 0_u32, &mut ());
        let bytes = recorder.keep().writer();
        host.bytes(&bytes[sent..], &mut (), |seen| match seen {
            Seen::Cycle(_) => shown += 1,
            Seen::Begins => {}
            Seen::Trouble(trouble) => panic!("cycle {cycle}: {trouble:?}"),
        });
        sent = bytes.len();
    }
    assert_eq!(shown, 70_000);
}

#[test]
fn another_chart_is_told() {
    let mut recorder = Recorder::over(Motor::new(), wire::<Motor>()).expect("enough memory");
    for cycle in 0..10_u32 {
        recorder.cycle(&MotorInputs { on: cycle % 3 == 0, ..MotorInputs::default() }, 0_u32, &mut ());
    }
    let motor = recorder.keep().writer();
    let (shown, cell) = storm(100);
    let found = seen(&shown, &[&cell[..], motor, &cell].concat());
    let expected = Trouble::Damage(Damage::OtherChart { fingerprint: Motor::FINGERPRINT });
    assert!(found.troubles.iter().map(|trouble| &trouble.0).eq(&[expected]), "{:?}", found.troubles);
    assert_eq!(found.begins, 3, "the controller has started anew twice");
    assert_eq!(found.seen, 2 * seen(&shown, &cell).seen);
}

thread_local! { static LIMIT: std::cell::Cell<u8> = const { std::cell::Cell::new(100) }; }

/// Depends on more than its argument.
fn moody(height: u8) -> bool {
    height > LIMIT.get()
}

grafcet! {
    sfc Moody {
        input height: u8;
        output stop: bool;
        initial step Up;
        step Down { N stop; }
        Up -[moody(height)]-> Down -[height == 0]-> Up;
    }
}

/// A function that is not pure: the hash of the state finds it, and what follows it is not shown.
#[test]
fn a_function_that_is_not_pure_is_found() {
    let mut recorder = Recorder::over(Moody::new(), wire::<Moody>().every(4, 100)).expect("enough memory");
    LIMIT.set(100);
    for height in [0, 10, 120, 20, 0, 60, 61, 62, 63, 64, 65, 66, 67, 68] {
        recorder.cycle(&MoodyInputs { height }, 0_u32, &mut ());
    }
    let bytes = recorder.keep().writer().clone();
    let diverged = |limit| {
        LIMIT.set(limit);
        let (mut found, mut shown) = (Vec::new(), 0);
        follow::<Moody>().bytes(&bytes, &mut (), |seen| match seen {
            Seen::Cycle(_) => shown += 1,
            Seen::Begins => {}
            Seen::Trouble(trouble) => found.push(trouble),
        });
        (found, shown)
    };
    assert_eq!(diverged(100), (Vec::new(), 14));
    assert_eq!(diverged(50), (vec![Trouble::Diverged { cycle: 8 }], 8));
}

/// A line that takes nothing any more from time to time.
struct Busy {
    line: Vec<u8>,
    calls: usize,
}

impl ErrorType for Busy {
    type Error = Full;
}

#[derive(Debug)]
struct Full;

impl std::fmt::Display for Full {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("the queue is full")
    }
}

impl std::error::Error for Full {}

impl embedded_io::Error for Full {
    fn kind(&self) -> embedded_io::ErrorKind {
        embedded_io::ErrorKind::OutOfMemory
    }
}

impl embedded_io::Write for Busy {
    fn write(&mut self, bytes: &[u8]) -> Result<usize, Full> {
        self.calls += 1;
        // Sometimes the begin of a frame gets through.
        match self.calls % 23 {
            9 => self.line.extend(&bytes[..1]),
            10..13 => return Err(Full),
            // No writer should, but a queue that is full may.
            17 => return Ok(0),
            _ => {
                self.line.extend(bytes);
                return Ok(bytes.len());
            }
        }
        Ok(1)
    }

    fn flush(&mut self) -> Result<(), Full> {
        Ok(())
    }
}

#[test]
fn a_line_that_fails_costs_frames_and_nothing_else() {
    let line = Wire::new(Busy { line: Vec::new(), calls: 0 }, vec![0; wire_len::<Cell>()]);
    let mut recorder = Recorder::over(Cell::new(), line).expect("enough memory");
    let mut storm = Storm::<CellInputs>::new(7);
    let mut shown = Vec::new();
    for _ in 0..2_000 {
        let (inputs, now) = storm.cycle();
        shown.push((recorder.cycle(&inputs, now, &mut ()), recorder.chart().situation()));
    }
    let found = seen(&shown, &recorder.keep().writer().line);
    let lost = found.troubles.iter().filter(|(trouble, _)| matches!(trouble, Trouble::Lost { .. })).count();
    assert!(lost > 10 && found.seen > 400, "{lost} {}", found.seen);
}

/// The buffer is as long as the longest frame needs, and a shorter one is refused.
#[test]
fn a_buffer_that_is_too_short_is_refused() {
    let short = Wire::new(Vec::<u8>::new(), vec![0; wire_len::<Cell>() - 1]);
    assert!(Recorder::over(Cell::new(), short).is_err_and(|small| small.needed == wire_len::<Cell>()));
}
