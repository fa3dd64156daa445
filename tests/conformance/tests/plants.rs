//! Charts with their plants: what is proved of them, and their circuit beside the interpreters of both.

use std::time::Duration;

use grafcet_compiler::analysis::{Facts, Prover};
use grafcet_compiler::diagnostic::{Diagnostic, Sink};
use grafcet_compiler::model::{Claim, Id, Model, Wire};
use grafcet_compiler::plant;
use grafcet_compiler::program::{Role, counted};
use grafcet_compiler::{Wanted, compile_with, diagnose};
use grafcet_conformance::prove::{Bounds, Counts};
use grafcet_conformance::with_plants;
use grafcet_prove::circuit::{Circuit, Source};
use grafcet_prove::play::Player;
use grafcet_prove::{Limit, Verdict, decide, decide_live};
use grafcet_sim::interp::{ClosedLoop, Value};
use quote::quote;

/// A press, and a cylinder that a spring lifts.
fn press(condition: &str, claims: &str) -> String {
    format!(
        "sfc Press {{
            clock 500ms;
            input start, top, bottom: bool;
            input parts: u8;
            output lower, alarm: bool;

            initial step Rest;
            step Down {{ lower; }}
            step Up;
            step Stopped {{ alarm; }}

            Rest -[start && top && parts < 5]-> Down -[bottom]-> Up -[{condition}]-> Rest;
            Down -[5s/Down]-> Stopped -[start && top]-> Rest;
            assume cycle within 500ms;
            {claims}
        }}
        plant Cylinder {{
            input lower: bool;
            output top, bottom: bool;
            output parts: u8;
            var done: u8 = 0;
            fault jammed, blind;

            initial step Top {{ top; N parts = done; }}
            step Going;
            step Bottom {{ N bottom if !blind; P1 done = (done + 1) % 5; }}
            step Coming;
            step Slipped;

            Top -[lower && !jammed]-> Going;
            either Going -[1s..2s/Going && !jammed]-> (Bottom or Slipped);
            Going -[!lower]-> Coming;
            Bottom -[!lower]-> Coming;
            Slipped -[!lower]-> Coming -[1s..2s/Coming]-> Top;
        }}"
    )
}

fn read(text: &str) -> Model {
    let mut sink = Sink::new();
    let model = plant::model(text.parse().expect("tokens"), &mut sink).expect("a chart");
    let messages: Vec<String> =
        sink.finish().into_iter().flat_map(|one| one.notes).map(|(_, message)| message).collect();
    assert!(messages.is_empty(), "{messages:?}");
    model
}

fn verdicts(model: &Model) -> Vec<Verdict> {
    let program = counted(model, &Facts::of(model)).expect("a program");
    let circuit = Circuit::of(&program).expect("a circuit");
    let limit = || Limit::time(Duration::from_secs(600));
    let verdict = |property| match circuit.bad.iter().find(|bad| bad.property == property) {
        Some(bad) => decide(&program, &circuit, *bad, &limit()),
        None => {
            let live = circuit.live.iter().find(|live| live.property == property).expect("it is modelled");
            decide_live(&program, &circuit, *live, &limit())
        }
    };
    (0..model.properties.len()).map(verdict).collect::<Result<_, _>>().expect("no internal error")
}

/// How many cycles the shortest way to where each is broken has; none where it is proved.
fn broken(claims: &str, condition: &str) -> Vec<Option<usize>> {
    let length = |verdict| match verdict {
        Verdict::Proved(_) => None,
        Verdict::Violated(way) | Verdict::Endless { way, .. } => Some(way.len()),
        Verdict::Undecided(why) => panic!("{why}"),
    };
    verdicts(&read(&press(condition, claims))).into_iter().map(length).collect()
}

#[test]
fn properties_hold_with_the_plant() {
    let claims = "never Rest.X && Cylinder::Bottom.X;
                  never Down.X && Cylinder::Coming.X;
                  always Cylinder::done < 5;
                  never parts > 4;
                  Down leads_to Up.X || alarm within 6s;
                  Up leads_to Rest;";
    assert_eq!(broken(claims, "top"), [None; 6]);
    // With a cylinder that need not be up the next stroke begins too early: the third row is that of the plant at the bottom.
    let without = broken("never Rest.X && Cylinder::Coming.X; never top && bottom;", "true");
    assert_eq!(without, [Some(6), None]);
}

