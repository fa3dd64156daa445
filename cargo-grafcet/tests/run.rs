//! `replay`, `coverage` and `prove`: what they write, and by which exit code.

mod common;

use std::fs;
use std::path::Path;

use common::{folder, tool};
use serde_json::Value;

const CHARTS: &str = "
grafcet! { sfc Motor { input on, hot: bool; output relay: bool; initial step Off; step On { relay; }
    Off -[on && !hot]-> On -[!on]-> Off;
    never relay && Off.X;
    home (Off); } }
grafcet! { sfc Hoist { input up, down: bool; output raise, lower: bool; initial step Wait; step Up { raise; } step Down { lower; }
    Wait -[up]-> Up -[!up]-> Wait; Wait -[down && !up]-> Down -[!down]-> Wait;
    always raise => !up; } }
";

fn parsed(line: &str) -> Value {
    serde_json::from_str(line).unwrap_or_else(|error| panic!("{line}: {error}"))
}

#[test]
fn what_is_proved() {
    let folder = folder(&[("charts.rs", CHARTS)]);
    let prove = |arguments: &[&str]| tool(folder.path(), &[&["prove", "charts.rs"], arguments].concat());
    let done = prove(&["--chart", "Motor"]);
    assert_eq!(done.code, Some(0), "{done:?}");
    assert_eq!(done.out, "Motor: proved: never relay && Off.X\nMotor: proved: home Off\n");
    let done = prove(&["--chart", "Hoist"]);
    assert_eq!(done.code, Some(1), "{done:?}");
    // Entered in the second cycle.
    assert!(done.out.starts_with("Hoist: broken in cycle 2: always raise => !up\n    cycle | "), "{}", done.out);
    let verdicts: Vec<Value> = prove(&["--json"]).out.lines().map(parsed).collect();
    let said: Vec<(&Value, &Value)> = verdicts.iter().map(|one| (&one["chart"], &one["verdict"])).collect();
    assert_eq!(said.len(), 3);
    assert_eq!(said[2], (&Value::from("Hoist"), &Value::from("broken")));
    assert_eq!(verdicts[2]["cycles"], 2);
    assert_eq!(prove(&["--aiger", "both.aag"]).code, Some(2));
    assert_eq!(prove(&["--chart", "Motor", "--aiger", "one.aag", "--btor2", "one.btor2"]).code, Some(0));
    assert!(fs::read_to_string(folder.path().join("one.aag")).is_ok_and(|text| text.starts_with("aag ")));
    assert!(fs::read_to_string(folder.path().join("one.btor2")).is_ok_and(|text| text.contains("sort bitvec 1")));
}

/// What proves nothing: a plant that never moves, an assumption that leaves out nothing, assumptions that leave nothing.
#[test]
fn what_says_nothing() {
    let charts = |waits: &str, claims: &str| {
        format!(
            "grafcet! {{ sfc Press {{ input start, top, bottom, on: bool; output lower, _lamp: bool; initial step Rest; step Down {{ lower; }} step Up;
             Rest -[start && top]-> Down -[bottom]-> Up -[top]-> Rest; {claims} }}
             plant Cylinder {{ input lower, _lamp: bool; output top, bottom, on: bool; initial step Top {{ top; on; }} step Bottom {{ bottom; on; }}
             Top -[{waits}]-> Bottom -[!lower]-> Top; }} }}"
        )
    };
    for (waits, claims, out) in [
        ("lower", "never top && bottom;", ""),
        ("_lamp", "never top && bottom;", "Press: stands still: plant Cylinder\n    it stays where it begins, "),
        (
            "lower",
            "assume never on; never bottom;",
            "Press: excludes everything: assume\n    with what is assumed no cycle ",
        ),
        (
            "lower",
            "assume often top && bottom; never top && bottom;",
            "Press: excludes everything: assume often top && bottom\n    it never ",
        ),
        ("lower", "assume top && bottom leads_to start; never top && bottom;", "Press: excludes nothing: "),
    ] {
        let folder = folder(&[("charts.rs", &charts(waits, claims))]);
        let done = tool(folder.path(), &["prove", "charts.rs"]);
        let (proved, rest) = done.out.split_once('\n').expect("a verdict");
        assert!(proved.starts_with("Press: proved: never "), "{claims}: {done:?}");
        assert!(rest.starts_with(out) && rest.is_empty() == out.is_empty(), "{waits}, {claims}: {done:?}");
    }
}

