//! The optional features: what a chart derives reaches all its types, and the instants of other crates are times.

use std::collections::BTreeSet;

use grafcet::record::{RestoreError, Stored, snapshot_len};
use grafcet::{Ticks, grafcet};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

grafcet! {
    /// A lamp that goes out by itself.
    #[derive(Serialize, Deserialize, defmt::Format, Debug, Hash, Eq, PartialOrd)]
    #[cfg_attr(all(), derive(Ord))]
    #[cfg_attr(any(), derive(NoSuchTrait))]
    pub sfc Lamp {
        input push: bool;
        output lamp, warning: bool;
        output count: u16 = 3;
        param on_time: time = 30s;

        initial step Off;
        step Lit { lamp; D 25s warning; P1 count = count + 1; }

        Off -[push]-> Lit -[Lit.T >= on_time]-> Off;
    }
}

grafcet! {
    #[derive(Serialize, Deserialize, defmt::Format, Hash)]
    grafcet Stirrer {
        input go, fast, done: bool;
        output stir, heat: bool;
        output level: u8;

        initial step Idle;
        step Stir { stir; } step Stirred;
        step Heat { heat if 1s/fast/2s; P1 level = level + 1; } step Heated;

        Idle -[go]-> (Stir, Heat);
        Stir -[done]-> Stirred;
        Heat -[5s/Heat]-> Heated;
        (Stirred, Heated) -[!go]-> Idle;
    }
}

fn logged<T: defmt::Format>(_: &T) {}

fn is_hashed<T: std::hash::Hash>() {}

#[test]
fn derives_reach_every_type() {
    let lamp = Lamp::new();
    logged(&lamp);
    logged(&LampInputs::default());
    logged(&LampOutputs::default());
    logged(&LampParams::default());
    logged(&LampStep::Lit);
    logged(&lamp.situation());
    logged(&Stirrer::new().situation());
    is_hashed::<Lamp>();
    is_hashed::<LampParams>();
    is_hashed::<StirrerInputs>();
    is_hashed::<Stirrer>();
    assert!(LampOutputs { count: 3, ..Default::default() } < LampOutputs { count: 4, ..Default::default() });
    assert_eq!(BTreeSet::from([Lamp::new(), Lamp::default()]).len(), 1);
}

#[test]
fn a_stored_chart_goes_on_where_it_was() {
    type StoredLamp = Stored<{ snapshot_len::<Lamp>() }>;
    let mut lamp = Lamp::new();
    let push = LampInputs { push: true };
    lamp.cycle(&push, Ticks::new(1_000_000));
    lamp.cycle(&push, Ticks::new(1_000_010));
    lamp.cycle(&LampInputs::default(), Ticks::new(1_020_000));

    let stored = serde_json::to_string(&Stored::<{ snapshot_len::<Lamp>() }>::of(&lamp)).expect("bytes");
    let read: StoredLamp = serde_json::from_str(&stored).expect("what was stored");
    assert_eq!(read, Stored::of(&lamp));
    // The clock begins anew: lit for 19.99 s, and for 30 s in all.
    let mut again: Lamp = read.restore(7).expect("what was stored");
    for elapsed in [0, 5_009, 10_009, 10_010] {
        let (one, other) = (lamp.cycle(&push, 1_020_000 + elapsed), again.cycle(&push, 7 + elapsed));
        assert_eq!(one, other, "{elapsed}");
        assert_eq!(one.lamp, elapsed < 10_010, "{elapsed}");
        assert_eq!(serde_json::to_string(&one).expect("outputs"), serde_json::to_string(&other).expect("outputs"));
    }

    let mut stirrer = Stirrer::new();
    stirrer.cycle(&StirrerInputs { go: true, fast: true, done: false }, Ticks::new(1));
    let again: Stirrer = Stored::<{ snapshot_len::<Stirrer>() }>::of(&stirrer).restore(0).expect("what was stored");
    assert!(again.is_active(StirrerStep::Stir) && again.is_active(StirrerStep::Heat));
    assert_eq!(serde_json::to_string(&StirrerStep::Heat).expect("a name"), "\"Heat\"");
    assert!(serde_json::to_string(&stirrer).expect("a chart is plain data").contains("Heat"));
}

