//! PLCopen XML (TC6, version 2.01), which CODESYS, Beremiz and others open: the chart as a drawing of SFC.
//!
//! - here: the file around the chart
//! - `place`: where steps and transitions stand, which `grafcet-draw` finds
//! - `network`: what lies between them: divergences, convergences, jumps, and who is connected with whom
//! - `xml`: elements as text

mod network;
mod place;
mod xml;

use grafcet_compiler::model::Model;

use crate::Refused;
use crate::sfc::{Chart, Exported, build, classic};
use crate::st::syntax::{Stub, Variable, statements};
use xml::Element;

const NAMESPACE: &str = "http://www.plcopen.org/xml/tc6_0201";
const XHTML: &str = "http://www.w3.org/1999/xhtml";
/// The same chart gives the same file, so it says no time of its own.
const DATE: &str = "2000-01-01T00:00:00";

/// What kind of drawing is wanted.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Options {
    /// What is done in each scan stands at a step of its own that is always active, in a network beside the chart; else the initial step sets it. Beremiz
    /// declares an action behind the first step that has it, and there the other steps that it asks for are not known yet. CODESYS has one initial step.
    pub scan_step: bool,
}

/// A chart as a project of PLCopen XML with one program.
///
/// # Errors
/// What [`crate::sfc::textual`] refuses.
pub fn plcopen(model: &Model, options: Options) -> Result<Exported, Vec<Refused>> {
    let mut chart = build(model)?;
    if options.scan_step {
        chart.with_scan_step();
    }
    let places = place::places(model, &chart);
    let network = network::network(&chart, &places);
    let text = format!("<?xml version=\"1.0\" encoding=\"utf-8\"?>\n{}", project(&chart, network).text());
    Ok(chart.exported(text))
}

fn project(chart: &Chart, network: Vec<Element>) -> Element {
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

fn program(chart: &Chart, network: Vec<Element>) -> Element {
    let action = |action: &crate::sfc::Action| {
        let mut body = String::new();
        statements(&mut body, 0, &action.body);
        Element::new("action").with("name", &action.name).child(Element::new("body").child(st(body.trim_end())))
    };
    let mut pou = Element::new("pou").with("name", &chart.name).with("pouType", "program");
    let lists = [("inputVars", &chart.inputs), ("outputVars", &chart.outputs), ("localVars", &chart.variables)];
    pou = pou.child(interface(None, &lists));
    if !chart.actions.is_empty() {
        pou = pou.child(Element::new("actions").children(chart.actions.iter().map(action)));
    }
    pou.child(Element::new("body").child(Element::new("SFC").children(network)))
}

/// A function or a function block that a person has to write.
fn stub(stub: &Stub) -> Element {
    let kind = if stub.ty.is_some() { "function" } else { "functionBlock" };
    let nothing = match stub.ty.as_deref() {
        Some("BOOL") => format!("{} := FALSE;", stub.name),
        Some(_) => format!("{} := 0;", stub.name),
        None => ";".to_owned(),
    };
    let body = format!("// TO BE WRITTEN, in Rust: {}\n{nothing}", stub.rust);
    Element::new("pou")
        .with("name", &stub.name)
        .with("pouType", kind)
        .child(interface(stub.ty.as_deref(), &[("inputVars", &stub.inputs)]))
        .child(Element::new("body").child(st(classic(&body).trim_end())))
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
    const ELEMENTARY: [&str; 10] = ["BOOL", "SINT", "INT", "DINT", "LINT", "USINT", "UINT", "UDINT", "ULINT", "TIME"];
    if ELEMENTARY.contains(&ty) { Element::new(ty) } else { Element::new("derived").with("name", ty) }
}

fn documentation(text: &str) -> Element {
    Element::new("documentation").child(Element::new("xhtml:p").words(text))
}

/// Structured text.
fn st(text: &str) -> Element {
    Element::new("ST").child(Element::new("xhtml:p").words(text))
}
