//! PLCopen XML. The schema says nothing of its licence and so is not kept here; these are its rules that matter, and what it does not say: who is connected
//! with whom, and where.

mod common;

use std::collections::{BTreeMap, BTreeSet};

use common::model;
use grafcet_exchange::plcopen::{Options, plcopen};
use roxmltree::{Document, Node};

/// Branches that join again, parallel branches, jumps back, a condition, a value, an edge, a time.
const CHART: &str = "sfc Cell {
    input start, part, done: bool;
    output clamp, drill, lamp: bool; output speed: u8;
    initial step Wait;
    /// Until the part is <held>.
    step Close { clamp; }
    step Drill { S drill; speed = 3; } step Count { L 2s clamp; } step Both;
    step Reject { lamp if part; } step Out;
    Wait -[start && part]-> Close;
    Wait -[start]-> Reject;
    Close -[rising(done)]-> (Drill, Count);
    (Drill, Count) -[done && 5s/Drill]-> Both -[done]-> Out;
    Reject -[!part]-> Out -[!start && !part]-> Wait;
}";

fn elements<'d>(document: &'d Document<'_>, name: &str) -> Vec<Node<'d, 'd>> {
    document.descendants().filter(|node| node.has_tag_name(name)).collect()
}

/// The names of children, each once, in their order.
fn kinds<'d>(node: Node<'d, '_>) -> Vec<&'d str> {
    let mut kinds: Vec<&str> = node.children().filter(Node::is_element).map(|child| child.tag_name().name()).collect();
    kinds.dedup();
    kinds
}

#[test]
fn the_file_is_one_of_the_schema() {
    let done = plcopen(&model(CHART), Options::default()).expect("a translation");
    let document = Document::parse(&done.text).expect("XML");
    let root = document.root_element();
    assert_eq!(root.tag_name().namespace(), Some("http://www.plcopen.org/xml/tc6_0201"));
    assert_eq!(kinds(root), ["fileHeader", "contentHeader", "types", "instances"]);
    for name in ["companyName", "productName", "productVersion", "creationDateTime"] {
        assert!(elements(&document, "fileHeader")[0].attribute(name).is_some(), "{name}");
    }
    let pou = elements(&document, "pou")[0];
    assert_eq!((pou.attribute("name"), pou.attribute("pouType")), (Some("Cell"), Some("program")));
    assert_eq!(kinds(pou), ["interface", "actions", "body"]);
    assert_eq!(kinds(elements(&document, "interface")[0]), ["inputVars", "outputVars", "localVars"]);
    // What comes after what.
    let order = [
        "position",
        "connectionPointIn",
        "connectionPointOut",
        "connectionPointOutAction",
        "action",
        "condition",
        "documentation",
    ];
    let sfc = elements(&document, "SFC")[0];
    let known = [
        "step",
        "transition",
        "selectionDivergence",
        "selectionConvergence",
        "simultaneousDivergence",
        "simultaneousConvergence",
        "jumpStep",
        "actionBlock",
    ];
    for element in sfc.children().filter(Node::is_element) {
        assert!(known.contains(&element.tag_name().name()), "{element:?}");
        let ranks: Vec<usize> = kinds(element)
            .iter()
            .map(|kind| order.iter().position(|other| other == kind).expect("a known child"))
            .collect();
        assert!(ranks.is_sorted() && ranks[0] == 0, "{element:?}: {:?}", kinds(element));
        for point in element
            .children()
            .filter(|child| child.has_tag_name("connectionPointOut") || child.has_tag_name("connectionPointOutAction"))
        {
            let named = matches!(element.tag_name().name(), "step" | "selectionDivergence" | "simultaneousDivergence");
            assert_eq!(point.attribute("formalParameter").is_some(), named, "{element:?}");
        }
    }
    let documented = elements(&document, "documentation");
    assert!(
        documented.iter().any(|node| node.descendants().any(|inner| inner.text() == Some("Until the part is <held>.")))
    );
}

fn number(node: Node<'_, '_>, name: &str) -> i64 {
    node.attribute(name).and_then(|text| text.parse().ok()).unwrap_or_else(|| panic!("{name} of {node:?}"))
}

fn child<'d>(node: Node<'d, 'd>, name: &str) -> Node<'d, 'd> {
    node.children().find(|child| child.has_tag_name(name)).unwrap_or_else(|| panic!("{name} of {node:?}"))
}

fn at(node: Node<'_, '_>) -> (i64, i64) {
    (number(node, "x"), number(node, "y"))
}

