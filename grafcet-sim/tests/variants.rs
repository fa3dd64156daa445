//! Variants of one enum, which the chart lists, lists in another order, or does not list.

use grafcet_sim::{Chart, Cycle, Kind, Program, Simulation, Value, interp};

/// Cycles with these inputs, `a` for one that is on and `e=Green` for one that is a colour.
fn run(source: &str, program: Program<'_>, cycles: &[&str]) -> Vec<Cycle> {
    let chart = Chart::parse(source).unwrap_or_else(|refused| panic!("{refused}"));
    let mut run = Simulation::beside(&chart, program).unwrap_or_else(|error| panic!("{source}: {error}"));
    let set = |text: &&str| {
        let inputs = text.split_whitespace().map(|one| one.split_once('='));
        let inputs = inputs.zip(text.split_whitespace());
        let inputs: Vec<(&str, Value)> = inputs
            .map(|(split, name)| split.map_or((name, true.into()), |(name, colour)| (name, colour.into())))
            .collect();
        run.cycle(0, &inputs).unwrap_or_else(|error| panic!("{source}: {error}"))
    };
    cycles.iter().map(set).collect()
}

fn names<const N: usize>(names: [&str; N]) -> [Value; N] {
    names.map(Value::from)
}

#[test]
fn an_output_shows_a_listed_variable() {
    let shown = run(
        "sfc A { input a: bool; var ve: Colour in {Red, Green} = Colour::Green; output en: Colour = Colour::Red;
           initial step S1 { P1 en = ve; } step S2; S1 -[a && en == Colour::Green]-> S2 -[!a]-> S1; }",
        Program::new(),
        &["", "a"],
    );
    assert_eq!(shown[0].outputs, names(["Green"]));
    assert_eq!(shown[1].steps, [1]);
}

#[test]
fn listed_and_unlisted_variants_are_compared_by_name() {
    for (lists, cycles) in [
        ("input e: Colour; input f: Colour in {Red, Green};", ["e=Red f=Red", "", "f=Green", "e=Green"]),
        // Places that are the same in both lists are other variants.
        (
            "input e: Colour in {Green, Red}; input f: Colour in {Red, Green};",
            ["e=Red f=Red", "", "f=Green", "e=Green"],
        ),
    ] {
        for condition in ["e == f", "f == e", "(if true { f } else { e }) == e"] {
            let chart = format!("sfc A {{ {lists} initial step S1; step S2; S1 -[{condition}]-> S2 -[e != f]-> S1; }}");
            let steps: Vec<usize> = run(&chart, Program::new(), &cycles).iter().map(|cycle| cycle.steps[0]).collect();
            assert_eq!(steps, [0, 1, 0, 1], "{chart}");
        }
    }
}

#[test]
fn what_another_list_has_elsewhere_keeps_its_name() {
    let source = "sfc A { input e: Colour in {Red, Green, Blue}; input u: Colour; var v: Colour in {Blue, Green, Red} = Colour::Blue;
           var w: Colour in {Green, Red, Blue} = Colour::Red; param p: Colour in {Green, Blue, Red} = Colour::Red;
           output x: Colour = Colour::Blue; output y: Colour; action show(a: Colour, b: Colour);
           initial step S1 { P1 v = e; P1 { w = if v == p { u } else { v }; x = w; } P1 y = p; P1 show(v, w); } step S2;
           S1 -[matches!(w, Colour::Blue | Colour::Green) && v != x]-> S2 -[false]-> S1; }";
    for (inputs, variables, outputs, step) in [
        ("e=Red u=Green", ["Red", "Green"], ["Green", "Red"], 1),
        ("e=Red u=Red", ["Red", "Red"], ["Red", "Red"], 0),
        ("e=Blue u=Red", ["Blue", "Blue"], ["Blue", "Red"], 0),
    ] {
        let shown = run(source, Program::new(), &[inputs, ""]);
        assert_eq!((&shown[0].variables[..], &shown[0].outputs[..]), (&names(variables)[..], &names(outputs)[..]));
        assert_eq!(
            (&shown[0].calls[0].args[..], &shown[1].steps[..]),
            (&names(variables)[..], &[step][..]),
            "{inputs}"
        );
    }
}

/// Also where it counts variants, as the prover does.
#[test]
fn the_program_tells_variants() {
    let source = "sfc A { input e: Colour in {Red, Green}; var v: Colour in {Green, Red} = Colour::Red; output x: Colour = Colour::Red;
           initial step S1 { P1 v = next(e); P1 { for _ in 0..2 { x = v; } } } step S2; S1 -[e == last() && v == e]-> S2 -[false]-> S1; }";
    let chart = Chart::parse(source).unwrap_or_else(|refused| panic!("{refused}"));
    let kinds: Vec<Kind> = chart.outside().into_iter().map(|signal| signal.kind).collect();
    let listed = |names: [&str; 2]| Kind::Listed("Colour".to_owned(), names.map(str::to_owned).to_vec());
    assert_eq!(kinds, [listed(["Red", "Green"]), listed(["Green", "Red"])]);
    for (last, next) in [("Green".into(), "Green".into()), (Value::Int(1), Value::Int(0))] {
        let program = Program::new().constant("last()", last).constant("next(e)", next);
        let program = program.block(|asked| Some(vec![("x".to_owned(), asked.value("v")?)]));
        let shown = run(source, program, &["e=Green", ""]);
        assert_eq!((&shown[0].variables[..], &shown[1].steps[..]), (&names(["Green"])[..], &[1][..]));
        assert_eq!(shown[0].outputs, names(["Green"]));
    }
}

/// However it is written, a variant that is stored already is no change.
#[test]
fn what_is_stored_already_is_stable() {
    let source = "grafcet A { max_evolutions 2; input e: Colour in {Red, Green}; input a: bool; var v: Colour in {Green, Red} = Colour::Green;
           initial step S1; step S2; S1 -[a => v = e]-> S1; S1 -[!a => v = Colour::Red]-> S1; S1 -[false]-> S2 -[true]-> S1; }";
    let chart = Chart::parse(source).unwrap_or_else(|refused| panic!("{refused}"));
    let mut run = Simulation::new(&chart).expect("understood");
    for (a, e, evolutions) in [(true, "Green", 1), (false, "Green", 2), (true, "Red", 1), (false, "Red", 1)] {
        let cycle = run.cycle(0, &[("a", a.into()), ("e", e.into())]).expect("understood");
        assert_eq!((cycle.evolutions.len(), cycle.is_stable), (evolutions, true), "{a} {e}");
    }
    let outside = run.cycle(0, &[("a", true.into()), ("e", "Blue".into())]);
    assert!(matches!(outside, Err(grafcet_sim::Error::Chart(interp::Error::Type(_)))), "{outside:?}");
}
