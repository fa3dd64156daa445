//! `never`, `always`, `home`: proved, violated by the shortest way, or undecided with a reason.

#[path = "../judged/mod.rs"]
mod judged;

mod future;
mod home;
mod stopped;
mod undecided;

use judged::{diagnostics, said};

/// The chart is right.
fn holds(chart: &str) {
    assert_eq!(said(chart), Vec::<String>::new(), "{chart}");
}

/// The only thing that is wrong with the chart; returned are the lines of its message after the first.
fn fails(chart: &str, rule: &str, word: &str) -> Vec<String> {
    let said = said(chart);
    let [one] = &said[..] else { panic!("{chart}: {said:#?}") };
    assert!(one.starts_with(&format!("{rule}: ")) && one.contains(word), "{chart}: {one}");
    one.lines().skip(1).map(str::to_owned).collect()
}

/// Two partial grafcets: what is asked of the first has nothing to do with the second.
fn beside(first: &str, second: &str, rest: &str) -> String {
    format!(
        "grafcet C {{ #![allow(grafcet::unused_input, grafcet::undriven_output, grafcet::unused_variable)] \
         input a, b, c, d, e: bool; input level: u16; input text: Text; output q, r, s: bool; var n: u16 = 0; \
         partial One {{ {first} }} partial Two {{ {second} }} {rest} }}"
    )
}

/// `never` and `always` in a chart of two steps.
fn motor(property: &str) -> String {
    format!(
        "sfc Motor {{ input on, off, hot: bool; output relay, green, red: bool; \
         initial step Off {{ N red; }} step On {{ N relay; N green if !hot; }} \
         Off -[on && !hot]-> On -[off || hot]-> Off; {property} }}"
    )
}

#[test]
fn what_holds() {
    for property in [
        "never red && relay;",
        "never Off.X && On.X;",
        "always Off.X || On.X;",
        "always relay => On.X;",
        "always red == Off.X;",
        "always green => !hot && On.X;",
        "always red != relay;",
        "never relay && hot;",
        "home Off;",
        "home On;",
        "never !(relay || red);",
    ] {
        holds(&motor(property));
    }
}

#[test]
fn what_does_not() {
    let table = fails(&motor("never relay && off;"), "property_violated", "at the end of cycle 2 `relay && off` holds");
    assert_eq!(
        table,
        [
            "cycle | inputs        | cleared  | active",
            "1     | any           | -        | Off",
            "2     | on, !hot, off | Off → On | On"
        ]
    );
    let table = fails(
        &motor("always relay => green && !off;"),
        "property_violated",
        "`relay` holds and `green && !off` does not",
    );
    assert_eq!(table.len(), 3);
    let table =
        fails(&motor("always !red;"), "property_violated", "at the end of the first cycle `!red` does not hold");
    assert_eq!(table, ["cycle | inputs | cleared | active", "1     | any    | -       | Off"]);
    let all = diagnostics(&motor("never relay; home Off; never red;"));
    assert_eq!(all.len(), 2);
}

/// In a `grafcet` the first cycle evaluates conditions, and transient situations are not seen.
#[test]
fn grafcet() {
    let chart = |property: &str| {
        format!(
            "grafcet Line {{ input a, b: bool; output q, r: bool; initial step One {{ q; }} step Two {{ S r; }} step Three {{ R r; }} \
             One -[a]-> Two -[b]-> Three -[!a]-> One; {property} }}"
        )
    };
    let table = fails(&chart("never Two.X;"), "property_violated", "at the end of the first cycle `Two.X` holds");
    assert_eq!(table[1], "1     | a, !b  | One → Two | Two");
    holds(&chart("never Two.X && b;"));
    holds(&chart("always r == Two.X;"));
    holds(&chart("never q && r;"));
    holds(&chart("home One;"));
    let table = fails(&chart("never Three.X && r || One.X && !b && !a;"), "property_violated", "first cycle");
    assert_eq!(table[1], "1     | !a, !b | -       | One");
}

/// Stored outputs are followed from cycle to cycle.
#[test]
fn stored_outputs() {
    let chart = |property: &str| {
        format!(
            "sfc Door {{ input open, shut: bool; output light, lock: bool; initial step Wait; step Opening {{ S light; P1 lock = false; }} \
             step Shutting {{ P1 lock = open; }} step Shut {{ R light; }} \
             Wait -[open]-> Opening -[shut]-> Shutting -[true]-> Shut -[true]-> Wait; {property} }}"
        )
    };
    holds(&chart("always Opening.X || Shutting.X => light;"));
    holds(&chart("never Wait.X && light;"));
    holds(&chart("never Opening.X && lock;"));
    let table = fails(&chart("never Wait.X && lock;"), "property_violated", "cycle 5");
    assert_eq!(table.len(), 6);
    assert!(table[3].starts_with("3     | open, shut "), "{table:#?}");
}

