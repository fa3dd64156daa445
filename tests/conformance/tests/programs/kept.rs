//! What is asked once, and what is stored once: as a person reads it, and beside the interpreter.

use std::fmt::Write as _;

use grafcet_compiler::program::passes::Pass;
use grafcet_conformance::program::program as optimised;

use super::passes::{each_left_out, storm};
use super::read;

/// After all passes.
fn text(chart: &str) -> String {
    optimised(&read(chart), &Pass::ALL).expect("a program").to_string()
}

/// A time, a variable or a state is the same until somebody writes it, so two conditions that share it ask for it once; what a step has changed is asked for anew.
#[test]
fn what_has_been_asked_is_not_asked_again_until_it_changes() {
    let chart = "sfc Lots { input a, b: bool; output p, q: bool; var n: u8 = 0; initial step Wait { p; } step Fill { P1 n = n % 5 + 1; q if n < 3; } step Rest; \
         Wait -[a && n < 3]-> Fill; Wait -[b && n < 3]-> Rest; Fill -[!a && 4ms/Fill]-> Wait; Rest -[a && 3ms/Rest]-> Fill; Rest -[b && 3ms/Rest]-> Wait; }";
    let program = text(chart);
    let cycle = program.split("deadline").next().unwrap_or_default();
    assert_eq!(cycle.matches("< 3ms)").count(), 1, "{program}");
    // What led into the step has asked it, before the step counts.
    assert!(program.contains("on.Fill.2 = true"), "{program}");
    let branches = chart.replacen(
        "Wait -[a && n",
        "step Go; step C; step D; Rest -[a && b]-> (Go, C); C -[a && n < 3]-> D; (Go, D) -[!a && n < 3]-> Rest; Wait -[a && n",
        1,
    );
    for dialect in ["sfc", "grafcet"] {
        for chart in [chart, &branches] {
            each_left_out(&read(&chart.replacen("sfc", dialect, 1)), &storm(&["a", "b"], 300), 150);
        }
    }
}

/// A condition that guards another one against a panic stays in front of it.
#[test]
fn what_may_panic_is_not_asked_first() {
    let chart = "sfc Guard { input n: u8; input a: bool; output p: bool; initial step Wait; step Run { p; } step Out; \
         Wait -[n != 0 && 100 / n > 4]-> Run; Wait -[a && 100 / n > 4]-> Out; Run -[true]-> Wait; Out -[true]-> Wait; }";
    let program = text(chart);
    assert!(program.contains("if n != 0 && 100 / n > 4: after = Run"), "{program}");
}

/// A search that a count ends needs nobody to stop it: nothing is kept to be taken back. One turn more than the bound allows, and it does.
#[test]
fn a_search_that_a_count_ends_keeps_nothing() {
    let chart = |most: u32| {
        format!(
            "grafcet Pump {{ input a, b, c: bool; output p, q, r: bool; var n: u8 = 0; initial step Idle; step Fill {{ p; P1 n = n + 1; }} step Drain {{ q; }} \
             step Full {{ r; P1 n = 0; }} step Rest; step Cool; step Warm; step Lock; \
             Idle -[a]-> Fill -[b]-> Drain -[c && n < {most}]-> Fill; Drain -[n >= {most}]-> Full -[!b]-> Rest -[!c]-> Cool -[c]-> Warm -[!a]-> Lock -[a && b]-> Idle; }}"
        )
    };
    for (most, is_kept) in [(2, false), (9, true)] {
        let program = text(&chart(most));
        assert_eq!(program.contains("stable"), is_kept, "{program}");
        each_left_out(&read(&chart(most)), &storm(&["a", "b", "c"], 300), 100);
    }
}

/// Regions that share a place are taken back by one copy of it, whichever situation the bound has stopped, and tell in a byte of their own that it has.
#[test]
fn what_shares_a_place_is_taken_back_at_once() {
    let chart = |most: u32| {
        format!(
            "grafcet Press {{ max_evolutions {most}; input stop, reset, a, b, c: bool; output p, q, alarm: bool; var n: u8 = 0; \
             partial Safety {{ initial step Ready; step Stopped {{ alarm; force Modes {{}}; }} step Again {{ force Modes {{INIT}}; }} \
             Ready -[stop]-> Stopped -[!stop && reset]-> Again -[true]-> Ready; }} \
             partial Modes {{ initial step Hand; enclosing step Auto {{ partial Inner {{ linked step Up {{ p; }} step Down {{ q; P1 n = (n + 1) % 5; }} \
             Up -[a]-> Down -[b]-> Up; }} }} Hand -[c && !stop]-> Auto -[!c && Inner::Up.X && n < 3]-> Hand; }} \
             partial Beside {{ initial step Off; step On; Off -[Inner::Down.X]-> On -[Inner::Up.X || stop]-> Off; }} }}"
        )
    };
    let program = text(&chart(4));
    assert_eq!(program.matches(" = was.state.").count(), 2, "{program}");
    assert!(program.contains("  stable: bool = true\n") && program.contains("      stable = false\n"), "{program}");
    for most in [1, 2, 4, 7] {
        each_left_out(&read(&chart(most)), &storm(&["stop", "reset", "a", "b", "c"], 300), 100);
    }
}

