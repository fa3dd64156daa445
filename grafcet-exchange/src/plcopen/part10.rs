//! The first edition of IEC 61131-10: each pin that lines leave has a number, and lines lead to these. What an element is stands in its `xsi:type`.

use super::network::{In, Kind, Object, Pin, ROW};
use super::xml::Element;
use super::{DATE, body, to_be_written};
use crate::sfc::{Chart, Step};
use crate::st::syntax::{Stub, Variable};

const NAMESPACE: &str = "www.iec.ch/public/TC65SC65BWG7TF10";
const INSTANCE: &str = "http://www.w3.org/2001/XMLSchema-instance";

pub(super) fn project(chart: &Chart, network: &[Object<'_>]) -> Element {
    let scaling = |language: &str| xy(language, (1, 1));
    let coordinates = ["FbdScaling", "LdScaling", "SfcScaling"].map(scaling);
    Element::new("Project")
        .with("xmlns", NAMESPACE)
        .with("xmlns:xsi", INSTANCE)
        .with("schemaVersion", "1.0")
        .child(
            Element::new("FileHeader")
                .with("companyName", "")
                .with("productName", "cargo grafcet")
                .with("productVersion", env!("CARGO_PKG_VERSION")),
        )
        .child(
            Element::new("ContentHeader")
                .with("name", &chart.name)
                .with("creationDateTime", DATE)
                .child(Element::new("CoordinateInfo").children(coordinates)),
        )
        .child(Element::new("Types").child(
            Element::new("GlobalNamespace").children(chart.functions.iter().map(stub)).child(program(chart, network)),
        ))
        .child(Element::new("Instances"))
}

fn program(chart: &Chart, network: &[Object<'_>]) -> Element {
    let action = |action: &crate::sfc::Action| {
        Element::new("Action")
            .with("name", &action.name)
            .child(Element::new("Body").child(st("BodyContent", &body(action))))
    };
    let mut program = Element::new("Program").with("name", &chart.name);
    if !chart.header.is_empty() {
        program = program.child(documentation(&chart.header.join("\n")));
    }
    let objects = network.iter().filter_map(|one| object(chart, one));
    let content = Element::new("BodyContent").with("xsi:type", "SFC").children(objects);
    program
        .children(parameters(&chart.inputs, &chart.outputs))
        .children(variables(&chart.variables))
        .child(Element::new("MainBody").child(content))
        .children(chart.actions.iter().map(action))
}

/// A function or a function block that a person has to write.
fn stub(stub: &Stub) -> Element {
    let returns = stub.ty.as_deref().map(|ty| Element::new("ResultType").child(type_name(ty)));
    Element::new(if stub.ty.is_some() { "Function" } else { "FunctionBlock" })
        .with("name", &stub.name)
        .children(returns)
        .children(parameters(&stub.inputs, &[]))
        .child(Element::new("MainBody").child(st("BodyContent", &to_be_written(stub))))
}

/// Inputs and outputs, counted together.
fn parameters(inputs: &[Variable], outputs: &[Variable]) -> Option<Element> {
    let list = |name: &str, from: usize, all: &[Variable]| {
        let all = (from..).zip(all).map(|(order, one)| variable(one, Some(order)));
        Element::new(name).children(all)
    };
    let mut set = Element::new("Parameters");
    if !inputs.is_empty() {
        set = set.child(list("InputVars", 1, inputs));
    }
    if !outputs.is_empty() {
        set = set.child(list("OutputVars", 1 + inputs.len(), outputs));
    }
    (!inputs.is_empty() || !outputs.is_empty()).then_some(set)
}

fn variables(all: &[Variable]) -> Option<Element> {
    let list = Element::new("Vars").with("accessSpecifier", "private");
    (!all.is_empty()).then(|| list.children(all.iter().map(|one| variable(one, None))))
}

fn variable(variable: &Variable, order: Option<usize>) -> Element {
    let mut element = Element::new("Variable").with("name", &variable.name);
    if let Some(order) = order {
        element = element.with("orderWithinParamSet", order);
    }
    if !variable.note.is_empty() {
        element = element.child(documentation(&variable.note));
    }
    element = element.child(Element::new("Type").child(type_name(&variable.ty)));
    if let Some(init) = &variable.init {
        element = element.child(Element::new("InitialValue").child(Element::new("SimpleValue").with("value", init)));
    }
    element
}

fn type_name(ty: &str) -> Element {
    Element::new("TypeName").words(ty)
}

fn documentation(text: &str) -> Element {
    Element::new("Documentation").with("xsi:type", "SimpleText").words(text)
}

/// Structured text, as a body or a predicate.
fn st(name: &str, text: &str) -> Element {
    Element::new(name).with("xsi:type", "ST").child(Element::new("ST").words(text))
}

/// None for a jump, which the edition does not have; lines lead back instead.
fn object(chart: &Chart, object: &Object<'_>) -> Option<Element> {
    let (name, kind) = match object.kind {
        Kind::Step(..) => ("SfcObject", "Step"),
        Kind::Transition(_) => ("SfcObject", "Transition"),
        Kind::SelectionDivergence(_) => ("SfcObject", "SelectionDivergence"),
        Kind::SelectionConvergence => ("SfcObject", "SelectionConvergence"),
        Kind::SimultaneousDivergence => ("SfcObject", "SimultaneousDivergence"),
        Kind::SimultaneousConvergence => ("SfcObject", "SimultaneousConvergence"),
        Kind::Actions(..) => ("CommonObject", "ActionBlocks"),
        Kind::Jump(_) => return None,
    };
    let mut element = Element::new(name).with("xsi:type", kind);
    if let Kind::Step(step, _) = &object.kind {
        element = element.with("name", &step.name);
        if step.initial {
            element = element.with("initialStep", true);
        }
        if !step.note.is_empty() {
            element = element.child(documentation(&step.note));
        }
    }
    let place = object.place;
    let element = element
        .child(xy("RelPosition", (place.x, place.y)))
        .child(xy("Size", (place.width, place.height)))
        .children(object.ins.iter().map(|pin| connection_in(pin, (place.x, place.y))));
    Some(match &object.kind {
        Kind::SelectionDivergence(priorities) => {
            let outs = object.outs.iter().zip(priorities).map(|(pin, priority)| {
                let point = connection_out("ConnectionPointOut", *pin);
                match priority {
                    Some(priority) => point.with("priority", priority),
                    None => point,
                }
            });
            element.children(outs)
        }
        Kind::Actions(step, _) => element.children(actions(chart, step)),
        _ => inside(object, element.children(object.outs.iter().map(|pin| connection_out("ConnectionPointOut", *pin)))),
    })
}

/// What a step or a transition has after its pins.
fn inside(object: &Object<'_>, element: Element) -> Element {
    match &object.kind {
        Kind::Step(_, Some(pin)) => element.child(connection_out("ConnectionPointOutAction", *pin)),
        Kind::Transition(transition) => {
            let predicate = Element::new("TextualPredicate").child(st("PredicateContent", &transition.condition));
            element.child(Element::new("Condition").child(predicate))
        }
        _ => element,
    }
}

fn actions<'a>(chart: &'a Chart, step: &'a Step) -> impl Iterator<Item = Element> + 'a {
    (0..).zip(&step.blocks).map(|(number, one)| {
        let mut qualifier = Element::new("ActionQualifier").with("qualifier", one.qualifier);
        if let Some(time) = &one.time {
            qualifier = qualifier.with("duration", time);
        }
        // An action has a name that is referred to, a boolean variable is an operand.
        let is_action = chart.actions.iter().any(|action| action.name == one.action);
        let what = if is_action { "ReferenceName" } else { "ComplexOperand" };
        Element::new("ActionBlock")
            .child(xy("RelPosition", (0, number * ROW)))
            .child(qualifier)
            .child(Element::new(what).words(&one.action))
    })
}

fn xy(name: &str, (x, y): (i32, i32)) -> Element {
    Element::new(name).with("x", x).with("y", y)
}

/// A pin that lines leave, from the upper left corner of what it belongs to.
fn connection_out(name: &str, pin: Pin) -> Element {
    Element::new(name).with("connectionPointOutId", pin.number).child(xy("RelPosition", pin.at))
}

/// A pin with the lines that come into it. Both ends of a line are known; where it turns is told from the pin.
fn connection_in(pin: &In, corner: (i32, i32)) -> Element {
    let at = (corner.0 + pin.at.0, corner.1 + pin.at.1);
    let lines = pin.lines.iter().map(|line| {
        let turns = line.way.get(1..line.way.len() - 1).unwrap_or_default();
        let connection = Element::new("Connection").with("refConnectionPointOutId", line.from.pin);
        connection.children(turns.iter().map(|turn| xy("RelPosition", (turn.0 - at.0, turn.1 - at.1))))
    });
    Element::new("ConnectionPointIn").child(xy("RelPosition", pin.at)).children(lines)
}
