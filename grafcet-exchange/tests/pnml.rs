//! PNML, read back by a reader of XML.

mod common;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

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

/// What a net would show otherwise: branches that clear together, a step that is activated once more, an `any` beside parallel branches.
#[test]
fn what_a_net_does_otherwise() {
    let refused = |chart: &str| {
        let refused = pnml(&model(chart)).err().into_iter().flatten();
        refused.map(|refused| refused.message).collect::<Vec<String>>()
    };
    let branches = |conditions: [&str; 2]| {
        let [one, other] = conditions;
        format!(
            "grafcet C {{ input a, b: bool; initial step A; step B; step C; A -[{one}]-> B; A -[{other}]-> C; B -[!a]-> A; C -[!b]-> A; }}"
        )
    };
    let together = refused(&branches(["a", "b"]));
    assert_eq!(
        together,
        [
            "two branches of `A` may clear together, and a Petri net gives the token to one of them: let their conditions exclude each other, or write `else`"
        ]
    );
    for apart in [["a", "b && !a"], ["a", "else"]] {
        assert_eq!(refused(&branches(apart)), [""; 0]);
    }
    assert_eq!(refused(&branches(["a", "b"]).replace("grafcet C", "sfc C")), [""; 0]);
    let source = "grafcet C { input a, b: bool; initial step A; step B; () -[rising(a)]-> A -[b]-> B -[!b]-> (); }";
    let twice = "may be activated while it is active, which changes nothing in the chart and makes a second token in a Petri net";
    assert_eq!(refused(source), [format!("`A` {twice}"), format!("`B` {twice}")]);
    let any = |also: &str| {
        format!(
            "sfc C {{ input a, b, stop: bool; initial step A; step B; step C; step D1; step Halt; A -[a]-> (B, C); B -[b]-> D1; (D1, C) -[!a]-> A;
             any except ({also}) -[stop]-> Halt -[!stop]-> A; }}"
        )
    };
    assert_eq!(
        refused(&any("A")),
        [
            "`any` leaves all that is active at once, such as `B` and `C`, and a transition of a Petri net takes the same tokens each time"
        ]
    );
    assert_eq!(refused(&any("B, C, D1")), [""; 0]);
    // What is shared goes to one of both.
    let shared =
        "grafcet C { input a, b: bool; initial step Free; initial step A; initial step B; step Left; step Right;
        (Free, A) -[a]-> Left -[!a]-> (Free, A); (Free, B) -[b && !(A.X && a)]-> Right -[!b]-> (Free, B); }";
    assert_eq!(refused(shared), [""; 0]);
}