/// What goes on for longer than anybody asks is kept from wrapping around in one place, if several steps wait so.
#[test]
fn a_time_that_is_over_stays_over_for_any_length_of_time() {
    let chart = "sfc Long { input a, b: bool; output p, q, r: bool; initial step One { p; } step Two { q; } step Three { r; } step Four { L 9ms p; } \
         One -[a && 5ms/One]-> Two -[b && 7ms/Two]-> Three -[a && b && 6ms/Three]-> Four -[!a && 4ms/Four]-> One; }";
    assert!(text(chart).contains("  if !(passed < 2147483648ms): since = since(now, 2147483648ms)"), "{}", text(chart));
    let mut lines = "---\n---\n".to_owned();
    let mut now = u32::MAX - 3;
    // Each step waits for four cycles that are as long as a cycle may be, twice around the clock and two ticks: it then shows less than their limits.
    for inputs in ["", "a ", "a b ", "b ", ""].into_iter().cycle().take(40) {
        for long in [5, 0x7fff_ffff, 0x7fff_ffff, 0x7fff_ffff, 0x7fff_ffff, 1] {
            _ = writeln!(lines, "@{now} | |");
            now = now.wrapping_add(long);
        }
        _ = writeln!(lines, "{inputs}@{now} | |");
    }
    for dialect in ["sfc", "grafcet"] {
        let model = read(&chart.replacen("sfc", dialect, 1));
        each_left_out(&model, &lines, 0);
        each_left_out(&model, &storm(&["a", "b"], 300), 150);
    }
}

/// An output that its memory tells, and a time beside that, is set once from the memory; where something else may say that it is off, it is not.
#[test]
fn an_output_that_is_more_than_its_memory_is_set_from_it_once() {
    let chart = |more: &str| {
        format!(
            "sfc Belts {{ input a, b, c: bool; output belt, p, q: bool; initial step Idle {{ R belt; p; }} step Warm {{ D 5ms belt; }} step Move {{ S belt; }} step Down {{ {more} }} \
             step Heat {{ q; }} step Hot; Idle -[a]-> Warm -[b && 7ms/Warm]-> (Move, Heat); Move -[c]-> Down; Heat -[!b]-> Hot; (Down, Hot) -[a || c]-> Idle; }}"
        )
    };
    for (more, shown) in [("", true), ("belt if b;", true), ("R belt; belt if !c;", true)] {
        let program = text(&chart(more));
        assert_eq!(program.contains("  if S_FF.belt: belt = true"), shown, "{more}: {program}");
        for dialect in ["sfc", "grafcet"] {
            each_left_out(&read(&chart(more).replacen("sfc", dialect, 1)), &storm(&["a", "b", "c"], 300), 150);
        }
    }
}

/// What a stored output holds is asked of its field wherever one state does not tell it: no way of the evolution has to bring it along. Where all states tell it, there is no field.
#[test]
fn a_stored_output_that_not_all_states_tell_stays_a_field() {
    let unsure = include_str!("../../../golden/shapes/stored_unsure.chart");
    let told = unsure.replace("step Fault { red; }", "step Fault { red; R clamp; }");
    let program = text(unsure);
    let evolution = program.split_once("match after").map(|(evolution, _)| evolution).unwrap_or_default();
    assert_eq!(evolution.matches("S_FF.clamp").count(), 1, "{program}");
    assert!(program.contains("clamp = S_FF.clamp"), "{program}");
    assert!(!text(&told).contains("S_FF.clamp"), "{}", text(&told));
    for dialect in ["sfc", "grafcet"] {
        for chart in [unsure, &told] {
            each_left_out(
                &read(&chart.replacen("sfc", dialect, 1)),
                &storm(&["start", "closed", "done", "ack"], 300),
                150,
            );
        }
    }
}

