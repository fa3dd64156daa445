//! Charts that are put into a situation by hand: what is refused, and what it costs.

use grafcet::{Chart, ForceError, Forceable, Phase, Ticks, grafcet};

grafcet! {
    sfc Drill {
        forceable;
        input start, down, up: bool;
        output lower, lift, fan: bool;
        initial step Rest;
        step Lower { lower; }
        step Lift { lift; }
        step Up;
        step Cool { fan; }
        Rest -[start]-> (Lower, Cool);
        Lower -[down]-> Lift -[up]-> Up;
        (Up, Cool) -[!start]-> Rest;
    }
}

#[test]
fn every_situation_is_taken_and_no_other() {
    use DrillStep::{Cool, Lift, Lower, Rest, Up};
    let situations: [&[DrillStep]; 4] = [&[Rest], &[Lower, Cool], &[Lift, Cool], &[Up, Cool]];
    let inputs = DrillInputs::default();
    for bits in 0..1_u8 << 5 {
        let steps: Vec<DrillStep> = (0..5).filter(|bit| bits >> bit & 1 != 0).map(|bit| Drill::STEPS[bit]).collect();
        let mut drill = Drill::new();
        drill.cycle(&inputs);
        let before = format!("{drill:?}");
        let possible = situations.iter().any(|situation| drill_steps(situation) == drill_steps(&steps));
        match drill.force(&steps, &inputs) {
            Ok(outputs) => {
                assert!(possible && drill.is_exactly(&steps), "{steps:?}");
                assert_eq!(outputs.fan, steps.contains(&Cool));
            }
            Err(error) => {
                assert!(!possible, "{steps:?}: {error}");
                assert_eq!(format!("{drill:?}"), before, "nothing has happened");
                let apart = |one: &DrillStep, other: &DrillStep| {
                    one != other && !situations.iter().any(|all| all.contains(one) && all.contains(other))
                };
                match error {
                    ForceError::NeverTogether(one, other) => {
                        assert!(apart(&one, &other) && steps.contains(&one) && steps.contains(&other));
                    }
                    ForceError::NoSituation => {
                        assert!(!steps.iter().any(|one| steps.iter().any(|other| apart(one, other))));
                    }
                }
            }
        }
    }
}

fn drill_steps(steps: &[DrillStep]) -> std::collections::BTreeSet<String> {
    steps.iter().map(ToString::to_string).collect()
}

#[test]
fn a_step_may_be_named_twice() {
    let mut drill = Drill::new();
    let steps = [DrillStep::Lift, DrillStep::Cool, DrillStep::Lift];
    assert!(drill.force(&steps, &DrillInputs::default()).is_ok());
    assert_eq!(drill.situation().to_string(), "Lift, Cool");
}

grafcet! {
    grafcet Plant {
        forceable;
        input stop, go: bool;
        output run: bool;
        initial step Fine;
        step Stopped { force Work { Idle }; }
        Fine -[stop]-> Stopped -[!stop]-> Fine;
        partial Work {
            initial step Idle;
            step Busy { run; }
            Idle -[rising(go)]-> Busy -[rising(go)]-> Idle;
        }
    }
}

/// An order that holds allows what it orders; with the rest any pair is possible.
#[test]
fn orders_are_obeyed() {
    let mut plant = Plant::new();
    let inputs = PlantInputs { stop: true, go: false };
    let refused = plant.force(&[PlantStep::Stopped, PlantStep::Busy], &inputs);
    assert_eq!(refused.unwrap_err(), ForceError::NeverTogether(PlantStep::Stopped, PlantStep::Busy));
    assert!(plant.force(&[PlantStep::Busy, PlantStep::Fine], &inputs).expect("a situation").run);
    assert!(plant.is_stable());
    // The order comes with the next cycle.
    assert!(!plant.cycle(&inputs).run);
    assert_eq!(plant.situation().to_string(), "Stopped, Idle");
}

grafcet! {
    sfc Heater {
        forceable;
        input on: bool;
        output lamp: bool;
        action heat(level: u8);
        initial step Off;
        step Low { N heat(1); S lamp; }
        step High { N heat(2); }
        step Cool { R lamp; }
        Off -[on]-> Low -[5s/Low]-> High -[!on]-> Cool -[10s/Cool]-> Off;
    }
}

#[derive(Default)]
struct Calls(Vec<(Phase, u8)>);

impl HeaterActions for Calls {
    fn heat(&mut self, phase: Phase, level: u8) {
        self.0.push((phase, level));
    }
}