#[test]
fn faults_happen_unless_they_are_excluded() {
    let claim = "never alarm;";
    let with = broken(claim, "top");
    // Down in cycle 2, ten ticks of half a second later it is over.
    assert_eq!(with, [Some(12)]);
    let never = "assume never Cylinder::jammed || Cylinder::blind || Cylinder::choose_slipped;";
    assert_eq!(broken(&format!("{never} {claim}"), "top"), [None]);
    let one_left = "assume never Cylinder::jammed || Cylinder::choose_slipped;";
    assert_eq!(broken(&format!("{one_left} {claim}"), "top"), [Some(12)]);
}

#[test]
fn what_comes_may_rely_on_the_plant() {
    let often = "assume never Cylinder::jammed;";
    assert_eq!(broken(&format!("{often} Cylinder::Going leads_to Cylinder::Top;"), "top"), [None]);
    let stuck = broken("Cylinder::Going leads_to Cylinder::Bottom;", "top");
    assert!(stuck[0].is_some());
}

/// The macro says it with the plant; without a solver it is open.
#[test]
fn the_macro_says_that_it_is_with_the_plant() {
    let chart = |claim: &str| press("top", claim).parse().expect("tokens");
    let root = quote!(::grafcet);
    let compiled = |claim: &str, prover: Option<&Prover>| {
        compile_with(&root, chart(claim), Wanted { prover, ..Wanted::default() }).to_string()
    };
    let broken = compiled("never alarm;", Some(&grafcet_prove::rule));
    assert!(broken.contains("at the end of cycle 12 `alarm` holds with the plant `Cylinder`"), "{broken}");
    let open = compiled("never alarm;", None);
    assert!(open.contains("whether this holds with the plant `Cylinder` is not decided"), "{open}");
    let proved = compiled("never Rest.X && Cylinder::Bottom.X;", Some(&grafcet_prove::rule));
    assert!(!proved.contains("compile_error"), "{proved}");
}

/// What the controller gets does not depend on a plant, nor on what is claimed with it.
/// What holds because nothing happens, with the plant alone: a plant that never moves, a left side that it never lets come, assumptions that leave
/// no cycle.
#[test]
fn what_says_nothing_with_the_plant_is_said() {
    const MOVES: &str =
        "initial step Top { top; on; } step Bottom { bottom; on; } Top -[lower]-> Bottom -[!lower]-> Top;";
    const STANDS: &str =
        "initial step Top { top; on; } step Bottom { bottom; on; } Top -[lamp]-> Bottom -[!lower]-> Top;";
    const HALF: &str = "initial step Top { top; on; } step Bottom { bottom; on; } step Jam { bottom; on; } Top -[lower]-> Bottom -[lower && 2s/Bottom]-> Jam \
                        -[!lower]-> Top; Bottom -[!lower]-> Top;";
    let said = |plant: &str, claims: &str| {
        let chart = format!(
            "sfc Press {{
                input start, top, bottom, on: bool;
                output lower, lamp: bool;
                initial step Rest;
                step Down {{ lower; }}
                step Up;
                Rest -[start && top]-> Down -[bottom]-> Up -[top]-> Rest;
                {claims}
            }}
            plant Cylinder {{ input lower, lamp: bool; output top, bottom, on: bool; {plant} }}"
        );
        let prover: Option<&Prover> = Some(&grafcet_prove::rule);
        let tokens = chart.parse().expect("tokens");
        let said = diagnose(tokens, Wanted { recorded: false, prover });
        let vacuous = |message: &Diagnostic| message.rule.is_some_and(|rule| rule.name.starts_with("vacuous"));
        said.into_iter()
            .filter(vacuous)
            .flat_map(|message| message.notes)
            .map(|(_, text)| text)
            .collect::<Vec<String>>()
    };
    for (plant, claims, what) in [
        (MOVES, "never lower && top && bottom;", None),
        (MOVES, "always Cylinder::Bottom.X => lower || Up.X;", None),
        (
            STANDS,
            "never lower && top && bottom;",
            Some("the plant `Cylinder` stays where it begins, whatever the chart does"),
        ),
        (HALF, "always Cylinder::Jam.X => lower;", Some("`Cylinder::Jam.X` holds at the end of no cycle")),
        (MOVES, "assume never on; never lower;", Some("no cycle comes to its end")),
        (MOVES, "assume often top && bottom; never top && bottom;", Some("so it cannot come again and again")),
        (MOVES, "assume top && bottom leads_to start; never top && bottom;", Some("this assumption excludes nothing")),
    ] {
        let warnings = said(plant, claims);
        match what {
            None => assert_eq!(warnings, Vec::<String>::new(), "{claims}"),
            Some(what) => assert!(matches!(&warnings[..], [one] if one.contains(what)), "{claims}: {warnings:?}"),
        }
    }
    // Each of several.
    let both = said(HALF, "always Cylinder::Jam.X => lower; always Cylinder::Jam.X && lower => bottom;");
    assert_eq!(both.len(), 2, "{both:?}");
}

