//! PLCopen XML as IEC 61131-10 has it. Its schema may not be given away, so these are its rules for what is written: who is in whom, in which order, with
//! which attributes; and what no schema says: who is connected with whom, and where. What others write is read, too.

mod common;

use std::collections::{BTreeMap, BTreeSet};

use common::model;
use grafcet_exchange::import::import;
use grafcet_exchange::plcopen::{Edition, Options, plcopen};
use roxmltree::{Document, Node};

const NAMESPACE: &str = "www.iec.ch/public/TC65SC65BWG7TF10";
const TYPE: (&str, &str) = ("http://www.w3.org/2001/XMLSchema-instance", "type");

/// Branches that join again, parallel branches, three ways back (one out of a parallel branch), a function to be written, values, edges and times.
const CHART: &str = "sfc Cell {
    input start, part, done: bool; input load: u8;
    output clamp, drill, lamp: bool; output speed: u8;
    initial step Wait;
    /// Until the part is <held>.
    step Close { clamp; }
    step Drill { S drill; speed = 3; } step Count { L 2s clamp; } step Both;
    step Reject { lamp if part; } step Out;
    Wait -[start && part && ready(load)]-> Close;
    Wait -[start]-> Reject;
    Close -[rising(done)]-> (Drill, Count);
    (Drill, Count) -[done && 5s/Drill]-> Both -[done]-> Out;
    Both -[!done && part]-> (Drill, Count);
    Reject -[!part]-> Out -[!start && !part]-> Wait;
    Out -[start]-> Close;
}";

fn exported(chart: &str) -> String {
    let options = Options { edition: Edition::Iec61131Part10, ..Options::default() };
    plcopen(&model(chart), options).expect("a translation").text
}

/// An element by its name, where the schema has several by their type: attributes that it has to have, others that it may have, and its children in their
/// order. A star: any number of them.
type Rule = (&'static str, &'static str, &'static str, &'static str);

const RULES: [Rule; 44] = [
    ("Project", "schemaVersion", "", "FileHeader ContentHeader Types Instances"),
    ("FileHeader", "companyName productName productVersion", "", ""),
    ("ContentHeader", "name creationDateTime", "", "CoordinateInfo"),
    ("CoordinateInfo", "", "", "FbdScaling LdScaling SfcScaling"),
    ("FbdScaling", "x y", "", ""),
    ("LdScaling", "x y", "", ""),
    ("SfcScaling", "x y", "", ""),
    ("Types", "", "", "GlobalNamespace"),
    ("GlobalNamespace", "", "", "Function* FunctionBlock* Program"),
    ("Instances", "", "", ""),
    ("Program", "name", "", "Documentation? Parameters? Vars? MainBody Action*"),
    ("Function", "name", "", "ResultType Parameters? MainBody"),
    ("FunctionBlock", "name", "", "Parameters? MainBody"),
    ("Parameters", "", "", "InputVars? OutputVars?"),
    ("InputVars", "", "", "Variable*"),
    ("OutputVars", "", "", "Variable*"),
    ("Vars", "accessSpecifier", "", "Variable*"),
    ("Variable", "name", "orderWithinParamSet", "Documentation? Type InitialValue?"),
    ("Documentation:SimpleText", "", "", ""),
    ("Type", "", "", "TypeName"),
    ("ResultType", "", "", "TypeName"),
    ("TypeName", "", "", ""),
    ("InitialValue", "", "", "SimpleValue"),
    ("SimpleValue", "value", "", ""),
    ("MainBody", "", "", "BodyContent"),
    ("Action", "name", "", "Body"),
    ("Body", "", "", "BodyContent"),
    ("BodyContent:ST", "", "", "ST"),
    ("PredicateContent:ST", "", "", "ST"),
    ("ST", "", "", ""),
    (
        "SfcObject:Step",
        "name",
        "initialStep",
        "Documentation? RelPosition Size ConnectionPointIn? ConnectionPointOut ConnectionPointOutAction?",
    ),
    ("SfcObject:Transition", "", "", "RelPosition Size ConnectionPointIn ConnectionPointOut Condition"),
    ("SfcObject:SelectionDivergence", "", "", "RelPosition Size ConnectionPointIn ConnectionPointOut*"),
    ("SfcObject:SelectionConvergence", "", "", "RelPosition Size ConnectionPointIn* ConnectionPointOut"),
    ("SfcObject:SimultaneousDivergence", "", "", "RelPosition Size ConnectionPointIn ConnectionPointOut*"),
    ("SfcObject:SimultaneousConvergence", "", "", "RelPosition Size ConnectionPointIn* ConnectionPointOut"),
    ("CommonObject:ActionBlocks", "", "", "RelPosition Size ConnectionPointIn ActionBlock*"),
    ("ActionBlock", "", "", "RelPosition ActionQualifier ReferenceName? ComplexOperand?"),
    ("ActionQualifier", "qualifier", "duration", ""),
    ("ConnectionPointIn", "", "", "RelPosition Connection*"),
    ("Connection", "refConnectionPointOutId", "", "RelPosition*"),
    ("ConnectionPointOut", "connectionPointOutId", "priority", "RelPosition"),
    ("ConnectionPointOutAction", "connectionPointOutId", "", "RelPosition"),
    ("Condition", "", "", "TextualPredicate"),
];

