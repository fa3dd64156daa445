//! Charts run from their source: what a cycle tells, values by name, what the program around contributes.

use grafcet_sim::{Chart, Error, Kind, Phase, Program, Refused, Simulation, Value, interp};

fn chart(source: &str) -> Chart {
    Chart::parse(source).unwrap_or_else(|refused| panic!("{refused}"))
}

#[test]
fn a_cycle_tells_its_evolutions_by_name() {
    let chart = chart(
        "grafcet C { input go, back: bool; output q: bool; var n: u8 = 0;
           initial step A; step B { P1 n = n + 1; } step F { q; }
           A -[go]-> B -[true]-> F -[back]-> A; }",
    );
    let mut run = Simulation::new(&chart).expect("understood");
    assert!(run.is_active("A") && run.cycle(0, &[]).expect("understood").evolutions.is_empty());
    let cycle = run.cycle(1, &[("go", true.into())]).expect("understood");
    let told: Vec<_> =
        cycle.evolutions.iter().map(|one| (&one.cleared[..], &one.activated[..], &one.steps[..])).collect();
    assert_eq!(told, [(&[0][..], &[1][..], &[1][..]), (&[1], &[2], &[2])]);
    assert_eq!((cycle.outputs, cycle.variables), (vec![true.into()], vec![1_u8.into()]));
    assert_eq!(cycle.ran[0].text, "n = n + 1");
    assert_eq!((run.output("q"), run.variable("n"), run.variable("m")), (Some(true.into()), Some(1_u8.into()), None));
    assert_eq!(run.cycle(2, &[("stop", true.into())]), Err(Error::NoSuchName("stop".to_owned())));
    run.init().expect("understood");
    assert!(run.is_active("A"));
}

/// What the cycle cleared, the situation it ends in, and whether that is stable.
fn told(source: &str, inputs: &[&str]) -> (Vec<Vec<usize>>, Vec<usize>, bool) {
    let chart = chart(source);
    let set: Vec<(&str, Value)> = inputs.iter().map(|input| (*input, true.into())).collect();
    let cycle = Simulation::new(&chart).expect("understood").cycle(0, &set).expect("understood");
    let entered = cycle.evolutions.last().map(|last| last.steps.clone());
    assert!(entered.is_none_or(|entered| entered == cycle.steps), "{cycle:?}");
    (cycle.evolutions.into_iter().map(|one| one.cleared).collect(), cycle.steps, cycle.is_stable)
}

#[test]
fn what_the_bound_stops_has_not_taken_place() {
    let round = "grafcet T { max_evolutions 2; input a, b, c: bool; initial step S1; step S2; step S3;
                   S1 -[a]-> S2 -[b]-> S3 -[c]-> S1; }";
    assert_eq!(told(round, &["a", "b", "c"]), (vec![vec![0], vec![1]], vec![2], false));
    // It ends at the bound, and is stable.
    assert_eq!(told(round, &["a", "b"]), (vec![vec![0], vec![1]], vec![2], true));
    assert_eq!(told(round, &["a"]), (vec![vec![0]], vec![1], true));
    // A self-loop clears and changes nothing; one that counts goes on.
    let turns = |arrow: &str| {
        format!(
            "grafcet T {{ max_evolutions 3; input a: bool; var n: u8 = 0; initial step A; step B; {arrow}-> A; A -[false]-> B -[true]-> A; }}"
        )
    };
    assert_eq!(told(&turns("A -[a]"), &["a"]), (vec![vec![0]], vec![0], true));
    assert_eq!(told(&turns("A -[a && n < 5 => n = n + 1]"), &["a"]), (vec![vec![0]; 3], vec![0], false));
    assert_eq!(told(&turns("A -[a && n < 3 => n = n + 1]"), &["a"]), (vec![vec![0]; 3], vec![0], true));
}