/// What the grammar of nets of places and transitions (`ptnet.pntd` and the core model it builds on) asks of an element: its attributes, and its children
/// with how many of each there may be. The grammar is in RELAX NG, and no validator of that for Rust is known to be well kept.
const GRAMMAR: [Element; 9] = [
    ("pnml", &[], &[("net", 1, MANY)]),
    ("net", &["id", "type"], &[("name", 0, 1), ("page", 1, MANY)]),
    ("page", &["id"], &[("name", 0, 1), ("place", 0, MANY), ("transition", 0, MANY), ("arc", 0, MANY)]),
    ("place", &["id"], &[("name", 0, 1), ("initialMarking", 0, 1)]),
    ("transition", &["id"], &[("name", 0, 1)]),
    ("arc", &["id", "source", "target"], &[]),
    ("name", &[], &[("text", 1, 1)]),
    ("initialMarking", &[], &[("text", 1, 1)]),
    ("text", &[], &[]),
];
/// Its name, its attributes, and its children with the least and the highest number of each.
type Element = (&'static str, &'static [&'static str], &'static [(&'static str, usize, usize)]);
const MANY: usize = usize::MAX;

/// What a net breaks of that.
fn broken(document: &Document<'_>) -> Vec<String> {
    let mut broken = Vec::new();
    let mut ids = BTreeMap::new();
    let root = document.root_element();
    if root.tag_name().namespace() != Some("http://www.pnml.org/version-2009/grammar/pnml")
        || root.tag_name().name() != "pnml"
    {
        broken.push("another root".to_owned());
    }
    for node in root.descendants().filter(Node::is_element) {
        let name = node.tag_name().name();
        let Some((_, attributes, children)) = GRAMMAR.iter().find(|(known, ..)| *known == name) else {
            broken.push(format!("there is no `{name}`"));
            continue;
        };
        let mut found: Vec<&str> = node.attributes().map(|attribute| attribute.name()).collect();
        found.sort_unstable();
        if found != *attributes {
            broken.push(format!("`{name}` has {found:?}"));
        }
        let count = |child: &str| node.children().filter(|other| other.tag_name().name() == child).count();
        for (child, least, most) in *children {
            if !(*least..=*most).contains(&count(child)) {
                broken.push(format!("`{name}` has {} `{child}`", count(child)));
            }
        }
        for other in node.children().filter(Node::is_element) {
            if children.iter().all(|(child, ..)| *child != other.tag_name().name()) {
                broken.push(format!("`{}` stands in `{name}`", other.tag_name().name()));
            }
        }
        if let Some(id) = node.attribute("id") {
            let is_name = id.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
                && id.chars().all(|c| c.is_ascii_alphanumeric() || "_-.".contains(c));
            if !is_name || ids.insert(id, name).is_some() {
                broken.push(format!("id `{id}`"));
            }
        }
        if name == "initialMarking" && text_of(node).parse::<u32>().is_err() {
            broken.push(format!("a marking of `{}`", text_of(node)));
        }
    }
    for arc in
        root.descendants().filter(|node| node.has_tag_name(("http://www.pnml.org/version-2009/grammar/pnml", "arc")))
    {
        let ends = ["source", "target"].map(|end| arc.attribute(end).and_then(|id| ids.get(id)).copied());
        if ends != [Some("place"), Some("transition")] && ends != [Some("transition"), Some("place")] {
            broken.push(format!("an arc from {:?} to {:?}", ends[0], ends[1]));
        }
    }
    broken
}

fn text_of(node: Node<'_, '_>) -> String {
    node.descendants().filter_map(|one| one.text()).collect::<String>().trim().to_owned()
}

/// The charts of the examples, and those that people draw.
#[test]
fn nets_keep_to_the_grammar() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut nets = 0;
    for folder in ["examples/charts", "tests/good"] {
        for entry in fs::read_dir(root.join(folder)).expect("a folder of the project").flatten() {
            let Ok(text) = fs::read_to_string(entry.path()) else { continue };
            let words: Vec<&str> = text.split_whitespace().collect();
            let headers = words.windows(3).filter(|words| ["sfc", "grafcet"].contains(&words[0]) && words[2] == "{");
            for name in headers.map(|words| words[1]) {
                let Ok(chart) = grafcet_sim::Chart::in_file(&text, name) else { continue };
                let Ok(written) = pnml(chart.model()) else { continue };
                let document = Document::parse(&written).expect("XML");
                assert_eq!(broken(&document), Vec::<String>::new(), "{name}\n{written}");
                nets += 1;
            }
        }
    }
    assert!(nets > 40, "{nets}");
}

#[test]
fn what_the_grammar_does_not_allow_is_found() {
    let chart = "sfc Cell { input go: bool; initial step A; step B; A -[go]-> B -[!go]-> A; }";
    let written = pnml(&model(chart)).expect("a net");
    let faults = [
        (" type=\"", " kind=\""),
        ("<initialMarking><text>1<", "<initialMarking><text>one<"),
        ("id=\"t1\"", "id=\"s1\""),
        ("target=\"t1\"", "target=\"s2\""),
        ("<name><text>A</text></name>", "<name>A</name>"),
        ("id=\"page\"", "id=\"1\""),
        ("<page id=\"page\">", "<page id=\"page\"><marking/>"),
    ];
    for (from, to) in faults {
        let other = written.replacen(from, to, 1);
        assert_ne!(other, written, "{from}");
        assert!(!broken(&Document::parse(&other).expect("XML")).is_empty(), "{to}");
    }
}
