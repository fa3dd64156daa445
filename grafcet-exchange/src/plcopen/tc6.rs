//! TC6 2.01 of PLCopen: elements have numbers, and lines lead to these.

use super::network::{In, Kind, Object, ROW};
use super::xml::Element;
use super::{DATE, body, to_be_written};
use crate::sfc::Chart;
use crate::st::syntax::{Stub, Variable};

const NAMESPACE: &str = "http://www.plcopen.org/xml/tc6_0201";
const XHTML: &str = "http://www.w3.org/1999/xhtml";

pub(super) fn project(chart: &Chart, network: &[Object<'_>]) -> Element {
    let scaling = |language: &str| Element::new(language).child(Element::new("scaling").with("x", 8).with("y", 8));
    let coordinates = Element::new("coordinateInfo").children(["fbd", "ld", "sfc"].map(scaling));
    let mut pous: Vec<Element> = chart.functions.iter().map(stub).collect();
    pous.push(program(chart, network));
    Element::new("project")
        .with("xmlns", NAMESPACE)
        .with("xmlns:xhtml", XHTML)
        .child(
            Element::new("fileHeader")
                .with("companyName", "")
                .with("productName", "cargo grafcet")
                .with("productVersion", env!("CARGO_PKG_VERSION"))
                .with("creationDateTime", DATE),
        )
        .child(
            Element::new("contentHeader")
                .with("name", &chart.name)
                .child(Element::new("Comment").words(chart.header.join("\n")))
                .child(coordinates),
        )
        .child(Element::new("types").child(Element::new("dataTypes")).child(Element::new("pous").children(pous)))
        .child(Element::new("instances").child(Element::new("configurations")))
}

fn program(chart: &Chart, network: &[Object<'_>]) -> Element {
    let action = |action: &crate::sfc::Action| {
        Element::new("action").with("name", &action.name).child(Element::new("body").child(st(&body(action))))
    };
    let mut pou = Element::new("pou").with("name", &chart.name).with("pouType", "program");
    let lists = [("inputVars", &chart.inputs), ("outputVars", &chart.outputs), ("localVars", &chart.variables)];
    pou = pou.child(interface(None, &lists));
    if !chart.actions.is_empty() {
        pou = pou.child(Element::new("actions").children(chart.actions.iter().map(action)));
    }
    pou.child(Element::new("body").child(Element::new("SFC").children(network.iter().map(object))))
}

/// A function or a function block that a person has to write.
fn stub(stub: &Stub) -> Element {
    let kind = if stub.ty.is_some() { "function" } else { "functionBlock" };
    Element::new("pou")
        .with("name", &stub.name)
        .with("pouType", kind)
        .child(interface(stub.ty.as_deref(), &[("inputVars", &stub.inputs)]))
        .child(Element::new("body").child(st(&to_be_written(stub))))
}

fn interface(returns: Option<&str>, lists: &[(&str, &Vec<Variable>)]) -> Element {
    let returns = returns.map(|ty| Element::new("returnType").child(type_of(ty)));
    let lists = lists.iter().filter(|(_, variables)| !variables.is_empty());
    let lists = lists.map(|(name, variables)| Element::new(name).children(variables.iter().map(variable)));
    Element::new("interface").children(returns).children(lists)
}

fn variable(variable: &Variable) -> Element {
    let mut element =
        Element::new("variable").with("name", &variable.name).child(Element::new("type").child(type_of(&variable.ty)));
    if let Some(init) = &variable.init {
        element = element.child(Element::new("initialValue").child(Element::new("simpleValue").with("value", init)));
    }
    if !variable.note.is_empty() {
        element = element.child(documentation(&variable.note));
    }
    element
}

/// A type of the standard, or the name of a function block.
fn type_of(ty: &str) -> Element {
    const ELEMENTARY: [&str; 12] =
        ["BOOL", "SINT", "INT", "DINT", "LINT", "USINT", "UINT", "UDINT", "ULINT", "REAL", "LREAL", "TIME"];
    if ELEMENTARY.contains(&ty) { Element::new(ty) } else { Element::new("derived").with("name", ty) }
}

fn documentation(text: &str) -> Element {
    Element::new("documentation").child(Element::new("xhtml:p").words(text))
}

/// Structured text.
fn st(text: &str) -> Element {
    Element::new("ST").child(Element::new("xhtml:p").words(text))
}

fn object(object: &Object<'_>) -> Element {
    let name = match object.kind {
        Kind::Step(..) => "step",
        Kind::Transition(_) => "transition",
        Kind::SelectionDivergence(_) => "selectionDivergence",
        Kind::SelectionConvergence => "selectionConvergence",
        Kind::SimultaneousDivergence => "simultaneousDivergence",
        Kind::SimultaneousConvergence => "simultaneousConvergence",
        Kind::Jump(_) => "jumpStep",
        Kind::Actions(..) => "actionBlock",
    };
    let mut element = Element::new(name)
        .with("localId", object.id)
        .with("width", object.place.width)
        .with("height", object.place.height);
    element = match &object.kind {
        Kind::Step(step, _) => {
            let element = element.with("name", &step.name);
            if step.initial { element.with("initialStep", true) } else { element }
        }
        Kind::Transition(transition) => match transition.priority {
            Some(priority) => element.with("priority", priority),
            None => element,
        },
        Kind::Jump(name) => element.with("targetName", name),
        _ => element,
    };
    // Where there may be several the schema wants a name, and has none for them.
    let is_named = matches!(object.kind, Kind::Step(..) | Kind::SelectionDivergence(_) | Kind::SimultaneousDivergence);
    let outs = object.outs.iter().map(|pin| {
        let point = point("connectionPointOut", pin.at);
        if is_named { point.with("formalParameter", "") } else { point }
    });
    let element = element
        .child(position("position", (object.place.x, object.place.y)))
        .children(object.ins.iter().map(connection_in))
        .children(outs);
    inside(object, element)
}

/// What an element has after its pins.
fn inside(object: &Object<'_>, mut element: Element) -> Element {
    match &object.kind {
        Kind::Step(step, action) => {
            if let Some(pin) = action {
                element = element.child(point("connectionPointOutAction", pin.at).with("formalParameter", ""));
            }
            if step.note.is_empty() { element } else { element.child(documentation(&step.note)) }
        }
        Kind::Transition(transition) => {
            let inline = Element::new("inline").with("name", "").child(st(&transition.condition));
            element.child(Element::new("condition").child(inline))
        }
        Kind::Actions(step, ids) => {
            for ((number, one), id) in (0..).zip(&step.blocks).zip(ids) {
                let mut action = Element::new("action").with("localId", id).with("qualifier", one.qualifier);
                if let Some(time) = &one.time {
                    action = action.with("duration", time);
                }
                element = element.child(
                    action
                        .child(position("relPosition", (0, number * ROW)))
                        .child(Element::new("reference").with("name", &one.action)),
                );
            }
            element
        }
        _ => element,
    }
}

fn position(name: &str, (x, y): (i32, i32)) -> Element {
    Element::new(name).with("x", x).with("y", y)
}

/// A pin, from the upper left corner of what it belongs to.
fn point(name: &str, at: (i32, i32)) -> Element {
    Element::new(name).child(position("relPosition", at))
}

/// A pin with the lines that come into it.
fn connection_in(pin: &In) -> Element {
    let lines = pin.lines.iter().map(|line| {
        let connection = Element::new("connection").with("refLocalId", line.from.id);
        connection.children(line.way.iter().map(|at| position("position", *at)))
    });
    point("connectionPointIn", pin.at).children(lines)
}