/// A door that one branch opens and shuts.
pub(super) fn doors(heat: &str, act: &str) -> String {
    format!(
        "sfc Doors {{ input a, b, c: bool; output door, p, q: bool; var n: u8 = 0; initial step Idle {{ R door; p if rising(c); }} step Open {{ {act} }} step Shut {{ P1 n = n % 9 + 1; }} \
         step Heat {{ {heat} }} step Hot; Idle -[a]-> (Open, Heat); Idle -[b && !a]-> (Shut, Heat); Open -[b && 3ms/Open]-> Shut; Shut -[!b && 4ms/Shut]-> Open; Heat -[falling(c)]-> Hot; \
         (Shut, Hot) -[!a]-> Idle; }}"
    )
}

/// What a step has stored when it was entered it does not store in each cycle, unless another branch may have changed it, or a condition asks first.
#[test]
fn what_a_field_holds_is_not_stored_anew() {
    let stored = |text: &str| text.matches("S_FF.door = ").count();
    let model = read(&doors("q;", "S door;"));
    let mut without = Pass::ALL.to_vec();
    without.retain(|pass| *pass != Pass::Anew);
    let [all, before] =
        [&Pass::ALL[..], &without].map(|passes| optimised(&model, passes).expect("a program").to_string());
    assert!(stored(&all) < stored(&before), "{all}");
    for (heat, act) in [
        ("q;", "S door;"),
        ("q; S door if b;", "S door;"),
        ("q; R door if b;", "S door;"),
        ("q;", "S door if c;"),
        ("S door; q = door;", "R door if b;"),
    ] {
        for dialect in ["sfc", "grafcet"] {
            each_left_out(&read(&doors(heat, act).replacen("sfc", dialect, 1)), &storm(&["a", "b", "c"], 300), 150);
        }
    }
}

/// A time that is counted, as one that is compared with a parameter, begins after the ways where the state differs, and that tells whether the cycle has moved, too.
#[test]
fn a_counted_time_begins_where_the_state_differs() {
    let chart = "sfc Dose { param soak: time = 6ms; input a, b: bool; output p, q: bool; initial step Idle { q if rising(b); } step Fill { p; } step Soak { D 3ms q; P0 p = false; } \
         Idle -[a]-> Fill; Fill -[b && 4ms/Fill]-> Soak; Fill -[!a]-> Idle; Soak -[soak/Soak && !b]-> Idle; Soak -[a && b && 9ms/Soak]-> Soak; }";
    let simple = chart.replacen("P0 p = false; ", "", 1).replacen(" Soak -[a && b && 9ms/Soak]-> Soak;", "", 1);
    let program = text(&simple);
    assert!(program.contains("  if was.state != state: time = 0s"), "{program}");
    assert!(!program.contains("settled"), "{program}");
    // A step that is left at once: what it has counted until then is nothing.
    let late = "sfc Late { param p: time = 1ms; input a, b: bool; output q: bool; initial step S1; step S2; step S4 within p; step S6 { q; } S1 -[b]-> S2; S2 -[true]-> S4; S4 -[S4.X]-> S6; S6 -[a]-> S1; }";
    for chart in [chart, &simple, late] {
        for dialect in ["sfc", "grafcet"] {
            each_left_out(&read(&chart.replacen("sfc", dialect, 1)), &storm(&["a", "b"], 300), 150);
        }
    }
}

/// How far a period is concerns the steps that blink so; where the time of the step does not tell, it is counted and begun there alone.
#[test]
fn a_period_is_counted_where_something_blinks() {
    let chart = "sfc Lamp { input a, b: bool; output p, q: bool; initial step Idle; step Warn { p if blink(2ms/3ms); q if blink(1ms/4ms); } step Alarm { q if blink(2ms/3ms); p; } step Rest; \
         Idle -[a]-> Warn -[b && 96ms/Warn]-> Alarm -[!b]-> Rest -[7ms/Rest || a]-> Idle; Warn -[!a && !b]-> Warn; Alarm -[b && 9ms/Alarm]-> Warn; }";
    let program = text(chart);
    let cycle = program.split("deadline").next().unwrap_or_default();
    // The time of `Alarm` tells; that of `Warn` would be twenty periods long.
    assert_eq!(cycle.matches("period(phase").count(), 1, "{program}");
    beside_the_interpreter(chart);
}