/// What an element is, with its type.
fn named(node: Node<'_, '_>) -> String {
    let name = node.tag_name().name();
    node.attribute(TYPE).map_or_else(|| name.to_owned(), |ty| format!("{name}:{ty}"))
}

fn follows(element: Node<'_, '_>) -> Result<(), String> {
    let name = named(element);
    let wrong = |what: String| Err(format!("{name}: {what}"));
    if element.tag_name().namespace() != Some(NAMESPACE) {
        return wrong("of no namespace".to_owned());
    }
    if name == "BodyContent:SFC" {
        return Ok(());
    }
    let leaves = ["RelPosition", "Size"].contains(&&*name);
    let alone = ["ReferenceName", "ComplexOperand"].contains(&&*name);
    let rule: Rule = match RULES.iter().find(|rule| rule.0 == name) {
        Some(rule) => *rule,
        None if leaves => ("", "x y", "", ""),
        None if alone => ("", "", "", ""),
        None if name == "TextualPredicate" => ("", "", "", "PredicateContent"),
        None => return wrong("is not known".to_owned()),
    };
    let attributes: BTreeSet<&str> =
        element.attributes().filter(|one| one.namespace().is_none()).map(|one| one.name()).collect();
    let (needed, allowed): (Vec<&str>, Vec<&str>) =
        (rule.1.split_whitespace().collect(), rule.2.split_whitespace().collect());
    if !needed.iter().all(|one| attributes.contains(one))
        || !attributes.iter().all(|one| needed.contains(one) || allowed.contains(one))
    {
        return wrong(format!("{attributes:?}"));
    }
    let mut children = element.children().filter(Node::is_element).map(|child| child.tag_name().name()).peekable();
    for wanted in rule.3.split_whitespace() {
        let word = wanted.trim_end_matches(['*', '?']);
        let mut found = 0;
        while children.next_if(|child| *child == word).is_some() {
            found += 1;
        }
        if found == 0 && wanted == word || found > 1 && !wanted.ends_with('*') {
            return wrong(format!("{found} of {wanted}"));
        }
    }
    children.next().map_or(Ok(()), |child| wrong(format!("{child} has no place there")))
}