#[test]
fn a_plant_costs_the_controller_nothing() {
    let call = press("top", "never alarm; never Rest.X && Cylinder::Bottom.X;");
    let alone = call.split("plant").next().expect("the chart").replace("never", "//");
    let root = quote!(::grafcet);
    let prover: &Prover = &|_, _, open| open.iter().map(|_| grafcet_compiler::analysis::Ruling::Holds).collect();
    let wanted = Wanted { prover: Some(prover), recorded: false };
    let alone = compile_with(&root, alone.parse().expect("tokens"), wanted).to_string();
    let whole = compile_with(&root, call.parse().expect("tokens"), wanted).to_string();
    let places = |text: &str| text.replace(char::is_whitespace, "");
    assert!(places(&whole).starts_with(&places(&alone)));
}

/// Cycle by cycle, what the circuit remembers of chart and plant is what their interpreters show.
#[test]
fn the_circuit_does_what_the_closed_loop_does() {
    let model = read(&press("top", "never alarm; never Cylinder::done > 4 || Cylinder::Slipped.X;"));
    let program = counted(&model, &Facts::of(&model)).expect("a program");
    let circuit = Circuit::of(&program).expect("a circuit");
    let mut seed = 7_u32;
    let mut random = |below: u32| {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (seed >> 16) % below
    };
    let (mut visited, mut strokes) = (std::collections::BTreeSet::new(), 0);
    for _ in 0..50 {
        let (mut player, mut closed) = (Player::new(&circuit), ClosedLoop::new(&model).expect("understood"));
        let (mut now, faulty) = (0, random(3) == 0);
        for _ in 0..200 {
            let (mut inputs, mut free) = closed.nothing();
            inputs[0] = Value::Bool(random(2) == 0);
            for (value, wire) in free[0].iter_mut().zip(&model.plants.list[0].wires) {
                if *wire == Wire::Free {
                    *value = Value::Bool(random(if faulty { 4 } else { 40 }) == 0);
                }
            }
            let elapsed = random(2);
            now += elapsed;
            let (given, chosen) = (inputs.clone(), free.clone());
            let number = |value: &Value| i128::from(*value == Value::Bool(true));
            player.cycle(|source| match source {
                Source::Input(id) => number(&given[id.index()]),
                Source::Plant(plant, id) => number(&chosen[*plant][id.index()]),
                Source::Elapsed => i128::from(elapsed),
                _ => 0,
            });
            let round = closed.cycle(&mut inputs, &free, now).expect("understood");
            for (bad, property) in circuit.bad.iter().zip(&model.properties) {
                let violation = property.claim.violation().expect("about an end");
                let holds = closed.holds(&violation, &inputs).expect("understood");
                assert_eq!(player.holds(bad.certain), holds);
            }
            for field in &circuit.fields {
                let Some(place) = field.place else { continue };
                let (machine, active) = match field.plant {
                    None => (closed.chart(), &round.chart.active),
                    Some(plant) => (&closed.plants()[plant], &round.plants[plant].active),
                };
                let program = field.program(&program);
                let expected = match program.places[place.0].role {
                    Role::Var(id) => match machine.vars()[id.index()] {
                        Value::Int(value) => value,
                        ref other => number(other),
                    },
                    Role::State(region) => {
                        let place = program.regions[region].iter().position(|step| active.contains(step));
                        place.map_or(0, |place| i128::try_from(place).expect("small") + 1)
                    }
                    _ => continue,
                };
                assert_eq!(player.field(field), expected, "{}", field.name);
            }
            visited.extend(round.plants[0].active.iter().copied());
            strokes += usize::from(round.chart.evolutions > 0);
        }
    }
    assert_eq!(visited.len(), model.plants.list[0].model.steps.len(), "every step of the plant is seen");
    assert!(strokes > 500, "{strokes}");
}