/// What a step switches on by a call is switched off by its final call; what S has stored stays.
#[test]
fn a_step_that_is_left_by_hand_has_its_final_call() {
    let (mut heater, mut calls) = (Heater::new(), Calls::default());
    let on = HeaterInputs { on: true };
    heater.cycle(&on, 0, &mut calls);
    heater.cycle(&on, 10, &mut calls);
    let outputs = heater.force(&[HeaterStep::Off], &on, 20, &mut calls).expect("a situation");
    assert_eq!(calls.0, [(Phase::First, 1), (Phase::Final, 1)]);
    assert!(outputs.lamp);
    assert_eq!(heater.next_deadline(), Some(Ticks::new(20)));
}

/// For any chart.
#[test]
fn generic_code_forces_what_can_be_forced() {
    fn rest<C>(chart: &mut C, steps: &[C::Step], inputs: &C::Inputs) -> bool
    where
        C: for<'a> Chart<Actions<'a> = ()> + Forceable,
    {
        chart.force(steps, inputs, Ticks::ZERO, &mut ()).is_ok()
    }
    assert!(rest(&mut Drill::new(), &[DrillStep::Rest], &DrillInputs::default()));
    assert!(!rest(&mut Drill::new(), &[], &DrillInputs::default()));
}

#[test]
fn without_time_it_takes_no_memory() {
    // A byte for each region, and one for the edge of the plant.
    assert_eq!((size_of::<Drill>(), size_of::<Plant>()), (2, 3));
}

grafcet! {
    /// More situations than are listed: four branches of five steps.
    sfc Wide {
        forceable;
        input go, a, b, c, e: bool;
        initial step Rest;
        step A1; step A2; step A3; step A4; step A5;
        step B1; step B2; step B3; step B4; step B5;
        step C1; step C2; step C3; step C4; step C5;
        step E1; step E2; step E3; step E4; step E5;
        Rest -[go]-> (A1, B1, C1, E1);
        A1 -[a]-> A2 -[!a]-> A3 -[a]-> A4 -[!a]-> A5;
        B1 -[b]-> B2 -[!b]-> B3 -[b]-> B4 -[!b]-> B5;
        C1 -[c]-> C2 -[!c]-> C3 -[c]-> C4 -[!c]-> C5;
        E1 -[e]-> E2 -[!e]-> E3 -[e]-> E4 -[!e]-> E5;
        (A5, B5, C5, E5) -[go]-> Rest;
    }
}

/// Where there are many, no branch may be missing.
#[test]
fn of_many_situations_none_is_taken_in_which_a_branch_is_missing() {
    use WideStep::{A1, A2, B3, C5, E1, Rest};
    let mut wide = Wide::new();
    let inputs = WideInputs::default();
    for refused in [&[A1, A2, B3, C5, E1][..], &[A1, B3, C5], &[Rest, A1, B3, C5, E1], &[]] {
        assert!(wide.force(refused, &inputs).is_err(), "{refused:?}");
    }
    assert!(wide.force(&[E1, C5, B3, A1], &inputs).is_ok());
    assert!(wide.force(&[Rest], &inputs).is_ok());
}

grafcet! {
    /// Lamps that blink, one of them beside a time of its own.
    sfc Lamps {
        forceable;
        input go: bool;
        output slow, quick: bool;
        initial step Idle { slow if blink(700ms/300ms); }
        step Run { quick if blink(200ms/100ms); }
        Idle -[go]-> Run -[!go && 500ms/Run]-> Idle;
    }
}

/// A step that is put into again and again by hand, and nothing else, blinks on in step beyond the 32 bits of the clock.
#[test]
fn what_is_held_by_hand_for_a_hundred_days_goes_on_blinking() {
    for (step, period, on) in [(LampsStep::Idle, 1_000, 700), (LampsStep::Run, 300, 200)] {
        let mut lamps = Lamps::new();
        let inputs = LampsInputs::default();
        lamps.cycle(&inputs, 0);
        lamps.force(&[step], &inputs, 0).expect("a situation");
        let mut passed = 0_u64;
        for _ in 0..20_000 {
            passed += 432_017;
            let now = u32::try_from(passed & 0xFFFF_FFFF).unwrap_or_default();
            let outputs = lamps.force(&[step], &inputs, now).expect("a situation");
            let lamp = if step == LampsStep::Idle { outputs.slow } else { outputs.quick };
            assert_eq!(lamp, passed % period < on, "{step:?} {passed}");
        }
        assert!(passed > 2 * u64::from(u32::MAX));
    }
}