/// A property is said as it stands in the source, also where it begins or ends with a plant.
#[test]
fn what_is_said_of_plants() {
    let claims = ["never Rest.X && Ram::Low.X", "Ram::Low before Lower", "always Ram::_up => !lower || Rest.X"];
    let charts = format!(
        "grafcet! {{ sfc Press {{ input start, top: bool; output lower: bool; initial step Rest; step Lower {{ lower; }} Rest -[start && top]-> Lower -[!top]-> Rest; {}; }}
         plant Ram {{ input lower: bool; output top: bool; var _up: bool; initial step High {{ top; N _up; }} step Low; High -[lower]-> Low -[!lower]-> High; }} }}",
        claims.join("; ")
    );
    let folder = folder(&[("charts.rs", &charts)]);
    let done = tool(folder.path(), &["prove", "charts.rs"]);
    for claim in claims {
        assert!(done.out.lines().any(|line| line.ends_with(&format!(": {claim}"))), "{claim}: {done:?}");
    }
}

#[test]
fn what_is_covered() {
    let files =
        [("charts.rs", CHARTS), ("a.script", "-\non\n-\n"), ("b.script", "-\non hot\n"), ("bad.script", "-\nof\n")];
    let folder = folder(&files);
    let cover =
        |arguments: &[&str]| tool(folder.path(), &[&["coverage", "charts.rs", "--chart", "Motor"], arguments].concat());
    // The first script alone never sees `hot`.
    let done = cover(&["--script", "a.script", "--json"]);
    let covered = parsed(&done.out);
    assert_eq!(done.code, Some(1));
    assert_eq!([&covered["steps"]["covered"], &covered["transitions"]["all"]], [2, 2]);
    let missing: Vec<&str> = covered["missing"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    assert_eq!(missing.len(), 3, "{missing:?}");
    assert!(missing.contains(&"`hot` never decided as true in the condition of `Off → On`"), "{missing:?}");
    let both = ["--script", "a.script", "--script", "b.script"];
    let done = cover(&[&both[..], &["--json"]].concat());
    assert_eq!(parsed(&done.out)["missing"].as_array().map(Vec::len), Some(2), "{done:?}");
    let except =
        ["--except", "`on` never decided as false", "--except", "`on` never decided as true", "--lcov", "motor.info"];
    let done = cover(&[&both[..], &except].concat());
    assert_eq!(done.code, Some(0), "{done:?}");
    assert!(fs::read_to_string(folder.path().join("motor.info")).is_ok_and(|text| text.contains("SF:charts.rs")));
    let done = cover(&["--script", "bad.script"]);
    assert_eq!(done.code, Some(2));
    assert_eq!(done.err, "error: bad.script: line 2: `of` is no input of the chart with a value that it can have\n");
    // Something has to be covered by something, and of one chart.
    assert_eq!(cover(&[]).code, Some(2));
    assert_eq!(tool(folder.path(), &["coverage", "charts.rs", "--script", "a.script"]).code, Some(2));
}

#[test]
fn what_a_record_shows() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folder = folder(&[("charts.rs", CHARTS), ("empty.record", "")]);
    for (from, to) in
        [("tests/record/tests/cell_stopped.record", "cell.record"), ("examples/charts/cell.rs", "cell.rs")]
    {
        fs::copy(root.join(from), folder.path().join(to)).expect("a file of the project");
    }
    let replay = |arguments: &[&str]| tool(folder.path(), &[&["replay"], arguments].concat());
    let views = ["--html", "cell.html", "--vcd", "cell.vcd", "--svg", "cell.svg"];
    let done = replay(&[&["cell.record", "cell.rs", "--chart", "Cell"], &views[..]].concat());
    assert_eq!(done.code, Some(0), "{done:?}");
    for (file, part) in [("cell.html", "<svg"), ("cell.vcd", "$enddefinitions"), ("cell.svg", "<svg")] {
        assert!(fs::read_to_string(folder.path().join(file)).is_ok_and(|text| text.contains(part)), "{file}");
    }
    a_record_is_drawn(folder.path());
    a_record_for_programs(folder.path());
    let done = replay(&["cell.record", "charts.rs", "--chart", "Motor"]);
    assert_eq!((done.code, done.out.as_str()), (Some(1), ""));
    assert!(done.err.starts_with("error: cell.record: the record is of another chart or version"), "{}", done.err);
    let done = replay(&["empty.record", "charts.rs", "--chart", "Motor"]);
    assert_eq!(
        (done.code, done.err.as_str()),
        (Some(1), "error: empty.record: there is no record in these bytes, or nothing of it is whole\n")
    );
    // What a record covers counts as that of a script.
    let done = tool(folder.path(), &["coverage", "cell.rs", "--chart", "Cell", "--record", "cell.record"]);
    assert_eq!(done.code, Some(1), "{done:?}");
    assert!(done.out.starts_with("Cell: "), "{}", done.out);
}