#[test]
fn an_inner_step_entered_anew_is_left_and_entered() {
    let chart =
        chart("sfc C { input again: bool; initial step A; step B; A -[true]-> B; B -[again]-> B; B -[false]-> A; }");
    let mut run = Simulation::new(&chart).expect("understood");
    run.cycle(0, &[]).expect("understood");
    run.cycle(0, &[]).expect("understood");
    let cycle = run.cycle(0, &[("again", true.into())]).expect("understood");
    assert_eq!((&cycle.evolutions[0].deactivated[..], &cycle.evolutions[0].activated[..]), (&[1][..], &[1][..]));
}

#[test]
fn what_is_forced_and_called_is_told() {
    let chart = chart(
        "grafcet C { input stop: bool; action heat(to: i16);
           partial Safety { initial step Ready; step Stopped { force Work {}; } Ready -[stop]-> Stopped -[!stop]-> Ready; }
           partial Work { initial step Run { N heat(80); } step Rest; Run -[false]-> Rest -[true]-> Run; } }",
    );
    let mut run = Simulation::new(&chart).expect("understood");
    let cycle = run.cycle(0, &[]).expect("understood");
    assert_eq!((cycle.calls[0].phase, &cycle.calls[0].args[..]), (Phase::First, &[80_i16.into()][..]));
    let cycle = run.cycle(1, &[("stop", true.into())]).expect("understood");
    assert_eq!((cycle.forced[0].partial, cycle.forced[0].by, cycle.forced[0].order.as_str()), (2, 1, "{}"));
    assert_eq!((cycle.calls[0].phase, cycle.steps), (Phase::Final, vec![1]));
}

#[test]
fn values_of_all_kinds() {
    let chart = chart(
        "sfc C { input mode: Mode in {Off, Auto}; input kind: Kind; input level: f32; input dose: time;
           output shown: Kind = Kind::Small; output part: f32;
           initial step A { N part = level * 0.5; N shown = kind; } step B;
           A -[mode == Mode::Auto && kind == Kind::Large && level >= 1.5 && dose >= 2s]-> B -[false]-> A; }",
    );
    let kinds: Vec<&Kind> = chart.names().inputs.iter().map(|input| &input.kind).collect();
    assert_eq!(
        kinds,
        [
            &Kind::Listed("Mode".to_owned(), vec!["Off".to_owned(), "Auto".to_owned()]),
            &Kind::Other("Kind".to_owned()),
            &Kind::Float(32),
            &Kind::Time
        ]
    );
    let mut run = Simulation::new(&chart).expect("understood");
    let inputs = [("mode", "Mode::Auto".into()), ("kind", "Kind::Large".into()), ("level", 1.5_f32.into())];
    let cycle = run.cycle(0, &inputs).expect("understood");
    assert_eq!(cycle.inputs, ["Auto".into(), "Large".into(), Value::Float(1.5), Value::Ticks(0)]);
    assert_eq!(cycle.outputs, ["Large".into(), Value::Float(0.75)]);
    assert!(cycle.blocked.to_string().ends_with("waits for `dose >= 2s` (dose = 0 s)"), "{}", cycle.blocked);
    run.cycle(1, &[("dose", Value::Ticks(2000))]).expect("understood");
    assert!(run.is_active("B"));
    assert!(run.cycle(2, &[("level", true.into())]).is_err(), "a boolean is no float");
}

