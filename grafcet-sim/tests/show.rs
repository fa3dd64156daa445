//! What traces look like.

use std::collections::BTreeMap;

use grafcet_sim::{Chart, Gap, Simulation, Trace, chronogram, page, script, table, vcd};
use vcd::{Command, IdCode};

const SOURCE: &str = "sfc Tank {
    input start, full: bool;
    input level: i16;
    input mode: Mode in {Off, Auto};
    output valve: bool;
    output share: f32;
    var fills: u8 = 0;
    action note(level: i16);
    initial step Idle;
    step Fill { N valve; N share = 0.5; P1 fills = fills + 1; P1 note(level); }
    Idle -[start && mode == Mode::Auto]-> Fill -[full && 2s/Fill || level > 100]-> Idle;
}";

const SCRIPT: &str = "\
# power-up
@0 -
@500 start mode=Auto
@500 level=-3
@1000 level=50
@1500 level=50
@2500 full level=99
@3000 -";

fn trace() -> (Chart, Trace) {
    let chart = Chart::parse(SOURCE).unwrap_or_else(|refused| panic!("{refused}"));
    let cycles = script(chart.names(), SCRIPT).expect("a script");
    let trace = Trace::play(&mut Simulation::new(&chart).expect("understood"), &cycles).expect("understood");
    (chart, trace)
}

#[test]
fn a_table_has_what_changed() {
    let (_, mut trace) = trace();
    let rows = "\
cycle  time    inputs                  steps  outputs                    what happened
0      0 s     mode=Off                Idle
1      500 ms  start mode=Auto         Fill   valve share=0.5 · fills=1  Idle → Fill
                                                                         first note(0)
2      500 ms  level=-3 mode=Off       Fill   valve share=0.5 · fills=1
3      1 s     level=50 mode=Off       Fill   valve share=0.5 · fills=1
… one cycle more
5      2.5 s   full level=99 mode=Off  Idle   fills=1                    Fill → Idle
6      3 s     mode=Off                Idle   fills=1
";
    assert_eq!(table(&trace), rows);
    trace.warnings.push("another version".to_owned());
    trace.cycles[3].gap = Some(Gap { reason: "two frames were lost".to_owned(), cycles: Some(7) });
    let with_gap = table(&trace);
    assert!(
        with_gap.starts_with("! another version\n") && with_gap.contains("~~~ gap: 7 cycles, two frames were lost"),
        "{with_gap}"
    );
}

/// What a viewer shows of each line at its times, read back from the file.
fn read(trace: &Trace) -> (u64, BTreeMap<String, Vec<(u64, String)>>) {
    let mut file = Vec::new();
    vcd(trace, &mut file).expect("written");
    let mut parser = vcd::Parser::new(&file[..]);
    let header = parser.parse_header().expect("a header");
    let (size, unit) = header.timescale.expect("a timescale");
    let nanos = u64::from(size) * (1_000_000_000 / unit.divisor());
    let mut names: BTreeMap<IdCode, String> = BTreeMap::new();
    let top =
        header.items.iter().find_map(|item| if let vcd::ScopeItem::Scope(scope) = item { Some(scope) } else { None });
    for item in &top.expect("a scope of the chart").items {
        let vcd::ScopeItem::Scope(scope) = item else { continue };
        for item in &scope.items {
            if let vcd::ScopeItem::Var(var) = item {
                names.insert(var.code, format!("{}.{}", scope.identifier, var.reference));
            }
        }
    }
    let (mut now, mut shown) = (0, BTreeMap::<String, Vec<(u64, String)>>::new());
    for command in parser {
        let (id, text) = match command.expect("a command") {
            Command::Timestamp(at) => {
                assert!(at >= now, "times do not go back");
                now = at;
                continue;
            }
            Command::ChangeScalar(id, value) => (id, value.to_string()),
            Command::ChangeVector(id, value) => (id, value.to_string()),
            Command::ChangeReal(id, value) => (id, value.to_string()),
            Command::ChangeString(id, value) => (id, value),
            other => panic!("{other:?}"),
        };
        shown.entry(names[&id].clone()).or_default().push((now, text));
    }
    (nanos, shown)
}