#[test]
fn the_file_is_one_of_the_schema() {
    let text = exported(CHART);
    let document = Document::parse(&text).expect("XML");
    let all = || document.descendants().filter(Node::is_element);
    for element in all() {
        follows(element).unwrap_or_else(|error| panic!("{error}"));
    }
    assert!(all().count() > 300);
    // Where several are of one name, the rules are those of one kind.
    let count = |name: &str| all().filter(|node| named(*node) == name).count();
    assert_eq!(
        [
            "Step",
            "Transition",
            "SelectionDivergence",
            "SelectionConvergence",
            "SimultaneousDivergence",
            "SimultaneousConvergence"
        ]
        .map(|kind| count(&format!("SfcObject:{kind}"))),
        [7, 9, 3, 4, 2, 1]
    );
    assert_eq!((count("Function"), count("Program"), count("CommonObject:ActionBlocks")), (1, 1, 4));
    // Inputs and outputs are counted together, variables are not.
    let program = all().find(|node| node.has_tag_name((NAMESPACE, "Program"))).expect("a program");
    let orders: Vec<&str> = program.descendants().filter_map(|node| node.attribute("orderWithinParamSet")).collect();
    assert_eq!(orders, ["1", "2", "3", "4", "5", "6", "7", "8"]);
    for node in all().filter(|node| node.has_tag_name((NAMESPACE, "Variable"))) {
        let is_param = node.parent().is_some_and(|list| list.tag_name().name() != "Vars");
        assert_eq!(node.attribute("orderWithinParamSet").is_some(), is_param, "{node:?}");
    }
    assert!(all().any(|node| node.text() == Some("Until the part is <held>.")));
    let qualifiers = ["P1", "N", "P0", "R", "S", "L", "D", "P", "DS", "DL", "SD", "SL"];
    for node in all().filter(|node| node.has_tag_name((NAMESPACE, "ActionQualifier"))) {
        assert!(node.attribute("qualifier").is_some_and(|one| qualifiers.contains(&one)), "{node:?}");
    }
    for node in all().filter(|node| node.has_tag_name((NAMESPACE, "ActionBlock"))) {
        assert_eq!(node.children().filter(Node::is_element).count(), 3, "a name or an operand: {node:?}");
    }
}

#[test]
fn what_breaks_a_rule_is_found() {
    let text = exported(CHART);
    let breaks = |text: &str| {
        let document = Document::parse(text).expect("XML");
        document.descendants().filter(Node::is_element).any(|element| follows(element).is_err())
    };
    assert!(!breaks(&text));
    for (from, to) in [
        (" schemaVersion=\"1.0\"", ""),
        ("ConnectionPointOutAction", "ConnectionPointAction"),
        (" accessSpecifier=\"private\"", ""),
        ("<Size ", "<RelPosition "),
        ("xsi:type=\"Step\"", "xsi:type=\"MacroStep\""),
        (" duration=", " time="),
        ("TC65SC65BWG7TF10", "TC65"),
    ] {
        assert!(text.contains(from) && breaks(&text.replace(from, to)), "{from}");
    }
}

fn at(node: Node<'_, '_>) -> (i64, i64) {
    let number = |name: &str| node.attribute(name).and_then(|text| text.parse().ok());
    (number("x").expect("x"), number("y").expect("y"))
}

fn child<'d>(node: Node<'d, 'd>, name: &str) -> Node<'d, 'd> {
    node.children().find(|child| child.tag_name().name() == name).unwrap_or_else(|| panic!("{name} of {node:?}"))
}

