//! A chart that is played with: forwards, and back.

use grafcet_web::Play;
use serde_json::{Value, json};

const DOOR: &str = "sfc Door { input open: bool; output motor: bool; param most: time = 2s;
    initial step Shut; step Opening { N motor; } Shut -[open]-> Opening -[Opening.T >= most]-> Shut; }";

fn door() -> Play {
    Play::new(DOOR, 10).expect("a chart")
}

/// The numbers of the cycles that are shown.
fn numbers(shown: &Value) -> Vec<u64> {
    shown.as_array().expect("moments").iter().map(|one| one["number"].as_u64().expect("a number")).collect()
}

#[test]
fn what_changes_nothing_is_not_shown() {
    let mut door = door();
    // The first cycle is always new; of those after it the last one is shown for its time.
    let shown = door.advance(5).expect("cycles");
    assert_eq!(numbers(&shown), [1, 5]);
    assert_eq!(
        (&shown[1]["elapsed"], &shown[1]["isNew"], &shown[1]["steps"]),
        (&json!(40), &json!(false), &json!([0]))
    );
    assert_eq!(shown[1]["waits"], json!([[0, "`Shut → Opening` waits for `open` (false)"]]));
    door.set(0, "true").expect("an input");
    // In the cycle in which it comes, the transition clears and the motor turns.
    let shown = door.advance(2).expect("cycles");
    assert_eq!(numbers(&shown), [6, 7]);
    assert_eq!(
        (&shown[0]["steps"], &shown[0]["outputs"], &shown[0]["evolutions"][0]["cleared"]),
        (&json!([1]), &json!([true]), &json!([0]))
    );
}

#[test]
fn what_changes_without_an_evolution_is_shown() {
    // Entered in the first cycle, at 0 ms; the fourth one is at 30 ms, the sixth at 50 ms.
    let mut play = Play::new(
        "sfc Q { input on: bool; output slow: bool; initial step A within 50ms { D 30ms slow; } step B; A -[on]-> B -[!on]-> A; }",
        10,
    )
    .expect("a chart");
    let shown = play.advance(8).expect("cycles");
    assert_eq!(numbers(&shown), [1, 4, 6, 8]);
    let seen = |place: usize| (&shown[place]["outputs"], &shown[place]["late"]);
    assert_eq!(seen(0), (&json!([false]), &json!([])));
    assert_eq!(seen(1), (&json!([true]), &json!([])));
    assert_eq!(seen(2), (&json!([true]), &json!(["A"])));
}

#[test]
fn to_the_next_change() {
    let mut door = door();
    door.set(0, "true").expect("an input");
    assert_eq!(door.skip(10).expect("a cycle")["steps"], json!([0]), "an sfc begins with its initial step");
    let opening = door.skip(10).expect("a cycle");
    assert_eq!((&opening["number"], &opening["steps"]), (&json!(2), &json!([1])));
    door.set(0, "false").expect("an input");
    assert_eq!(door.skip(10).expect("a cycle")["number"], json!(3), "the input is a change");
    // The step was entered at 10 ms: two seconds later, at 2,010 ms, is the 202nd cycle.
    let shut = door.skip(1000).expect("a cycle");
    assert_eq!((&shut["number"], &shut["elapsed"], &shut["steps"]), (&json!(202), &json!(2010), &json!([0])));
    assert_eq!(door.skip(7).expect("a cycle")["number"], json!(209), "it stays shut");
}