#[test]
fn what_the_program_contributes() {
    let source = "sfc C { input x: i16; output n: u8; var seen: u8 = 0;
        initial step A { N n = LIMIT; } step B { P1 { for _ in 0..3 { seen += count(x); } } }
        A -[near(x, 3)]-> B -[false]-> A; }";
    let chart = chart(source);
    let unknown = |error: Error| matches!(error, Error::Chart(interp::Error::NotUnderstood(_)));
    assert!(Simulation::new(&chart).expect("understood").cycle(0, &[]).is_err_and(unknown), "LIMIT");
    let program = Program::new()
        .constant("LIMIT", 9_u8)
        .function(|asked| match asked.value("x") {
            Some(Value::Int(x)) if asked.is("near( x,3 )") => Some(Value::Bool((x - 3).abs() < 2)),
            _ => None,
        })
        .block(|asked| asked.text.contains("count").then(|| vec![("seen".to_owned(), 7_u8.into())]));
    let mut run = Simulation::beside(&chart, program).expect("understood");
    assert_eq!(run.cycle(0, &[]).expect("understood").outputs, [9_u8.into()]);
    run.cycle(1, &[("x", 5_i16.into())]).expect("understood");
    assert!(run.is_active("A"), "5 is not near");
    let cycle = run.cycle(2, &[("x", 4_i16.into())]).expect("understood");
    assert!(run.is_active("B"));
    assert_eq!(cycle.variables, [7_u8.into()]);
}

#[test]
fn a_chart_in_a_file_has_the_lines_of_the_file() {
    let file = "use grafcet::grafcet;\n\nmod inner {\n    grafcet! {\n        sfc One { initial step A; step B; A -[true]-> B -[true]-> A; }\n    }\n}\n
grafcet! {\n    /// Two.\n    pub sfc Two {\n        initial step A;\n        step B;\n        A -[true]-> B -[true]-> A;\n    }\n}\n";
    let lines = |name| {
        let chart = Chart::in_file(file, name).expect("a chart");
        let names = chart.names();
        (names.steps.iter().map(|step| step.line).collect::<Vec<_>>(), names.transitions[0].line)
    };
    assert_eq!(lines("One"), (vec![5, 5], 5));
    assert_eq!(lines("Two"), (vec![12, 13], 14));
    assert_eq!(Chart::in_file(file, "Three").err(), Some(Refused::Missing("Three".to_owned())));
    let wrong = Chart::parse("sfc C {\n initial step A;\n A -[true]-> B;\n}").err();
    assert!(matches!(wrong, Some(Refused::Chart(messages)) if messages[0].0 == 3), "the message has its line");
}

#[test]
fn examples_run_from_their_files() {
    let file = include_str!("../../examples/charts/branch_on_result.rs");
    let chart = Chart::in_file(file, "Sorter").expect("a chart");
    let mut sorter = Simulation::new(&chart).expect("understood");
    sorter.cycle(0, &[]).expect("understood");
    sorter.cycle(0, &[("piece", true.into()), ("length", 502_u16.into())]).expect("understood");
    sorter.cycle(0, &[]).expect("understood");
    assert!(sorter.is_active("Keep"), "|502 - 500| <= 3");
}

#[test]
fn a_simulation_is_put_into_a_situation_by_hand() {
    let chart = chart(
        "sfc Press { input start, at_top, at_bottom: bool; output lower, lift: bool; var n: u8 = 0;
           initial step Ready; step Lower { lower; } step Hold { P1 n = n + 1; } step Lift { lift; P0 n = n + 10; }
           Ready -[start && at_top]-> Lower -[at_bottom]-> Hold -[2s/Hold]-> Lift -[at_top]-> Ready; }",
    );
    let mut press = Simulation::new(&chart).expect("understood");
    press.cycle(0, &[]).expect("a cycle");
    let cycle = press.force(10, &["Lift"], &[("at_top", true.into())]).expect("a cycle by hand");
    assert!(press.is_active("Lift") && cycle.evolutions.len() == 1 && cycle.evolutions[0].cleared.is_empty());
    assert_eq!(press.output("lift"), Some(Value::Bool(true)));
    press.force(20, &["Hold"], &[]).expect("a cycle by hand");
    assert_eq!(press.variable("n"), Some(Value::Int(11)));
    // The time of the step begins with the cycle by hand.
    press.cycle(2_019, &[]).expect("a cycle");
    assert!(press.is_active("Hold"));
    press.cycle(2_020, &[]).expect("a cycle");
    assert!(press.is_active("Lift"));
    assert_eq!(press.force(2_030, &["Hode"], &[]).unwrap_err().to_string(), "the chart has no step `Hode`");
}