/// Each line begins at a pin, leads to another one, and is made of horizontal and vertical pieces; it runs through no step and no action block. Each pin has a number of its own.
#[test]
fn lines_lead_from_pin_to_pin() {
    let text = exported(CHART);
    let document = Document::parse(&text).expect("XML");
    let objects: Vec<Node<'_, '_>> = document
        .descendants()
        .filter(|node| node.tag_name().name().ends_with("cObject") || node.tag_name().name() == "CommonObject")
        .collect();
    let corner = |object: Node<'_, '_>| {
        at(object.children().find(|child| child.tag_name().name() == "RelPosition").expect("a place"))
    };
    let mut pins = BTreeMap::<&str, (i64, i64)>::new();
    for object in &objects {
        for pin in object.children().filter(|child| child.attribute("connectionPointOutId").is_some()) {
            let (from, pin_at) = (corner(*object), at(child(pin, "RelPosition")));
            let twice = pins.insert(
                pin.attribute("connectionPointOutId").expect("a number"),
                (from.0 + pin_at.0, from.1 + pin_at.1),
            );
            assert!(twice.is_none(), "two pins of one number: {pin:?}");
        }
    }
    let solid: Vec<((i64, i64), (i64, i64))> = objects
        .iter()
        .filter(|object| ["SfcObject:Step", "CommonObject:ActionBlocks"].contains(&&*named(**object)))
        .map(|object| {
            let (from, size) = (corner(*object), at(child(*object, "Size")));
            (from, (from.0 + size.0, from.1 + size.1))
        })
        .collect();
    let mut lines = 0;
    for object in &objects {
        for pin in object.children().filter(|child| child.tag_name().name() == "ConnectionPointIn") {
            let (from, pin_at) = (corner(*object), at(child(pin, "RelPosition")));
            let end = (from.0 + pin_at.0, from.1 + pin_at.1);
            let line = child(pin, "Connection");
            let mut way = vec![end];
            way.extend(line.children().filter(Node::is_element).map(at).map(|(x, y)| (end.0 + x, end.1 + y)));
            way.push(pins[line.attribute("refConnectionPointOutId").expect("a number")]);
            for piece in way.windows(2) {
                let (a, b) = (piece[0], piece[1]);
                assert!(a.0 == b.0 || a.1 == b.1, "{object:?}: {way:?}");
                for (upper, lower) in &solid {
                    let inside = a.0.max(b.0) > upper.0
                        && a.0.min(b.0) < lower.0
                        && a.1.max(b.1) > upper.1
                        && a.1.min(b.1) < lower.1;
                    assert!(!inside, "{way:?} runs through {upper:?} to {lower:?}");
                }
            }
            lines += 1;
        }
    }
    assert!(lines > 30, "{lines}");
}

/// Three transitions of one row lead back, to two steps: no two lines share a piece that lies across, so that each can be followed.
#[test]
fn lines_of_a_row_lie_apart() {
    let text = exported(
        "sfc Row { input a, b, c, d: bool; initial step Wait; step Try; step One; step Two; step Three;
        Wait -[a]-> Try; Try -[b]-> One; Try -[c]-> Two; Try -[d]-> Three; One -[!b]-> Wait; Two -[!c]-> Try; Three -[!d]-> Wait; }",
    );
    let document = Document::parse(&text).expect("XML");
    let mut across = Vec::new();
    for pin in document.descendants().filter(|node| node.tag_name().name() == "ConnectionPointIn") {
        let object = pin.parent().expect("an object");
        let (from, pin_at) = (at(child(object, "RelPosition")), at(child(pin, "RelPosition")));
        let end = (from.0 + pin_at.0, from.1 + pin_at.1);
        let turns: Vec<(i64, i64)> = child(pin, "Connection").children().filter(Node::is_element).map(at).collect();
        // What leads back turns twice below, and is the only one to do so.
        for pair in turns.windows(2).filter(|pair| pair[0].1 == pair[1].1 && pair[0].1 > 0) {
            across.push(end.1 + pair[0].1);
        }
    }
    assert_eq!(across.len(), 3, "{across:?}");
    assert_eq!(across.iter().collect::<BTreeSet<_>>().len(), 3, "{across:?}");
}

/// Branches have the priorities of the source, from 1.
#[test]
fn priorities_stand_at_the_branches() {
    let text = exported(CHART);
    let document = Document::parse(&text).expect("XML");
    let priorities: Vec<&str> = document.descendants().filter_map(|node| node.attribute("priority")).collect();
    assert_eq!(priorities, ["1", "2", "1", "2", "1", "2"]);
    let there = import(&text, "there").expect("a chart");
    // Written the other way round in the file they come back in their order.
    let turned = text.replace("priority=\"1\"", "priority=\"7\"");
    let turned = import(&turned, "there").expect("a chart");
    let first = |rust: &str| {
        rust.find("Wait -[start]-> Reject").expect("a branch") < rust.find("ready(load)]-> Close").expect("a branch")
    };
    assert!(!first(&there.rust) && first(&turned.rust), "{}\n{}", there.rust, turned.rust);
}

