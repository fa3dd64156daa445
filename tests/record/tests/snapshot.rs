//! A snapshot goes on as if nothing had happened, and nothing but a snapshot is taken for one.

use std::fmt::Debug;

use grafcet::record::{Recordable, RestoreError, restore, snapshot, snapshot_len};
use grafcet::{Chart, Ticks};
use grafcet_record::branch_on_result::Sorter;
use grafcet_record::cell::Cell;
use grafcet_record::controller::{Called, Remote};
use grafcet_record::line24v::Line24V;
use grafcet_record::mixed::{Flags, Press, PressStep};
use grafcet_record::motor::Motor;
use grafcet_record::recipe::{self, Dyer};
use grafcet_record::tickless::Crossing;
use grafcet_record::wrong::check;
use grafcet_record::{Nobody, Storm};

/// Calls a test with each chart.
macro_rules! each {
    ($test:ident) => {
        $test(&Motor::new(), &mut ());
        $test(&Cell::new(), &mut ());
        $test(&Line24V::new(), &mut ());
        $test(&Sorter::new(), &mut ());
        $test(&Called::new(), &mut Nobody);
        $test(&Remote::new(), &mut Nobody);
        $test(&Crossing::new(), &mut ());
        $test(&Dyer::with_params(recipe::WOOL), &mut Nobody);
        $test(&Press::new(), &mut ());
        $test(&Flags::new(), &mut ());
    };
}

fn bytes_of<C: Recordable>(chart: &C) -> Vec<u8> {
    let mut bytes = vec![0xaa; snapshot_len::<C>() + 3];
    snapshot(chart, &mut bytes).expect("enough bytes").to_vec()
}

/// The power fails in any cycle: the clock goes on, or begins anew.
fn goes_on<C: Recordable<Outputs: PartialEq + Debug>>(chart: &C, actions: &mut C::Actions<'_>) {
    for seed in 0..30 {
        let mut storm = Storm::<C::Inputs>::new(seed);
        let (mut alone, mut resumed) = (chart.clone(), chart.clone());
        let (mut last, mut ahead) = (Ticks::ZERO, Ticks::ZERO);
        for cycle in 0..400 {
            if cycle % 7 == 3 {
                let bytes = bytes_of(&resumed);
                // Of the new clock in the last cycle.
                let reading = if cycle % 2 == 0 { last } else { Ticks::new(cycle) };
                resumed = restore(&bytes, reading).expect("a state that the chart was in");
                assert_eq!(bytes_of(&resumed), bytes);
                ahead = reading.since(last);
            }
            let (inputs, now) = storm.cycle();
            let outputs = alone.scan(&inputs, now, actions);
            assert_eq!(resumed.scan(&inputs, now.after(ahead), actions), outputs, "{} {seed}: {cycle}", C::NAME);
            assert_eq!(resumed.situation(), alone.situation(), "{} {seed}: {cycle}", C::NAME);
            assert!(resumed.is_same_state(&alone));
            last = now;
        }
    }
}

#[test]
fn a_chart_goes_on() {
    each!(goes_on);
}

/// Each wrong bit, each truncation, each longer one, in a few states.
fn is_refused<C: Recordable>(chart: &C, actions: &mut C::Actions<'_>) {
    let mut chart = chart.clone();
    let mut storm = Storm::<C::Inputs>::new(1);
    for _ in 0..20 {
        for _ in 0..10 {
            let (inputs, now) = storm.cycle();
            chart.scan(&inputs, now, actions);
        }
        let bytes = bytes_of(&chart);
        assert!(restore::<C>(&bytes, 0).is_ok());
        for bit in 0..bytes.len() * 8 {
            let mut wrong = bytes.clone();
            wrong[bit / 8] ^= 1 << (bit % 8);
            let error = restore::<C>(&wrong, 0).err();
            let expected = if bit < 32 { RestoreError::NoSnapshot } else { RestoreError::CheckSum };
            assert_eq!(error, Some(expected), "{}: bit {bit}", C::NAME);
        }
        let length = RestoreError::Length { expected: bytes.len() };
        for len in 0..bytes.len() {
            assert_eq!(restore::<C>(&bytes[..len], 0).err(), Some(length), "{}: {len} bytes", C::NAME);
        }
        assert_eq!(restore::<C>(&[&bytes[..], &[0]].concat(), 0).err(), Some(length));
    }
    assert_eq!(snapshot(&chart, &mut vec![0; snapshot_len::<C>() - 1]), None);
}

#[test]
fn damage_is_refused() {
    each!(is_refused);
}

fn is_not<C: Recordable, D: Recordable>(bytes: &[u8]) {
    if C::FINGERPRINT != D::FINGERPRINT {
        let other = RestoreError::OtherChart { fingerprint: C::FINGERPRINT };
        assert_eq!(restore::<D>(bytes, 0).err(), Some(other), "{} as {}", C::NAME, D::NAME);
    }
}