#[test]
fn back_and_on_again_is_the_same() {
    let mut door = door();
    door.advance(3).expect("cycles");
    door.set(0, "true").expect("an input");
    let first = door.advance(50).expect("cycles");
    // Into the middle of a stretch in which nothing changed.
    let back = door.rewind(20).expect("kept");
    assert_eq!(
        (&back["number"], &back["elapsed"], &back["steps"], &back["values"]),
        (&json!(20), &json!(190), &json!([1]), &json!([true]))
    );
    let again = door.advance(33).expect("cycles");
    assert_eq!(again.as_array().and_then(|all| all.last()), first.as_array().and_then(|all| all.last()));
    let begin = door.rewind(0).expect("kept");
    assert_eq!((&begin["number"], &begin["values"], &begin["isFirst"]), (&json!(0), &json!([false]), &json!(true)));
    assert!(door.rewind(1).is_err(), "that has not happened yet");
    let shown = door.advance(2).expect("cycles");
    assert_eq!(
        (&shown[1]["values"], &shown[1]["steps"]),
        (&json!([false]), &json!([0])),
        "the input is what it was then"
    );
}

#[test]
fn back_before_the_cycle_time_was_changed() {
    let mut door = door();
    door.advance(5).expect("cycles");
    door.step_by(100);
    let shown = door.advance(3).expect("cycles");
    assert_eq!((numbers(&shown), &shown[1]["elapsed"]), (vec![6, 8], &json!(340)));
    // Cycles 1 to 4 were at 0, 10, 20 and 30 ms.
    assert_eq!(door.rewind(4).expect("kept")["elapsed"], json!(30));
    assert_eq!(door.advance(1).expect("a cycle")[0]["elapsed"], json!(130), "from here on it is the new one");
}

#[test]
fn another_parameter_acts_from_the_next_cycle_on() {
    let mut door = door();
    door.set(0, "true").expect("an input");
    door.advance(2).expect("cycles");
    door.set_param(0, "30").expect("a parameter");
    assert_eq!(door.now()["params"], json!([30]));
    // Entered at 10 ms, left at 40 ms: the fifth cycle.
    let shown = door.advance(3).expect("cycles");
    assert_eq!(
        (numbers(&shown).last(), &shown[shown.as_array().map_or(0, Vec::len) - 1]["steps"]),
        (Some(&5), &json!([0]))
    );
    assert_eq!(door.rewind(3).expect("kept")["params"], json!([30]), "it was so in that cycle");
    assert_eq!(door.rewind(2).expect("kept")["params"], json!([2000]), "and not yet in this one");
}

#[test]
fn a_parameter_that_changes_nothing_to_be_seen_is_there_on_the_way_back() {
    let mut door = door();
    door.advance(5).expect("cycles");
    door.set_param(0, "30").expect("a parameter");
    door.advance(5).expect("cycles");
    assert_eq!(door.rewind(8).expect("kept")["params"], json!([30]));
    assert_eq!(door.rewind(5).expect("kept")["params"], json!([2000]));
}

#[test]
fn init_is_taken_back_as_everything_else() {
    let mut door = door();
    door.set(0, "true").expect("an input");
    door.advance(4).expect("cycles");
    door.init().expect("initial values");
    assert_eq!((&door.now()["steps"], &door.now()["isFirst"]), (&json!([0]), &json!(true)));
    // The fifth cycle is like the first one, the sixth leads to the second step again.
    door.advance(3).expect("cycles");
    assert_eq!(door.rewind(5).expect("kept")["steps"], json!([0]));
    assert_eq!(door.rewind(4).expect("kept")["steps"], json!([1]), "before it was put back");
    door.advance(1).expect("a cycle");
    assert_eq!(door.now()["steps"], json!([1]), "which has not happened any more");
    door.init().expect("initial values");
    assert_eq!(door.rewind(5).expect("kept")["steps"], json!([1]), "what has not had its cycle yet is taken back, too");
}

#[test]
fn a_value_that_cannot_be_is_refused() {
    let mut play = Play::new(
        "sfc V { input small: u8; input deep: i8; input big: u128; input mode: Mode in {Auto, Hand}; initial step A; step B;
         A -[small > 1 && deep < 0 && big > 1 && mode == Mode::Hand]-> B -[small == 0]-> A; }",
        1,
    )
    .expect("a chart");
    for (place, good, bad) in
        [(0, "255", "256"), (1, "-128", "-129"), (2, "7", "-1"), (3, "Hand", "Both"), (0, "0", "one")]
    {
        assert!(play.set(place, good).is_ok(), "{good}");
        assert!(play.set(place, bad).is_err(), "{bad}");
    }
    assert!(play.set(9, "1").is_err());
    assert!(Play::new("sfc V {", 1).is_err());
}