/// One object a cycle: what the table shows, by names.
fn a_record_for_programs(folder: &Path) {
    let replay = |arguments: &[&str]| {
        tool(folder, &[&["replay", "cell.record", "cell.rs", "--chart", "Cell", "--json"], arguments].concat())
    };
    let done = replay(&[]);
    let cycles: Vec<Value> = done.out.lines().map(parsed).collect();
    assert_eq!((done.code, cycles.len()), (Some(0), 16), "{done:?}");
    for (number, cycle) in cycles.iter().enumerate() {
        assert_eq!(cycle["cycle"], number);
        assert!(cycle["gap"].is_null() && cycle["skipped"] == 0, "{cycle}");
    }
    let seventh = &cycles[7];
    assert_eq!(seventh["steps"], serde_json::json!(["Ready", "Auto", "Drilled", "Stamp"]));
    assert_eq!(seventh["happened"], serde_json::json!(["Drill → Drilled"]));
    assert_eq!([&seventh["inputs"]["drilled"], &seventh["inputs"]["estop"]], [true, false]);
    assert_eq!([&seventh["outputs"]["stamp"], &seventh["outputs"]["drill"]], [true, false]);
    assert_eq!(parsed(&replay(&["--at", "75ms"]).out), *seventh);
}

/// A drawing for each cycle in which the situation has changed, and the one of a moment.
fn a_record_is_drawn(folder: &Path) {
    let replay = |arguments: &[&str]| {
        tool(folder, &[&["replay", "cell.record", "cell.rs", "--chart", "Cell"], arguments].concat())
    };
    let files = |name: &str| -> Vec<String> {
        let entries = fs::read_dir(folder.join(name)).expect("a folder").flatten();
        let mut names: Vec<String> = entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    };
    let done = replay(&["--draw", "moments"]);
    assert_eq!((done.code, &done.out), (Some(0), &replay(&[]).out));
    // In the others the rows of the table show no other steps, and nothing that cleared.
    let drawn = [0, 2, 4, 6, 7, 9, 10, 11, 12, 13, 14].map(|cycle| format!("Cell-{cycle:02}.svg"));
    assert_eq!(files("moments"), drawn);
    let active = |name: &str| -> Vec<String> {
        let steps = ["--chart", "Cell", "--format", "svg", "--active", name];
        vec![tool(folder, &[&["draw", "cell.rs"], &steps[..]].concat()).out]
    };
    let file = |name: &str| vec![fs::read_to_string(folder.join(name)).expect("a drawing")];
    assert_eq!(file("moments/Cell-07.svg"), active("Ready,Auto,Drilled,Stamp"));
    assert_eq!(file("moments/Cell-14.svg"), active("Stopped"));
    let text = |name: &str| tool(folder, &["draw", "cell.rs", "--chart", "Cell", "--active", name]).out;
    // Between two cycles it is as it was after the first of them.
    for (moment, steps) in
        [("75ms", "Ready,Auto,Drilled,Stamp"), ("0.05s", "Ready,Auto,Close"), ("14", "Stopped"), ("0s", "Ready,Manual")]
    {
        assert_eq!(replay(&["--at", moment]).out, text(steps), "{moment}");
    }
    assert_eq!(replay(&["--at", "75ms", "--draw", "one"]).code, Some(0));
    assert_eq!(files("one"), ["Cell-07.svg"]);
    for (moment, said) in [
        ("151ms", "error: the record ends 150 ms after its first cycle\n"),
        ("16", "error: there is no cycle 16: the last one is 15\n"),
    ] {
        let done = replay(&["--at", moment]);
        assert_eq!((done.code, done.err.as_str()), (Some(2), said));
    }
    assert!(replay(&["--at", "noon"]).err.contains("`noon` is none of"));
}
