//! The example charts from their files do what the compiled ones were expected to do.

use grafcet_sim::{Chart, Simulation, Trace, Value, script};

fn replays(file: &str, name: &str, cycles: &str, expected: &str) {
    let chart = Chart::in_file(file, name).unwrap_or_else(|refused| panic!("{name}: {refused}"));
    let cycles = script(chart.names(), cycles).unwrap_or_else(|bad| panic!("{name}: {bad}"));
    let trace = Trace::play(&mut Simulation::new(&chart).expect("understood"), &cycles).expect("understood");
    assert_eq!(trace.cycles.len(), expected.lines().count(), "{name}");
    for (index, (cycle, line)) in trace.cycles.iter().zip(expected.lines()).enumerate() {
        let steps: Vec<&str> = cycle.steps.iter().map(|step| chart.names().steps[*step].name.as_str()).collect();
        let outputs = chart.names().outputs.iter().zip(&cycle.outputs).filter_map(|(output, value)| match value {
            Value::Bool(true) => Some(output.name.clone()),
            Value::Bool(false) | Value::Int(0) => None,
            value => Some(format!("{}={value}", output.name)),
        });
        let outputs: Vec<String> = outputs.collect();
        let parts: Vec<&str> = line.split(" | ").collect();
        let shown = if outputs.is_empty() { "-".to_owned() } else { outputs.join(" ") };
        assert_eq!(
            (format!("{index} {}", steps.join("+")), shown.as_str()),
            (parts[0].to_owned(), parts[2]),
            "{name}: {line}"
        );
    }
}

macro_rules! replays {
    ($($test:ident: $file:literal, $name:literal;)*) => {$(
        #[test]
        fn $test() {
            replays(
                include_str!(concat!("../../examples/charts/", $file, ".rs")),
                $name,
                include_str!(concat!("../../examples/charts/", $file, ".script")),
                include_str!(concat!("../../tests/examples/", $file, ".expected")),
            );
        }
    )*};
}

replays! {
    motor: "motor", "Motor";
    line24v: "line24v", "Line24V";
    branch_on_result: "branch_on_result", "Sorter";
    cell: "cell", "Cell";
    tickless: "tickless", "Crossing";
    stroke: "stroke", "Press";
    pick_and_place: "pick_and_place", "PickAndPlace";
}