/// With and without branches, of both dialects.
fn beside_the_interpreter(chart: &str) {
    let inside = chart.replacen(
        "step Alarm {",
        "step Beside { p if blink(1ms/4ms); } step After; Rest -[a && b]-> (Alarm, Beside); Beside -[a]-> After -[b]-> Beside; step Alarm {",
        1,
    );
    for chart in [chart, &inside] {
        for dialect in ["sfc", "grafcet"] {
            each_left_out(&read(&chart.replacen("sfc", dialect, 1)), &storm(&["a", "b"], 300), 150);
        }
    }
}

/// A step that blinks needs no count beside its time: that stays beyond what else asks for it, and goes on by whole periods. Transitions ask for the same.
#[test]
fn the_time_of_a_step_tells_how_far_its_period_is() {
    let chart = "sfc Lamp { input a, b: bool; output p, q: bool; initial step Idle; step Warn { p if blink(2ms/1ms); q if Warn.T > 5ms; } step Alarm { q if blink(2ms/3ms); p; } step Rest { p if blink(1ms/1ms); q if blink(3ms/1ms); } \
         Idle -[a]-> Warn -[b && 7ms/Warn && !blink(2ms/1ms)]-> Alarm -[!b]-> Rest -[7ms/Rest && !b || a]-> Idle; Alarm -[a && b && 9ms/Alarm]-> Warn; \
         Alarm -[b && !a && 4ms/Alarm && blink(2ms/3ms)]-> Idle; }";
    let program = text(chart);
    assert!(!program.contains("phase"), "{program}");
    // Three periods of three, two of five, and two of what two and four divide: seven and nine are over by then.
    assert!(program.contains("9ms + period(0s, passed, 3ms)"), "{program}");
    assert!(program.contains("10ms + period(0s, passed, 5ms)"), "{program}");
    assert!(program.contains("8ms + period(0s, passed, 4ms)"), "{program}");
    beside_the_interpreter(chart);
    // Too many periods to look through.
    let long = text(&chart.replacen("7ms/Warn", "70ms/Warn", 1));
    assert!(long.contains("period(phase.state.3, elapsed, 3ms)"), "{long}");
}

/// A line of nine steps with a stop by `any`.
pub(super) fn line(stop: &str) -> String {
    let mut text = "sfc Line { input a, b, stop: bool; input level: u8; output p, q: bool; var n: u8 = 0; initial step Idle; step Stopped { q; P1 n = 0; } ".to_owned();
    for number in 0..9 {
        _ = write!(text, "step S{number} {{ p if a; }} ");
    }
    text += "Idle -[a && !stop]-> S0; ";
    for number in 0..8 {
        _ = write!(text, "S{number} -[b && {}ms/S{number}]-> S{}; ", 2 + number % 3, number + 1);
    }
    _ = write!(text, "S8 -[!b]-> Idle; Stopped -[!stop]-> Idle; any except (Idle, Stopped) -[{stop}]-> Stopped; }}");
    text
}

/// Six steps with two ways out of each, and two branches: each way to a step would do what the step does.
pub(super) fn mash() -> String {
    let mut text = "sfc Mash { input a, b, c: bool; output p, q: bool; output power, speed: u16 = 0; var n: u8 = 0; \
                    step X1 { p; P1 n = n % 9 + 1; } step X2; step Y1 { q if b; } step Y2; "
        .to_owned();
    for number in 0..6 {
        let (initial, on, far) = (if number == 0 { "initial " } else { "" }, (number + 1) % 6, (number + 2) % 6);
        _ = write!(text, "{initial}step S{number} {{ p; q if a; power = {number}00; speed = {number}; }} ");
        _ = write!(text, "S{number} -[a && b]-> S{on}; S{number} -[b && !a && 3ms/S{number}]-> S{far}; ");
    }
    text + "S5 -[c && !b]-> (X1, Y1); X1 -[a || 4ms/X1]-> X2; Y1 -[b]-> Y2; Y2 -[2ms/Y2 && !a]-> Y1; (X2, Y2) -[c]-> S0; }"
}

/// Where many ways lead to the same states, what is done in them is looked up after the evolution; and it stays as it was where that is no shorter.
#[test]
fn actions_stand_apart_where_that_is_shorter() {
    let mut without = Pass::ALL.to_vec();
    without.retain(|pass| *pass != Pass::Apart);
    for (chart, is_apart) in [(&mash(), true), (&doors("q;", "S door;"), false)] {
        let model = read(chart);
        let [all, before] =
            [&Pass::ALL[..], &without].map(|passes| optimised(&model, passes).expect("a program").to_string());
        assert_eq!(all != before, is_apart, "{all}\n{before}");
        each_left_out(&model, &storm(&["a", "b", "c"], 300), 150);
    }
    let text = optimised(&read(&mash()), &Pass::ALL).expect("a program").to_string();
    assert_eq!(text.matches("power = 300").count(), 1, "{text}");
}