#[test]
fn assumptions_make_it_hold() {
    let chart = |assumption: &str| {
        format!(
            "grafcet Hoist {{ input up, down: bool; output raise, lower: bool; initial step Wait; step Raise {{ raise; }} step Lower {{ lower; }} \
             #[allow(grafcet::overlapping_branches, grafcet::unsafe_step)] Wait -[up]-> Raise -[!up]-> Wait -[down]-> Lower -[!down]-> Wait; \
             {assumption} never raise && lower; never up && down && Wait.X; }}"
        )
    };
    let all = said(&chart("#[allow(grafcet::unsafe_step)]"));
    assert!(all.iter().any(|one| one.starts_with("property_violated")), "{all:?}");
    holds(&chart("assume never up && down;"));
}

/// Times count as unknown.
#[test]
fn times() {
    let chart = |property: &str| {
        format!(
            "sfc Oven {{ input start, door: bool; output lamp, fan, horn, heat: bool; initial step Idle {{ D 5s horn; }} \
             step Bake {{ L 10s heat; N lamp if 2s/Bake; SD 3s fan; }} step Cool {{ R fan; }} \
             Idle -[start]-> Bake -[30s/Bake]-> Cool -[door && 5s/Cool]-> Idle; {property} }}"
        )
    };
    holds(&chart("never lamp && Idle.X;"));
    holds(&chart("home Idle;"));
    let table = fails(&chart("never Cool.X;"), "property_violated", "cycle 3");
    assert_eq!(table[3], "3     | Bake.T >= 30s | Bake → Cool | Cool");
    fails(&chart("always Bake.X => lamp;"), "property_violated", "cycle 2");
}

/// Qualifiers with times: while they act, an output may be on or off.
#[test]
fn timed_outputs() {
    let chart = |property: &str| {
        format!(
            "sfc Oven {{ input start, door: bool; output heat, horn, fan, lamp, bell: bool; \
             initial step Idle {{ D 5s horn; R lamp; R bell; }} step Bake {{ L 10s heat; SD 3s fan; DS 3s lamp; SL 3s bell; }} \
             step Cool {{ R fan; }} \
             Idle -[start]-> Bake -[30s/Bake]-> Cool -[door && 5s/Cool]-> Idle; {property} }}"
        )
    };
    for property in [
        "never heat && Idle.X;",
        "never heat && Cool.X;",
        "always horn => Idle.X;",
        "never fan && Cool.X;",
        "never fan && Idle.X;",
        "never lamp && Idle.X;",
        "never bell && Idle.X;",
    ] {
        holds(&chart(property));
    }
    // When they come on, and whether, is no matter of situations.
    for property in [
        "never heat;",
        "always Bake.X => heat;",
        "never horn;",
        "never fan && heat;",
        "never lamp && Cool.X;",
        "always Cool.X => lamp || bell;",
    ] {
        fails(&chart(property), "property_undecided", "`cargo grafcet prove` asks a solver, too");
    }
}

#[test]
fn hierarchy() {
    let chart = |property: &str| {
        format!(
            "grafcet Cell {{ input estop, start, full: bool; output belt, lamp: bool; \
             partial Safety {{ initial step Ready; step Stopped {{ force Production {{}}; lamp; }} step Restart {{ force Production {{INIT}}; }} \
             Ready -[estop]-> Stopped -[!estop]-> Restart -[true]-> Ready; }} \
             partial Production {{ initial step Idle; step Feed {{ belt; }} enclosing step Auto {{ partial Inner {{ linked step Count; }} }} \
             Idle -[start]-> Feed -[full]-> Auto -[!full]-> Idle; }} {property} }}"
        )
    };
    holds(&chart("never Stopped.X && belt;"));
    holds(&chart("always Count.X == Auto.X;"));
    holds(&chart("home (Ready, Idle);"));
    holds(&chart("home Stopped;"));
    fails(&chart("home (Stopped, Idle);"), "not_home", "is never reached");
    fails(&chart("never Production::Auto.X && full;"), "property_violated", "first cycle");
}