/// As another tool may write it: a prefix, a file of one program, conditions in FBD and LD with numbers of their own, a transition with a name, a line that goes
/// on elsewhere, an action in place, an address, a branch without priorities.
const FOREIGN: &str = r#"<?xml version="1.0"?>
<ppx:Program xmlns:ppx="www.iec.ch/public/TC65SC65BWG7TF10" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" name="Press">
 <ppx:Documentation xsi:type="ppx:SimpleText">The press.
 Of hall 3.</ppx:Documentation>
 <ppx:Parameters>
  <ppx:InputVars><ppx:Variable name="go" orderWithinParamSet="1"><ppx:Type><ppx:TypeName>BOOL</ppx:TypeName></ppx:Type><ppx:Address location="I" size="X" address="0.1"/></ppx:Variable>
   <ppx:Variable name="low" orderWithinParamSet="2"><ppx:Type><ppx:TypeName>BOOL</ppx:TypeName></ppx:Type></ppx:Variable>
   <ppx:Variable name="force" orderWithinParamSet="3"><ppx:Type><ppx:TypeName>INT</ppx:TypeName></ppx:Type></ppx:Variable></ppx:InputVars>
  <ppx:OutputVars><ppx:Variable name="down" orderWithinParamSet="4"><ppx:Type><ppx:TypeName>BOOL</ppx:TypeName></ppx:Type></ppx:Variable></ppx:OutputVars>
 </ppx:Parameters>
 <ppx:Vars accessSpecifier="private"><ppx:Variable name="count"><ppx:Type><ppx:TypeName>INT</ppx:TypeName></ppx:Type><ppx:InitialValue><ppx:SimpleValue value="7"/></ppx:InitialValue></ppx:Variable></ppx:Vars>
 <ppx:MainBody><ppx:BodyContent xsi:type="ppx:SFC">
  <ppx:SfcObject xsi:type="ppx:Step" name="Up" initialStep="true"><ppx:RelPosition x="10" y="10"/>
   <ppx:ConnectionPointIn><ppx:Connection refConnectionPointOutId="9"/></ppx:ConnectionPointIn>
   <ppx:ConnectionPointOut connectionPointOutId="1"/></ppx:SfcObject>
  <ppx:CommonObject xsi:type="ppx:Continuation" label="again"><ppx:RelPosition x="10" y="5"/><ppx:ConnectionPointOut connectionPointOutId="9"/></ppx:CommonObject>
  <ppx:SfcObject xsi:type="ppx:SelectionDivergence"><ppx:RelPosition x="10" y="20"/>
   <ppx:ConnectionPointIn><ppx:Connection refConnectionPointOutId="1"/></ppx:ConnectionPointIn>
   <ppx:ConnectionPointOut connectionPointOutId="2"/><ppx:ConnectionPointOut connectionPointOutId="3"/></ppx:SfcObject>
  <ppx:SfcObject xsi:type="ppx:Transition"><ppx:RelPosition x="10" y="30"/>
   <ppx:ConnectionPointIn><ppx:Connection refConnectionPointOutId="2"/></ppx:ConnectionPointIn><ppx:ConnectionPointOut connectionPointOutId="4"/>
   <ppx:Condition><ppx:GraphicalPredicate><ppx:ConnectionPointIn><ppx:Connection refConnectionPointOutId="3"/></ppx:ConnectionPointIn>
    <ppx:GraphicalExpression xsi:type="ppx:FbdNetwork" evaluationOrder="0">
     <ppx:FbdObject xsi:type="ppx:DataSource" identifier="go"><ppx:ConnectionPointOut connectionPointOutId="1"/></ppx:FbdObject>
     <ppx:FbdObject xsi:type="ppx:DataSource" identifier="force"><ppx:ConnectionPointOut connectionPointOutId="2"/></ppx:FbdObject>
     <ppx:FbdObject xsi:type="ppx:DataSource" identifier="30"><ppx:ConnectionPointOut connectionPointOutId="4"/></ppx:FbdObject>
     <ppx:FbdObject xsi:type="ppx:Block" typeName="LT">
      <ppx:InputVariables><ppx:InputVariable parameterName="IN1"><ppx:ConnectionPointIn><ppx:Connection refConnectionPointOutId="2"/></ppx:ConnectionPointIn></ppx:InputVariable>
       <ppx:InputVariable parameterName="IN2"><ppx:ConnectionPointIn><ppx:Connection refConnectionPointOutId="4"/></ppx:ConnectionPointIn></ppx:InputVariable></ppx:InputVariables>
      <ppx:OutputVariables><ppx:OutputVariable parameterName="OUT"><ppx:ConnectionPointOut connectionPointOutId="5"/></ppx:OutputVariable></ppx:OutputVariables></ppx:FbdObject>
     <ppx:FbdObject xsi:type="ppx:Block" typeName="AND">
      <ppx:InputVariables><ppx:InputVariable parameterName="IN1"><ppx:ConnectionPointIn><ppx:Connection refConnectionPointOutId="1"/></ppx:ConnectionPointIn></ppx:InputVariable>
       <ppx:InputVariable parameterName="IN2" negated="true"><ppx:ConnectionPointIn><ppx:Connection refConnectionPointOutId="5"/></ppx:ConnectionPointIn></ppx:InputVariable></ppx:InputVariables>
      <ppx:OutputVariables><ppx:OutputVariable parameterName="OUT"><ppx:ConnectionPointOut connectionPointOutId="3"/></ppx:OutputVariable></ppx:OutputVariables></ppx:FbdObject>
    </ppx:GraphicalExpression></ppx:GraphicalPredicate></ppx:Condition></ppx:SfcObject>
  <ppx:SfcObject xsi:type="ppx:Transition"><ppx:RelPosition x="90" y="30"/>
   <ppx:ConnectionPointIn><ppx:Connection refConnectionPointOutId="3"/></ppx:ConnectionPointIn><ppx:ConnectionPointOut connectionPointOutId="5"/>
   <ppx:Condition><ppx:Reference name="Enough"/></ppx:Condition></ppx:SfcObject>
  <ppx:SfcObject xsi:type="ppx:Step" name="Press"><ppx:RelPosition x="10" y="40"/>
   <ppx:ConnectionPointIn><ppx:Connection refConnectionPointOutId="4"/></ppx:ConnectionPointIn>
   <ppx:ConnectionPointOut connectionPointOutId="6"/><ppx:ConnectionPointOutAction connectionPointOutId="7"/></ppx:SfcObject>
  <ppx:CommonObject xsi:type="ppx:ActionBlocks"><ppx:RelPosition x="50" y="40"/>
   <ppx:ConnectionPointIn><ppx:Connection refConnectionPointOutId="7"/></ppx:ConnectionPointIn>
   <ppx:ActionBlock><ppx:ActionQualifier qualifier="L" duration="T#3s"/><ppx:ComplexOperand>down</ppx:ComplexOperand></ppx:ActionBlock>
   <ppx:ActionBlock><ppx:ActionQualifier qualifier="P1"/><ppx:Inline><ppx:BodyContent xsi:type="ppx:ST"><ppx:ST><![CDATA[count := count + 1;]]></ppx:ST></ppx:BodyContent></ppx:Inline></ppx:ActionBlock></ppx:CommonObject>
  <ppx:SfcObject xsi:type="ppx:Transition"><ppx:RelPosition x="10" y="50"/>
   <ppx:ConnectionPointIn><ppx:Connection refConnectionPointOutId="6"/></ppx:ConnectionPointIn><ppx:ConnectionPointOut connectionPointOutId="8"/>
   <ppx:Condition><ppx:GraphicalPredicate><ppx:ConnectionPointIn><ppx:Connection refConnectionPointOutId="23"/></ppx:ConnectionPointIn>
    <ppx:GraphicalExpression xsi:type="ppx:LadderRung" evaluationOrder="0">
     <ppx:LdObject xsi:type="ppx:LeftPowerRail"><ppx:ConnectionPointOut connectionPointOutId="21"/></ppx:LdObject>
     <ppx:LdObject xsi:type="ppx:Contact" operand="low"><ppx:ConnectionPointIn><ppx:Connection refConnectionPointOutId="21"/></ppx:ConnectionPointIn><ppx:ConnectionPointOut connectionPointOutId="22"/></ppx:LdObject>
     <ppx:LdObject xsi:type="ppx:CompareContact" compareOperator="&gt;=" operand1="force" operand2="50"><ppx:ConnectionPointIn><ppx:Connection refConnectionPointOutId="22"/></ppx:ConnectionPointIn><ppx:ConnectionPointOut connectionPointOutId="23"/></ppx:LdObject>
    </ppx:GraphicalExpression></ppx:GraphicalPredicate></ppx:Condition></ppx:SfcObject>
  <ppx:SfcObject xsi:type="ppx:SelectionConvergence"><ppx:RelPosition x="10" y="60"/>
   <ppx:ConnectionPointIn><ppx:Connection refConnectionPointOutId="8"/></ppx:ConnectionPointIn>
   <ppx:ConnectionPointIn><ppx:Connection refConnectionPointOutId="5"/></ppx:ConnectionPointIn><ppx:ConnectionPointOut connectionPointOutId="10"/></ppx:SfcObject>
  <ppx:SfcObject xsi:type="ppx:Step" name="Open"><ppx:RelPosition x="10" y="65"/>
   <ppx:ConnectionPointIn><ppx:Connection refConnectionPointOutId="10"/></ppx:ConnectionPointIn><ppx:ConnectionPointOut connectionPointOutId="11"/></ppx:SfcObject>
  <ppx:SfcObject xsi:type="ppx:Transition"><ppx:RelPosition x="10" y="70"/>
   <ppx:ConnectionPointIn><ppx:Connection refConnectionPointOutId="11"/></ppx:ConnectionPointIn><ppx:ConnectionPointOut connectionPointOutId="12"/>
   <ppx:Condition><ppx:TextualPredicate><ppx:PredicateContent xsi:type="ppx:ST"><ppx:ST>NOT go AND NOT low</ppx:ST></ppx:PredicateContent></ppx:TextualPredicate></ppx:Condition></ppx:SfcObject>
  <ppx:CommonObject xsi:type="ppx:Connector" label="again"><ppx:RelPosition x="10" y="80"/><ppx:ConnectionPointIn><ppx:Connection refConnectionPointOutId="12"/></ppx:ConnectionPointIn></ppx:CommonObject>
 </ppx:BodyContent></ppx:MainBody>
 <ppx:Transition name="Enough"><ppx:Condition><ppx:PredicateContent xsi:type="ppx:ST"><ppx:ST>Enough := count &gt; 100;</ppx:ST></ppx:PredicateContent></ppx:Condition></ppx:Transition>
</ppx:Program>
"#;

#[test]
fn what_others_write_is_read() {
    let done = import(FOREIGN, "press.xml").unwrap_or_else(|wrong| panic!("{wrong:?}: {}", &FOREIGN[wrong.at.clone()]));
    for part in [
        "The press.",
        "Of hall 3.",
        "%IX0.1",
        "Up -[go && !(force < 30)]-> Press",
        "-[low && force >= 50]-> Open",
        "count > 100",
        "-[!go && !low]-> Up",
        "L 3s down;",
        "count = count + 1;",
    ] {
        assert!(done.rust.contains(part), "{part}\n{}", done.rust);
    }
    assert_eq!(done.charts.len(), 1);
    let wrong = |from: &str, to: &str| {
        let text = FOREIGN.replacen(from, to, 1);
        let wrong = import(&text, "there").expect_err(to);
        (text[wrong.at].to_owned(), wrong.message)
    };
    assert_eq!(
        wrong("connectionPointOutId=\"12\"", "connectionPointOutId=\"11\""),
        ("<ppx:SfcObject".to_owned(), "two elements have the number 11".to_owned())
    );
}