/// Whether another branch's step has been entered is found once for all states of the branch that waits for it, and no region is left as it was lowered.
#[test]
fn the_edge_of_another_regions_step_is_found_once() {
    let chart = "sfc Cross { input go, a, b, c, ok, stop: bool; input n: u8; output p, q, r, s, t: bool; var k: u8 = 0; \
         initial step Idle { p; } step Fill { q; } step Heat { r; } step Hold { r if rising(Stir.X); } step Stir { s; P1 k = k % 9 + 1; } step Rest { P k = k % 7 + 2; } \
         step Up { s; t; P0 k = 0; } step Vent { t if rising(b); } step Shut { S p; } step Open { R p; t if a; } step Drain { q; D 2ms s; } \
         Idle -[rising(go)]-> Fill -[rising(n >= 40) || a]-> (Heat, Stir, Vent); \
         Heat -[rising(n >= 60) || b]-> Hold -[falling(n >= 60) && 1ms/Hold]-> Heat; Heat -[stop]-> Hold; \
         Stir -[rising(Heat.X)]-> Rest -[rising(Hold.X)]-> Stir; Stir -[a]-> Up -[!a]-> Stir; \
         Vent -[rising(Rest.X) || b]-> Shut -[falling(n >= 40) || stop]-> Open -[c]-> Vent; Vent -[stop && 3ms/Vent]-> Open; \
         (Hold, Rest, Shut) -[ok]-> Drain -[!a || ok]-> Idle; }";
    let program = text(chart);
    assert!(!program.contains("entered."), "{program}");
    let cycle = program.split("deadline").next().unwrap_or_default();
    assert_eq!(cycle.matches(".now = state.").count(), 3, "{program}");
    for dialect in ["sfc", "grafcet"] {
        let chart = if dialect == "sfc" { chart.to_owned() } else { chart.replace("P k = k % 7 + 2;", "") };
        let model = read(&chart.replacen("sfc", dialect, 1));
        each_left_out(&model, &storm(&["go", "a", "b", "c", "ok", "stop"], 300), 150);
    }
    let press = "grafcet Press { input a, b, c, stop: bool; output p, q, r: bool; var n: u8 = 0; \
         partial Safety { initial step Ready; step Stopped { force Robot {}; force Modes {}; } step Acked { force Robot {Parked}; force Modes {INIT}; } \
             Ready -[stop]-> Stopped -[!stop && rising(a)]-> Acked -[true]-> Ready; } \
         partial Modes { initial step Manual { p; } enclosing step Auto { partial Press { linked step Wait; step Feed { q; } step Clamp { r; P1 n = n % 5 + 1; } step Lower { q; r; } step Offer; \
                 Wait -[b]-> Feed -[!b]-> Clamp -[c]-> Lower -[a || n > 2]-> Offer -[rising(Robot::Carry.X)]-> Wait; } } \
             Manual -[a && !stop]-> Auto -[!a && Press::Wait.X]-> Manual; } \
         partial Robot { initial step Parked; step Reach { p; } step Grip { q; } step Carry { r; } \
             Parked -[Press::Offer.X]-> Reach -[c]-> Grip -[!c]-> Carry -[b]-> Parked; } }";
    let program = text(press);
    assert!(program.matches("state.Parked is Carry").count() <= 2, "{program}");
    each_left_out(&read(press), &storm(&["a", "b", "c", "stop"], 400), 150);
}

/// A chain of steps, or two branches of one, in which each step has an action; each that calls, or stores more than a boolean.
fn chain(steps: usize, branches: bool, act: &dyn Fn(usize) -> String) -> String {
    let mut text = "sfc Chain { input a, b, c, d: bool; output p: bool; var n: u16 = 0; action log(v: u8); action beep(); step E; step F; initial step I; ".to_owned();
    for number in 0..steps {
        _ = write!(text, "step S{number} {{ {} }} ", act(number));
    }
    let half = if branches { steps / 2 } else { steps };
    for number in 0..steps {
        let to = match number + 1 {
            next if next == steps => "F".to_owned(),
            next if next == half => "E".to_owned(),
            next => format!("S{next}"),
        };
        _ = write!(
            text,
            "S{number} -[{}]-> {to}; ",
            ["a", "b && 2ms/", "c", "!d"][number % 4].replace('/', &format!("/S{number}"))
        );
    }
    text + if branches { "I -[a || b]-> (S0, S" } else { "F -[a]-> E; I -[a || b]-> S0; E -[c || d]-> I; } " }
        + &if branches { format!("{half}); (E, F) -[c || d]-> I; }}") } else { String::new() }
}

