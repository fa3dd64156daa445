//! PNML, read back by a reader of XML.

mod common;

use std::collections::{BTreeMap, BTreeSet};

use common::model;
use grafcet_exchange::pnml::pnml;
use roxmltree::{Document, Node};

/// The text of a child of this name.
fn text(node: Node<'_, '_>, child: &str) -> Option<String> {
    let child =
        node.children().find(|one| one.has_tag_name(("http://www.pnml.org/version-2009/grammar/pnml", child)))?;
    child.children().find(Node::is_element)?.text().map(str::to_owned)
}

#[test]
fn a_chart_as_a_net() {
    let chart = "sfc Cell { input go, left, right: bool; input level: u8;
        initial step Wait; step Left; step Right; step Meet; step Rest;
        Wait -[go && level < 7]-> (Left, Right);
        Left -[left]-> Meet;
        (Meet, Right) -[both: left && right]-> Rest -[!go]-> Wait; }";
    let written = pnml(&model(chart)).expect("a net");
    let document = Document::parse(&written).expect("XML");
    let net = document.descendants().find(|node| node.has_attribute("type")).expect("a net");
    assert_eq!(net.attribute("type"), Some("http://www.pnml.org/version-2009/grammar/ptnet"));
    assert_eq!(text(net, "name").as_deref(), Some("Cell"));
    let mut names = BTreeMap::new();
    let (mut marked, mut arcs) = (Vec::new(), BTreeSet::new());
    for node in document.descendants().filter(Node::is_element) {
        let id = node.attribute("id").unwrap_or_default().to_owned();
        match node.tag_name().name() {
            "place" => {
                let name = text(node, "name").expect("a name");
                if let Some(tokens) = text(node, "initialMarking") {
                    marked.push((name.clone(), tokens));
                }
                assert!(names.insert(id, name).is_none());
            }
            "transition" => assert!(names.insert(id, text(node, "name").expect("a name")).is_none()),
            _ => {}
        }
    }
    for node in document.descendants().filter(|node| node.tag_name().name() == "arc") {
        let end = |name: &str| names[node.attribute(name).expect("an end")].clone();
        assert!(arcs.insert((end("source"), end("target"))), "an arc stands twice");
    }
    assert_eq!(marked, [("Wait".to_owned(), "1".to_owned())]);
    let go = "go && level < 7";
    let both = "both: left && right";
    let expected = [
        ("Wait", go),
        (go, "Left"),
        (go, "Right"),
        ("Left", "left"),
        ("left", "Meet"),
        ("Meet", both),
        ("Right", both),
        (both, "Rest"),
        ("Rest", "!go"),
        ("!go", "Wait"),
    ];
    let expected: BTreeSet<(String, String)> =
        expected.iter().map(|(a, b)| ((*a).to_owned(), (*b).to_owned())).collect();
    assert_eq!(arcs, expected);
}

#[test]
fn what_is_no_net() {
    let chart = "grafcet Plant { input stop, go: bool;
        partial Safety { initial step Ready; step Stopped { force Work {INIT}; } Ready -[stop]-> Stopped -[!stop]-> Ready; }
        partial Work { initial step Idle; step Busy; Idle -[go]-> Busy -[!go]-> Idle; } }";
    let refused = pnml(&model(chart)).expect_err("orders");
    assert_eq!(refused.len(), 1);
    assert!(refused[0].message.starts_with("a forcing order moves tokens"), "{refused:?}");
    // Partial grafcets alone are one net with several parts.
    assert!(pnml(&model(&chart.replace("force Work {INIT};", ""))).is_ok());
}