#[test]
fn a_waveform_is_read_back() {
    let (_, trace) = trace();
    let (nanos, shown) = read(&trace);
    assert_eq!(nanos, 1_000_000, "the clock counts milliseconds");
    let line = |name: &str| -> Vec<(u64, &str)> { shown[name].iter().map(|(at, text)| (*at, text.as_str())).collect() };
    assert_eq!(line("steps.Fill"), [(0, "0"), (500, "1"), (2500, "0")]);
    assert_eq!(line("inputs.full"), [(0, "0"), (2500, "1"), (3000, "0")]);
    assert_eq!(line("inputs.mode"), [(0, "Off"), (500, "Auto"), (500, "Off")]);
    assert_eq!(line("inputs.level")[1], (500, "1111111111111101"), "-3 in sixteen bits");
    assert_eq!(line("outputs.share"), [(0, "0"), (500, "0.5"), (2500, "0")]);
    assert_eq!(line("variables.fills").last(), Some(&(500, "00000001")));
    assert_eq!(line("transitions.t0_Idle__Fill"), [(500, "1")]);
    assert_eq!(line("transitions.t1_Fill__Idle"), [(2500, "1")]);
}

#[test]
fn what_is_in_a_gap_is_unknown() {
    let (_, mut trace) = trace();
    trace.cycles[4].gap = Some(Gap { reason: "a reset".to_owned(), cycles: None });
    let (_, shown) = read(&trace);
    let fill: Vec<(u64, &str)> = shown["steps.Fill"].iter().map(|(at, text)| (*at, text.as_str())).collect();
    assert_eq!(fill, [(0, "0"), (500, "1"), (1001, "x"), (1500, "1"), (2500, "0")]);
}

#[test]
fn where_the_clock_stands_still_cycles_are_counted() {
    let chart =
        Chart::parse("sfc C { input a: bool; initial step A; step B; A -[a]-> B -[!a]-> A; }").expect("a chart");
    let cycles = script(chart.names(), "-\na\na\n-").expect("a script");
    let trace = Trace::play(&mut Simulation::new(&chart).expect("understood"), &cycles).expect("understood");
    let (nanos, shown) = read(&trace);
    assert_eq!(
        (nanos, &shown["steps.B"][..]),
        (1, &[(0, "0".to_owned()), (1, "1".to_owned()), (3, "0".to_owned())][..])
    );
    assert!(table(&trace).starts_with("cycle  inputs  steps"), "no column of times");
    assert!(chronogram(&trace).contains(">cycle</text>"));
}

#[test]
fn a_chronogram_is_well_formed() {
    let (_, mut trace) = trace();
    trace.cycles[4].gap = Some(Gap { reason: "a < b".to_owned(), cycles: None });
    let svg = chronogram(&trace);
    let mut open = Vec::new();
    for part in svg.split('<').skip(1) {
        let tag = part.split('>').next().unwrap_or_default();
        let name = tag.trim_start_matches('/').split([' ', '/']).next().unwrap_or_default().to_owned();
        if tag.starts_with('/') {
            assert_eq!(open.pop(), Some(name), "{tag}");
        } else if !tag.ends_with('/') {
            open.push(name);
        }
    }
    assert!(open.is_empty(), "{open:?}");
    for text in [">Fill<", ">level<", ">2 s<", "a &lt; b", ">gap<"] {
        assert!(svg.contains(text), "{text}");
    }
}

#[test]
fn a_page_needs_nothing_else() {
    let (chart, mut trace) = trace();
    trace.warnings.push("</script><b>not the same chart".to_owned());
    trace.names.inputs[0].name = "</script>".to_owned();
    let page = page(&chart, &trace);
    for outside in ["http://", "https://", " src=", "<link", "@import", "url("] {
        let allowed = "xmlns=\"http://www.w3.org/2000/svg\"";
        assert!(!page.replace(allowed, "").contains(outside), "{outside}");
    }
    assert!(!page.contains("{{"), "every place is filled");
    assert_eq!(page.matches("</script>").count(), 2, "no text ends a script");
    assert!(page.contains("&lt;/script&gt;&lt;b&gt;not the same chart"));
    assert_eq!(page.matches("data-steps=").count(), 2);
    assert_eq!(page.matches("data-transition=").count(), 2);
    let data = page.split("id=\"data\">").nth(1).and_then(|rest| rest.split("</script>").next()).expect("data");
    let data: serde_json::Value = serde_json::from_str(data).expect("JSON");
    assert_eq!(data["cycles"].as_array().map(Vec::len), Some(7));
    assert_eq!(data["inputs"][0], "</script>");
    assert_eq!(data["cycles"][1]["evolutions"][0]["cleared"], serde_json::json!([0]));
    assert_eq!(
        data["cycles"][1]["did"],
        serde_json::json!(["note(0), first call", "Fill: fills = fills + 1", "Fill: share = 0.5"])
    );
    let waits = data["cycles"][3]["waits"][0].as_str().expect("a text");
    assert_eq!(
        waits,
        "`Fill → Idle` waits for (`full` (false); 1.5 s of `2s/Fill` still to go) or `level > 100` (level = 50)"
    );
}