#[test]
fn arithmetic_that_fails_leaves_the_chart_where_it_was() {
    let mut play = Play::new(
        "sfc V { input go: bool; output n: u8; initial step A { P1 { n = n + 100; } } step B; A -[go]-> B -[!go]-> A; }",
        1,
    )
    .expect("a chart");
    play.advance(3).expect("n is 100");
    for (go, n) in [("true", 100), ("false", 200)] {
        play.set(0, go).expect("an input");
        assert_eq!(play.advance(1).expect("a cycle")[0]["outputs"], json!([n]));
    }
    play.set(0, "true").expect("an input");
    play.advance(1).expect("a cycle");
    play.set(0, "false").expect("an input");
    let error = play.advance(1).expect_err("300 is no u8");
    assert!(error.contains("overflow"), "{error}");
    assert_eq!((&play.now()["number"], &play.now()["outputs"]), (&json!(6), &json!([200])));
}

/// Two branches that are left together.
const PRESS: &str = "sfc Press { forceable; input go, done: bool; output down, lamp: bool;
    initial step Up; step Down { N down; } step Light { N lamp; }
    Up -[go]-> (Down, Light); (Down, Light) -[done]-> Up; }";

#[test]
fn by_hand_as_the_compiled_chart_lets_itself_be_put() {
    let mut press = Play::new(PRESS, 10).expect("a chart");
    assert_eq!(press.names()["forceable"], json!(true));
    press.advance(3).expect("cycles");
    let shown = press.by_hand(&[1, 2]).expect("a situation");
    assert_eq!(
        (&shown["number"], &shown["steps"], &shown["outputs"], &shown["isNew"]),
        (&json!(4), &json!([1, 2]), &json!([true, true]), &json!(true))
    );
    assert_eq!(shown["elapsed"], json!(30), "it is the next cycle");
    let refused = |press: &mut Play, steps: &[usize]| press.by_hand(steps).expect_err("no situation");
    assert_eq!(refused(&mut press, &[0, 2]), "`Up` and `Light` are never active together");
    assert_eq!(refused(&mut press, &[1]), "the chart has no situation of exactly these steps");
    assert_eq!(refused(&mut press, &[7]), "there is no such step");
    assert_eq!(press.now(), shown, "what is refused changes nothing");
    let mut plain = door();
    assert_eq!(plain.names()["forceable"], json!(false));
    assert!(plain.by_hand(&[1]).is_err_and(|why| why.contains("does not say `forceable;`")));
}

#[test]
fn what_was_forced_is_there_on_the_way_back() {
    let mut press = Play::new(PRESS, 10).expect("a chart");
    press.advance(2).expect("cycles");
    press.set(0, "true").expect("an input");
    // It would go down; by hand it stays where it is, and goes down a cycle later.
    let held = press.by_hand(&[0]).expect("a situation");
    assert_eq!((&held["number"], &held["steps"]), (&json!(3), &json!([0])));
    let held_again = press.by_hand(&[0]).expect("a situation");
    assert_eq!((&held_again["number"], &held_again["steps"]), (&json!(4), &json!([0])));
    assert_eq!(press.advance(1).expect("a cycle")[0]["steps"], json!([1, 2]));
    press.advance(5).expect("cycles");
    for (cycle, steps) in [(5, json!([1, 2])), (4, json!([0])), (3, json!([0])), (2, json!([0]))] {
        assert_eq!(press.rewind(cycle).expect("kept")["steps"], steps, "cycle {cycle}");
    }
}