fn is_no_other<C: Recordable>(chart: &C, _: &mut C::Actions<'_>) {
    let bytes = bytes_of(chart);
    is_not::<C, Motor>(&bytes);
    is_not::<C, Cell>(&bytes);
    is_not::<C, Line24V>(&bytes);
    is_not::<C, Sorter>(&bytes);
    is_not::<C, Called>(&bytes);
    is_not::<C, Remote>(&bytes);
    is_not::<C, Crossing>(&bytes);
    is_not::<C, Dyer>(&bytes);
    is_not::<C, Press>(&bytes);
    is_not::<C, Flags>(&bytes);
}

#[test]
fn another_chart_is_refused() {
    each!(is_no_other);
}

/// The check sum of what somebody has changed.
fn forged(mut bytes: Vec<u8>, change: impl FnOnce(&mut [u8])) -> Vec<u8> {
    let content = bytes.len() - 4;
    change(&mut bytes[..content]);
    let sum = check(&bytes[..content]);
    bytes[content..].copy_from_slice(&sum);
    bytes
}

/// Every pattern of the first byte of the state, with a right check sum: what is taken is a situation that the chart can be in.
fn accepted<C: Recordable>(chart: &C) -> Vec<Vec<C::Step>> {
    let bytes = bytes_of(chart);
    let at = 12 + C::PARAM_BITS.div_ceil(8);
    let mut found = Vec::new();
    for value in 0..=u8::MAX {
        match restore::<C>(&forged(bytes.clone(), |bytes| bytes[at] = value), 0) {
            Ok(chart) => {
                let active: Vec<_> = C::STEPS.iter().copied().filter(|step| chart.is_active(*step)).collect();
                if !found.contains(&active) {
                    found.push(active);
                }
            }
            Err(error) => assert_eq!(error, RestoreError::Impossible),
        }
    }
    found
}

#[test]
fn impossible_situations_are_refused() {
    let possible: [&[PressStep]; 5] = [
        &[PressStep::Idle],
        &[PressStep::Close, PressStep::Heat],
        &[PressStep::Closed, PressStep::Heat],
        &[PressStep::Close, PressStep::Heated],
        &[PressStep::Closed, PressStep::Heated],
    ];
    let found = accepted(&Press::new());
    assert_eq!(found.len(), possible.len(), "{found:?}");
    assert!(possible.iter().all(|situation| found.iter().any(|found| found == situation)), "{found:?}");
    // As flags, with the bit of the first cycle.
    let found = accepted(&Flags::new());
    let mut names: Vec<_> = found.iter().map(|steps| format!("{steps:?}")).collect();
    names.sort();
    assert_eq!(names, ["[Close, Heat]", "[Close, Heated]", "[Closed, Heat]", "[Closed, Heated]", "[Idle]"]);
}

/// With flags the bit of the first cycle stands with those of initial steps alone, and after that cycle no others are set.
#[test]
fn the_first_cycle_begins_in_the_initial_situation() {
    const START: u8 = 1 << 5;
    let bytes = bytes_of(&Flags::new());
    let at = 12 + Flags::PARAM_BITS.div_ceil(8);
    let mut begun = Vec::new();
    for value in 0..=u8::MAX {
        let Ok(mut chart) = restore::<Flags>(&forged(bytes.clone(), |bytes| bytes[at] = value), 0) else { continue };
        if value & START != 0 {
            chart.scan(&<Flags as Chart>::Inputs::default(), Ticks::ZERO, &mut ());
            let active: Vec<_> = <Flags as Chart>::STEPS.iter().filter(|step| chart.is_active(**step)).collect();
            begun.push((value & !START & 0b11_1111, format!("{active:?}")));
        }
    }
    assert!(begun.len() > 1, "{begun:?}");
    // With their bits, or without.
    assert!(begun.iter().all(|(others, active)| *others <= 1 && active == "[Idle]"), "{begun:?}");
}

grafcet::grafcet! {
    sfc Ranged {
        input go: bool;
        output lamp: bool;
        param parts: u8 in 2..=5 = 3;
        initial step A;
        step B { lamp; }
        A -[go && parts > 2]-> B -[!go]-> A;
    }
}

/// A recipe that `set_params` refuses does not come in by a snapshot either.
#[test]
fn a_recipe_outside_of_its_range_is_refused() {
    let bytes = bytes_of(&Ranged::new());
    for parts in 0..=u8::MAX {
        let restored = restore::<Ranged>(&forged(bytes.clone(), |bytes| bytes[12] = parts), 0);
        assert_eq!(restored.map(|chart| chart.params().parts).ok(), (2..=5).contains(&parts).then_some(parts));
    }
}