/// Random charts with random plants, faults, choices, times between two bounds and assumptions over several cycles: every verdict and every length as
/// brute force finds them, which takes the same written out by hand.
#[test]
fn random_plants_are_judged_as_brute_force_finds_them() {
    let mut counts = Counts::default();
    let bounds = Bounds { cycles: 4_000, time: Duration::from_secs(600) };
    for chart in 0..40 {
        with_plants::number(chart, chart % 2 == 1, bounds, &mut counts).expect("no difference");
    }
    assert!(counts.charts > 8 && counts.proved > 25 && counts.broken > 8 && counts.undecided.is_empty(), "{counts:?}");
}

/// How long the cylinder goes is known of its own clock, how long it is waited for of the chart's: with ticks of any size.
#[test]
fn clocks_of_chart_and_plant_go_together_in_fine_ticks_too() {
    let never = "assume never Cylinder::jammed || Cylinder::blind || Cylinder::choose_slipped;";
    for (clock, within) in [("100ms", "6s"), ("1ms", "6s")] {
        let text = press("top", &format!("{never} never alarm; Down leads_to Up.X || alarm within {within};"));
        let text = text.replacen("clock 500ms", &format!("clock {clock}"), 1);
        let said = verdicts(&read(&text));
        assert!(said.iter().all(|verdict| matches!(verdict, Verdict::Proved(_))), "{clock}: {said:?}");
    }
}

/// What stands for a mention has a name of its own: `Arm::Up_In` and `Arm_Up::In` are two things, raw identifiers one each, and an input of a plant may be
/// called as a choice would be.
#[test]
fn names_of_plants_do_not_meet() {
    let chart = |claims: &str| {
        format!(
            "sfc Press {{
                input top, r#type, up: bool;
                output lower, choose_in: bool;
                initial step Rest;
                step Down {{ lower; choose_in; }}
                Rest -[top && r#type]-> Down -[!top && !up]-> Rest;
                {claims}
            }}
            plant Arm {{
                input lower: bool;
                output top: bool;
                initial step Top {{ top; }}
                step Up_In; step Up;
                Top -[lower]-> Up_In -[!lower]-> Up -[true]-> Top;
            }}
            plant Arm_Up {{
                input lower, choose_in: bool;
                output up, r#type: bool;
                initial step In {{ up; r#type; }}
                step r#final {{ r#type; }}
                step Rin;
                either In -[lower]-> (r#final or r#in or RIn);
                step r#in; step RIn;
                RIn -[choose_in]-> Rin -[true]-> In;
                r#in -[!lower]-> In;
                r#final -[!lower || 1s..2s/r#final]-> In;
            }}"
        )
    };
    let claims = "never Arm_Up::In.X && Rest.X && top;
                  never Arm::Up_In.X && Rest.X && top;
                  never Arm_Up::r#final.X && Rest.X;
                  never Arm_Up::r#in.X && Down.X;
                  never Arm_Up::r#type && !Arm_Up::In.X && !Arm_Up::r#final.X;";
    let model = read(&chart(claims));
    let broken: Vec<bool> = verdicts(&model).iter().map(|verdict| matches!(verdict, Verdict::Violated(_))).collect();
    assert_eq!(broken, [true, false, false, true, false]);
    // The other way round.
    let swapped = "never Arm::Up_In.X && Rest.X && top; never Arm_Up::In.X && Rest.X && top;";
    let broken: Vec<bool> =
        verdicts(&read(&chart(swapped))).iter().map(|verdict| matches!(verdict, Verdict::Violated(_))).collect();
    assert_eq!(broken, [false, true]);
    // Each is said as it is written, also where one name begins as another one.
    let said = "never Arm::Up.X && Arm::Up_In.X;";
    let model = read(&chart(said));
    let Claim::Never(never) = &model.properties[0].claim else { panic!("a `never`") };
    assert_eq!(format!("never {};", never.text), said);
    // Rust that nobody looks into, too.
    let model = read(&chart("never matches!(Arm::Up.X, true);"));
    assert!(!format!("{:?}", model.properties[0].claim.violation()).contains("__Arm"));
}
