//! Four large charts of the folder of good ones, each with one fault put in: the rule that must find it, and the names that its
//! message must hold.

mod charts;

const CELL: &str = include_str!("good/machining_cell.rs");
const LINE: &str = include_str!("good/packaging_line.rs");
const PLANT: &str = include_str!("good/rotary_plant.rs");
const CARTONS: &str = include_str!("good/carton_line.rs");

/// One fault: what is replaced by what, which rule speaks, and what it has to name.
struct Fault {
    what: &'static str,
    chart: &'static str,
    replace: &'static [(&'static str, &'static str)],
    rule: &'static str,
    names: &'static [&'static str],
}

const FAULTS: &[Fault] = &[
    Fault {
        what: "an arc was forgotten, and the transition is a source",
        chart: CELL,
        replace: &[(
            "InTaken -[!at_stop && Robot::ToMill.X]-> InEmpty;",
            "() -[!at_stop && Robot::ToMill.X]-> InEmpty;",
        )],
        rule: "level_source_transition",
        names: &["!at_stop && Robot::ToMill.X"],
    },
    Fault {
        what: "nothing leads to a step",
        chart: CELL,
        replace: &[("Probe -[measured && !good]-> Scrap -[200ms/Scrap]-> Drop;", "Scrap -[200ms/Scrap]-> Drop;")],
        rule: "unreachable_step",
        names: &["Scrap"],
    },
    Fault {
        what: "parallel branches that come together one by one",
        chart: CELL,
        replace: &[("(Turned, Carried) -[true]-> Probe;", "Turned -[true]-> Probe; Carried -[true]-> Probe;")],
        rule: "unsafe_step",
        names: &["Probe"],
    },
    Fault {
        what: "the same inside a macro-step",
        chart: CELL,
        replace: &[(
            "(Spin, Wet) -[at_speed && wide]-> Rough;\n                (Spin, Wet) -[at_speed && !wide]-> Fine;",
            "Spin -[at_speed && wide]-> Rough; Spin -[at_speed && !wide]-> Fine; Wet -[at_speed]-> Fine;",
        )],
        rule: "unsafe_step",
        names: &["Fine"],
    },
    Fault {
        what: "one initial step too many",
        chart: CELL,
        replace: &[("            step OutWait {", "            initial step OutWait {")],
        rule: "unsafe_step",
        names: &["OutFree"],
    },
    Fault {
        what: "the variable of another step than was meant, which is never active then",
        chart: CELL,
        replace: &[("InOffer -[Robot::PickUp.X]-> InTaken", "InOffer -[Infeed::InStop.X]-> InTaken")],
        rule: "dead_transition",
        names: &["InOffer", "InStop"],
    },
    Fault {
        what: "a convergence waits for a step of another branch",
        chart: CELL,
        replace: &[("(Turned, Carried) -[true]-> Probe;", "(Turned, Aside) -[true]-> Probe;")],
        rule: "dead_transition",
        names: &["(Turned, Aside)"],
    },
    Fault {
        what: "a selection comes together like parallel branches",
        chart: CELL,
        replace: &[(
            "Take -[gripped]-> (Turn, Carry);",
            "Take -[gripped && good]-> Turn; Take -[gripped && !good]-> Carry;",
        )],
        rule: "dead_transition",
        names: &["(Turned, Carried)"],
    },
    Fault {
        what: "an arc was forgotten, and the transition is a source",
        chart: LINE,
        replace: &[("NoPallet -[pallet]-> Place", "() -[pallet]-> Place")],
        rule: "level_source_transition",
        names: &["pallet"],
    },
    Fault {
        what: "nothing leads to a step",
        chart: LINE,
        replace: &[("Scan -[scanned && !readable]-> Rejected -[", "Rejected -[")],
        rule: "unreachable_step",
        names: &["Rejected"],
    },
    Fault {
        what: "parallel branches that come together one by one",
        chart: LINE,
        replace: &[("(LeftDry, RightDry) -[true]-> Upright", "LeftDry -[true]-> Upright; RightDry -[true]-> Upright")],
        rule: "unsafe_step",
        names: &["Upright"],
    },
    Fault {
        what: "a parallel branch that is left by a jump",
        chart: LINE,
        replace: &[("Fold1 -[flap1]-> Folded1;", "Fold1 -[flap1]-> Folded1; Folded1 -[taped && !pressed]-> Take;")],
        rule: "unsafe_step",
        names: &["Fold2"],
    },
    Fault {
        what: "one initial step too many",
        chart: LINE,
        replace: &[("            step Warming {", "            initial step Warming {")],
        rule: "unsafe_step",
        names: &["Warming"],
    },
    Fault {
        what: "the variable of another step than was meant, which is never active then",
        chart: LINE,
        replace: &[("Layer -[Lifting::Shifted.X]-> Counted", "Layer -[Palletiser::Counted.X]-> Counted")],
        rule: "dead_transition",
        names: &["Layer", "Counted"],
    },
    Fault {
        what: "no way on",
        chart: LINE,
        replace: &[("Truck -[rising(quit) || 30s/Truck]-> NoPallet", "Truck")],
        rule: "deadlock",
        names: &["Truck"],
    },
    Fault {
        what: "steps of two partial grafcets that are never active together",
        chart: PLANT,
        replace: &[("D7 -[Table::T4.X]-> D1", "D7 -[Table::T4.X && Press::P12.X]-> D1")],
        rule: "never_true",
        names: &["Table::T4.X && Press::P12.X", "D7 → D1"],
    },
    Fault {
        what: "a step variable confused: what starts together is never apart like that",
        chart: PLANT,
        replace: &[("T4 -[Load::L1.X && Drill::D1.X", "T4 -[Load::L9.X && Drill::D1.X")],
        rule: "never_true",
        names: &["L9", "D1", "T4 → T1"],
    },
    Fault {
        what: "two partial grafcets that wait for each other",
        chart: CARTONS,
        replace: &[("A3 -[Robot::GripA.X]-> A4", "A3 -[Robot::LiftA.X]-> A4")],
        rule: "dead_transition",
        names: &["Robot::LiftA.X", "A3"],
    },
];