/// Each line begins at a pin of what it belongs to, ends at one of what it is connected with, and is made of horizontal and vertical pieces.
#[test]
fn lines_lead_from_pin_to_pin() {
    let done = plcopen(&model(CHART), Options::default()).expect("a translation");
    let document = Document::parse(&done.text).expect("XML");
    let sfc = elements(&document, "SFC")[0];
    let mut pins = BTreeMap::<i64, BTreeSet<(i64, i64)>>::new();
    let mut ids = BTreeSet::new();
    for node in sfc.descendants().filter(|node| node.attribute("localId").is_some()) {
        assert!(ids.insert(number(node, "localId")), "two of one number: {node:?}");
        let Some(corner) = node.children().find(|child| child.has_tag_name("position")).map(at) else { continue };
        for point in node.children().filter(|child| child.tag_name().name().starts_with("connectionPointOut")) {
            let pin = at(child(point, "relPosition"));
            pins.entry(number(node, "localId")).or_default().insert((corner.0 + pin.0, corner.1 + pin.1));
        }
    }
    let mut lines = 0;
    for element in sfc.children().filter(Node::is_element) {
        let corner = at(child(element, "position"));
        for point in element.children().filter(|child| child.has_tag_name("connectionPointIn")) {
            let pin = at(child(point, "relPosition"));
            let way: Vec<(i64, i64)> = child(point, "connection").children().filter(Node::is_element).map(at).collect();
            assert_eq!(way[0], (corner.0 + pin.0, corner.1 + pin.1), "{element:?}");
            let from = number(child(point, "connection"), "refLocalId");
            assert!(pins[&from].contains(way.last().expect("an end")), "{element:?}: {way:?}, {:?}", pins[&from]);
            assert!(way.windows(2).all(|pair| pair[0].0 == pair[1].0 || pair[0].1 == pair[1].1), "{way:?}");
            lines += 1;
        }
    }
    // Ten into transitions and what stands above them, nine into steps and what stands above these, a jump, four action blocks.
    assert_eq!(lines, 24);
}

/// Who is connected with whom, without what lies between.
#[test]
fn the_network_is_that_of_the_chart() {
    let done = plcopen(&model(CHART), Options::default()).expect("a translation");
    let document = Document::parse(&done.text).expect("XML");
    let count = |name: &str| elements(&document, name).len();
    assert_eq!(
        [
            "step",
            "transition",
            "selectionDivergence",
            "selectionConvergence",
            "simultaneousDivergence",
            "simultaneousConvergence",
            "jumpStep"
        ]
        .map(count),
        [7, 7, 1, 1, 1, 1, 1]
    );
    let jump = elements(&document, "jumpStep")[0];
    assert_eq!(jump.attribute("targetName"), Some("Wait"));
    let initial: Vec<_> =
        elements(&document, "step").into_iter().filter(|step| step.attribute("initialStep") == Some("true")).collect();
    assert_eq!(initial.len(), 1);
    assert_eq!(initial[0].attribute("name"), Some("Wait"));
    let priorities: Vec<_> = elements(&document, "transition")
        .iter()
        .filter_map(|node| node.attribute("priority").map(str::to_owned))
        .collect();
    assert_eq!(priorities, ["1", "2"]);
}

/// Two steps, and all steps and transitions, stand apart from each other; a step stands above those it leads to, unless it jumps.
#[test]
fn nothing_stands_upon_another() {
    let done = plcopen(&model(CHART), Options::default()).expect("a translation");
    let document = Document::parse(&done.text).expect("XML");
    let place = |node: &Node<'_, '_>| {
        let (x, y) = at(node.children().find(|child| child.has_tag_name("position")).expect("a position"));
        (x, y, x + number(*node, "width"), y + number(*node, "height"))
    };
    let names = ["step", "transition", "jumpStep", "actionBlock"];
    let all: Vec<_> = names.iter().flat_map(|name| elements(&document, name)).collect();
    for (index, one) in all.iter().enumerate() {
        for other in &all[..index] {
            let (a, b) = (place(one), place(other));
            let apart = a.2 < b.0 || b.2 < a.0 || a.3 < b.1 || b.3 < a.1;
            assert!(apart, "{one:?} {a:?}, {other:?} {b:?}");
        }
    }
}

/// What is done in each scan stands at a step beside the chart, which leads nowhere.
#[test]
fn a_step_for_each_scan() {
    let done = plcopen(&model(CHART), Options { scan_step: true, ..Options::default() }).expect("a translation");
    let document = Document::parse(&done.text).expect("XML");
    let initial = elements(&document, "step").into_iter().filter(|step| step.attribute("initialStep") == Some("true"));
    let names: Vec<_> = initial.filter_map(|step| step.attribute("name")).collect();
    assert_eq!(names, ["Wait", "Scan"]);
    let actions: Vec<_> = elements(&document, "action")
        .into_iter()
        .filter(|action| {
            action.children().any(|child| child.has_tag_name("reference") && child.attribute("name") == Some("Always"))
        })
        .collect();
    assert_eq!((actions.len(), actions[0].attribute("qualifier")), (1, Some("N")));
    let imported = grafcet_exchange::import::import(&done.text, "there").expect("a chart").rust;
    let plain = grafcet_exchange::import::import(
        &plcopen(&model(CHART), Options::default()).expect("a translation").text,
        "there",
    );
    assert_eq!(imported, plain.expect("a chart").rust);
}

/// A chart that is not drawn step by step has places all the same.
#[test]
fn a_large_chart() {
    let mut chart = String::from("sfc Large { input a: bool; initial step S0;");
    for number in 1..200 {
        chart.extend([format!("step S{number}; S{} -[a]-> S{number};", number - 1)]);
    }
    chart.push_str("S199 -[!a]-> S0; }");
    let done = plcopen(&model(&chart), Options::default()).expect("a translation");
    let document = Document::parse(&done.text).expect("XML");
    assert_eq!((elements(&document, "step").len(), elements(&document, "jumpStep").len()), (200, 1));
}