/// Comparisons of one float with literals are related to each other.
#[test]
fn floats() {
    let chart = |ty: &str, property: &str| {
        format!(
            "sfc Heater {{ input temp: {ty}; output heat: bool; initial step Cold {{ N heat; }} step Warm; \
             Cold -[temp > 80.5]-> Warm -[temp <= 60.1]-> Cold; {property} }}"
        )
    };
    for ty in ["f32", "f64"] {
        holds(&chart(ty, "home Cold;"));
        holds(&chart(ty, "never Warm.X && temp < 60.1 && temp > 60.2;"));
        let table = fails(&chart(ty, "never Warm.X && temp < 90.0;"), "property_violated", "cycle 2");
        assert!(table[2].contains("temp > 80.5, temp < 90 "), "{table:#?}");
        let table = fails(&chart(ty, "never Cold.X && temp == 60.1;"), "property_violated", "the first cycle");
        assert!(table[1].contains("temp == 60.1"), "{table:#?}");
    }
}

#[test]
fn contents() {
    let chart = |property: &str| {
        format!(
            "grafcet C {{ input a: bool; input level: u8; output q: bool; output speed: u8; var v: bool; \
             initial step A {{ q; speed = level; }} macro step M {{ entry step E; exit step F {{ S v; }} E -[a]-> F; }} step B {{ R v; }} \
             A -[rising(a)]-> M -[!a && v]-> B -[a]-> A; {property} }}"
        )
    };
    holds(&chart("never M.X && A.X; always level > 5 && A.X => q; never F.X && E.X; always true; never v && A.X;"));
    for (property, word) in [
        ("never speed > 3;", "it depends on `speed`"),
        ("never rising(a) && B.X;", "it depends on `rising(a)`"),
        ("never 5s/A;", "it depends on `5s/A`"),
        ("always A.T < 5s || M.T > 1s;", "it depends on `A.T`, `M.T`"),
        ("never 5s/a;", "it depends on `5s/a`"),
        ("never blink(500ms, A);", "it depends on `blink(500ms"),
        ("always a => w;", "unknown_name"),
        ("home Nowhere;", "unknown_step"),
        ("home M;", "is a macro-step"),
        ("home (B, B);", "repeated_step"),
        ("home a;", "unknown_step"),
        ("never A && a;", "`A` is a step"),
    ] {
        let said = said(&chart(property));
        assert!(matches!(&said[..], [one] if one.contains(word)), "{property}: {said:?}");
    }
    let inside =
        "grafcet C { input a: bool; partial Part { initial step A; step B; A -[a]-> B -[!a]-> A; never B.X; } }";
    assert!(said(inside)[0].contains("stands directly in it"), "{:?}", said(inside));
}

/// What only a property reads is used.
#[test]
fn usage() {
    holds("sfc C { input a, b: bool; initial step A; step B; A -[a]-> B -[!a]-> A; always b || !b; }");
}

/// A property is not broken by a time that falls back.
#[test]
fn times_that_pass() {
    let chart = |property: &str| {
        format!(
            "sfc C {{ input a: bool; output late, quick: bool; initial step O {{ R late; }} \
             step A {{ S late if A.T >= 5s; N quick if A.T < 5s; }} O -[a]-> A -[a]-> O; {property} }}"
        )
    };
    holds(&chart("never late && quick;"));
    let table = fails(&chart("never late && A.X;"), "property_violated", "cycle 3");
    assert_eq!(table[3], "3     | !a, A.T >= 5s | -       | A");
}

/// The edge of a step in an action compares what two evolutions have led to; in the first cycle there is none.
#[test]
fn edges_of_steps_in_actions() {
    let chart = |property: &str| {
        format!(
            "sfc C {{ #![allow(grafcet::never_true)] input a, b: bool; output q, s, t, u, v: bool; \
             initial step A {{ N u if rising(A.X); }} step B {{ N q if rising(B.X); N v if rising(B.X && a); }} \
             step E {{ N s if rising(B.X || A.X); N t if falling(B.X) && !rising(E.X); }} \
             A -[a]-> B -[!a]-> E -[a && b]-> B; {property} }}"
        )
    };
    for property in ["never s;", "never t;", "never u;", "always q => B.X;"] {
        holds(&chart(property));
    }
    let way = fails(&chart("never q;"), "property_violated", "`q` holds");
    assert_eq!(way.len(), 3, "{way:?}");
    // Beside an input it counts as unknown.
    fails(&chart("never v && !q;"), "property_undecided", "`rising(B.X && a)`");
}