/// What a chart takes grows with its steps, and not with their square, whatever they run: what is the same for all of them stands after the ways, once.
#[test]
fn many_actions_are_not_run_on_each_way() {
    let kinds: [(&str, &dyn Fn(usize) -> String); 6] = [
        ("calls of one action", &|at| format!("N beep() if {};", ["a", "b", "c", "d"][at % 4])),
        ("calls with arguments of their own", &|at| format!("N log({at}) if {};", ["b", "a", "d", "c"][at % 4])),
        ("stored code", &|at| if at % 2 == 0 { format!("S n = n % 50 + {at};") } else { format!("P1 n = {at};") }),
        ("code while a step is active", &|at| format!("N n = n % 50 + {at};")),
        ("code when a step is entered and left", &|at| format!("P n = n % 40 + {at};")),
        ("delayed calls", &|at| if at % 2 == 0 { "SD 2ms log(7);".to_owned() } else { "R log();".to_owned() }),
    ];
    for (name, act) in kinds {
        for branches in [false, true] {
            let lines = |steps: usize| {
                let program =
                    optimised(&read(&chain(steps, branches, act)), &Pass::ALL).expect("a program").to_string();
                program.lines().count()
            };
            // Nor does it take the macro a time that doubles with each step.
            let (few, many) = (lines(10), lines(80));
            assert!(many < 12 * few, "{name}, {branches}: {few} lines with 10 steps, {many} with 80");
            each_left_out(&read(&chain(12, branches, act)), &storm(&["a", "b", "c", "d"], 300), 150);
        }
    }
}

/// The stop of many steps is asked in front of the match; what may panic, only beside one of these.
#[test]
fn what_many_states_ask_first_is_asked_in_front_of_the_match() {
    let all = "S0|S1|S2|S3|S4|S5|S6|S7|S8";
    for (stop, asked) in [
        ("stop && a", format!("  if stop && a && state is {all}:")),
        ("level / 3 > 70 && stop", format!("  if state is {all} && level / 3 > 70 && stop:")),
    ] {
        let program = text(&line(stop));
        assert!(program.contains(&asked), "{program}");
        for dialect in ["sfc", "grafcet"] {
            each_left_out(&read(&line(stop).replacen("sfc", dialect, 1)), &storm(&["a", "b", "stop"], 300), 150);
        }
    }
}

/// Two steps that go on alike stay arms of their own where the time begins by whether the state has changed: LLVM knows the answer in each of them.
#[test]
fn arms_that_change_the_state_stay_apart_where_it_is_compared() {
    let sorter = |wait: &str| {
        format!(
            "sfc Sorter {{ input a, b, c, d, stop: bool; output p, q, r: bool; initial step Idle; step One {{ p; }} step Two {{ q; }} step On {{ r; }} step Off; \
             any -[stop && {wait}]-> Off; Idle -[a]-> One; Idle -[!a && b]-> Two; One -[a && b && c && d]-> On; Two -[a && b && c && d]-> On; \
             One -[c && !d && a && !b]-> Idle; Two -[c && !d && a && !b]-> Idle; On -[d]-> Idle; Off -[!stop]-> Idle; }}"
        )
    };
    // With one way for each of the two, so that the next state is stored once after all of them.
    let (timed, plain) = (sorter("1s/Idle"), sorter("!d").replace("any -[stop", "On -[stop"));
    let plain = plain.replace("One -[c && !d && a && !b]-> Idle; Two -[c && !d && a && !b]-> Idle;", "");
    let plain = plain.replace("-[a && b && c && d]-> On", "-[a && b && c && d || c && !d && a && !b]-> On");
    let program = text(&timed);
    assert!(program.contains("was.state != state") && !program.contains("One|Two:"), "{program}");
    assert!(text(&plain).contains("One|Two:"), "{}", text(&plain));
    for chart in [&timed, &plain] {
        each_left_out(&read(chart), &storm(&["a", "b", "c", "d", "stop"], 300), 150);
    }
}