/// What `serde` reads back is checked, not believed.
#[test]
fn what_is_read_back_is_checked() {
    type StoredStirrer = Stored<{ snapshot_len::<Stirrer>() }>;
    let mut stirrer = Stirrer::new();
    stirrer.cycle(&StirrerInputs { go: true, fast: true, done: false }, Ticks::new(1));
    let bytes = StoredStirrer::of(&stirrer).as_bytes().to_vec();
    let read = |bytes: &[u8]| serde_json::from_str::<StoredStirrer>(&format!("{bytes:?}"));
    assert!(read(&bytes).expect("bytes").restore::<Stirrer>(0).is_ok());
    for bit in 0..bytes.len() * 8 {
        let mut bytes = bytes.clone();
        bytes[bit / 8] ^= 1 << (bit % 8);
        assert!(read(&bytes).expect("bytes").restore::<Stirrer>(0).is_err(), "bit {bit}");
    }
    for len in 0..bytes.len() {
        assert!(read(&bytes[..len]).is_err(), "{len} bytes");
    }
    assert!(read(&[&bytes[..], &[0]].concat()).is_err());
    let lamp = Stored::<{ snapshot_len::<Lamp>() }>::of(&Lamp::new());
    assert!(matches!(lamp.restore::<Stirrer>(0), Err(RestoreError::OtherChart { .. })));
}

/// Asks whether a type can be read back by itself.
struct Asked<T>(std::marker::PhantomData<T>);

impl<T: DeserializeOwned> Asked<T> {
    #[expect(clippy::unused_self, reason = "a method of the type goes before one of a trait")]
    fn is_read(&self) -> bool {
        true
    }
}

trait Otherwise {
    fn is_read(&self) -> bool {
        false
    }
}

impl<T> Otherwise for Asked<T> {}

/// The trait under other names, which the macro cannot know.
mod elsewhere {
    pub(super) use serde::Deserialize;
    pub(super) use serde::Deserialize as Read;
}
use elsewhere::Read;

grafcet! {
    #[derive(Read, Debug)]
    sfc Renamed {
        input push: bool;
        output lamp: bool;
        param lit: bool = true;
        initial step Off;
        step On { lamp if lit; }
        Off -[push]-> On -[!push]-> Off;
    }
}

grafcet! {
    #[cfg_attr(all(), derive(elsewhere::Deserialize))]
    grafcet Elsewhere {
        input push: bool;
        output lamp: bool;
        initial step Off;
        initial step Waits;
        step On { lamp; }
        step Done;
        Off -[push]-> On -[!push]-> Off;
        Waits -[push]-> Done -[!push]-> Waits;
    }
}

/// A chart that derives `Deserialize` is read back through [`Stored`] alone, whatever the trait is called there; what surrounds it, as any data.
#[test]
fn no_chart_is_read_back_by_itself() {
    macro_rules! is_read {
        ($($ty:ty),*) => {[$(Asked::<$ty>(std::marker::PhantomData).is_read()),*]};
    }
    assert_eq!(is_read!(Lamp, Stirrer, Renamed, Elsewhere), [false; 4]);
    assert_eq!(is_read!(LampInputs, LampOutputs, LampParams, LampStep, StirrerInputs), [true; 5]);
    assert_eq!(is_read!(RenamedInputs, RenamedOutputs, RenamedParams, RenamedStep, ElsewhereSituation), [true; 5]);
}

#[test]
fn instants_of_other_crates_are_times() {
    type Millis = fugit::MonotonicTimerInstantU64<1_000>;
    type Millis32 = fugit::WrappingTimerInstantU32<1_000>;
    let mut lamp = Lamp::new();
    let push = LampInputs { push: true };
    lamp.cycle(&push, Millis::from_ticks(5));
    assert!(lamp.cycle(&push, Millis::from_ticks(10)).lamp);
    assert!(!lamp.cycle(&push, Millis32::from_ticks(10 + 30_000)).lamp);
    assert!(lamp.cycle(&push, embassy_time::Instant::from_ticks(40_011)).lamp);
    // What counts further than 32 bits wraps around.
    assert_eq!(Ticks::from(embassy_time::Instant::from_ticks((1 << 32) + 7)), Ticks::new(7));
}