/// The messages of a rule about the chart in a piece of Rust.
fn messages(rust: &str, rule: &str) -> Vec<String> {
    let mark = format!("[grafcet::{rule}]");
    let code: String = charts::charts(rust).into_iter().map(|chart| charts::expand(chart).to_string()).collect();
    code.split('"').filter(|literal| literal.contains(&mark)).map(str::to_owned).collect()
}

#[test]
fn each_fault_is_found_by_its_rule_and_named() {
    let mut missed = Vec::new();
    for fault in FAULTS {
        let mut rust = fault.chart.to_owned();
        for (old, new) in fault.replace {
            assert_eq!(rust.matches(old).count(), 1, "{}: {old}", fault.what);
            rust = rust.replace(old, new);
        }
        assert!(messages(fault.chart, fault.rule).is_empty(), "the good chart has the fault already");
        let said = messages(&rust, fault.rule);
        let named = |message: &String| fault.names.iter().all(|name| message.contains(&format!("`{name}`")));
        if !said.iter().any(named) {
            missed.push(format!(
                "{} ({}): {} should name {:?}, says {said:?}",
                fault.what, fault.replace[0].1, fault.rule, fault.names
            ));
        }
    }
    assert!(missed.is_empty(), "\n{}", missed.join("\n"));
}

/// What only waits for steps after the fault is not reported beside it.
#[test]
fn one_cause_is_one_message() {
    let rust = CELL.replace("InOffer -[Robot::PickUp.X]-> InTaken", "InOffer -[Infeed::InStop.X]-> InTaken");
    assert_eq!(messages(&rust, "dead_transition").len(), 1);
}

/// The table waits for the drill, which waits for what never comes.
#[test]
fn what_waits_for_another_partial_grafcet_is_one_message() {
    let rust = PLANT.replace("D7 -[Table::T4.X]-> D1", "D7 -[Table::T4.X && Press::P12.X]-> D1");
    assert!(messages(&rust, "dead_transition").is_empty());
}

/// Steps of a sequence are never active together, whoever asks for them.
#[test]
fn branches_that_ask_for_different_steps_of_another_partial_grafcet_exclude_each_other() {
    let rust = CARTONS.replace("-[Carton::C7.X && !Carton::C6.X]-> Q1", "-[Carton::C7.X]-> Q1");
    let rust = rust.replace("step Drop { open; }", "step Drop { open; P0 packed = packed + 1; }");
    let rust = rust.replace("on rising(open_grip) packed = packed + 1;", "");
    assert_ne!(rust, CARTONS);
    for rule in ["unsafe_step", "write_race", "overlapping_branches"] {
        assert_eq!(messages(&rust, rule), [""; 0]);
    }
}

#[test]
fn an_initial_step_too_many_is_named() {
    let rust = CELL.replace("            step OutWait {", "            initial step OutWait {");
    let said = messages(&rust, "unsafe_step");
    assert!(said.iter().any(|message| message.contains("is `OutWait` an initial step too many?")), "{said:?}");
}
