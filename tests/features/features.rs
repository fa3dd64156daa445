//! The optional features: what a chart derives reaches all its types, and the instants of other crates are times.

use std::collections::BTreeSet;

use grafcet::{Ticks, grafcet};
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
    let mut lamp = Lamp::new();
    let push = LampInputs { push: true };
    lamp.cycle(&push, Ticks::new(0));
    lamp.cycle(&push, Ticks::new(10));
    lamp.cycle(&LampInputs::default(), Ticks::new(20_000));

    let stored = serde_json::to_string(&lamp).expect("a chart is plain data");
    let mut again: Lamp = serde_json::from_str(&stored).expect("what was stored");
    assert_eq!(again, lamp);
    for now in [26_000, 30_009, 30_010, 31_000] {
        let (one, other) = (lamp.cycle(&push, Ticks::new(now)), again.cycle(&push, Ticks::new(now)));
        assert_eq!(one, other);
        assert_eq!(serde_json::to_string(&one).expect("outputs"), serde_json::to_string(&other).expect("outputs"));
    }

    let mut stirrer = Stirrer::new();
    stirrer.cycle(&StirrerInputs { go: true, fast: true, done: false }, Ticks::new(1));
    let stored = serde_json::to_string(&stirrer).expect("a chart is plain data");
    let again: Stirrer = serde_json::from_str(&stored).expect("what was stored");
    assert!(again.is_active(StirrerStep::Stir) && again.is_active(StirrerStep::Heat));
    assert_eq!(serde_json::to_string(&StirrerStep::Heat).expect("a name"), "\"Heat\"");
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
