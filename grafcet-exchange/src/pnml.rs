//! PNML (ISO/IEC 15909-2), which tools for Petri nets read.

use std::fmt::Write as _;

use grafcet_compiler::model::{Id, Model, StepId, Transition};

use crate::Refused;

/// The type of net: places and transitions without colours.
const PTNET: &str = "http://www.pnml.org/version-2009/grammar/ptnet";

/// A chart as a net: a place for each step, with a token where the step is initial, and a transition for each transition; conditions are names
/// of transitions alone. What a net without conditions can reach, the chart may reach; macro-steps are expanded, and an `any` is a transition from
/// each of its steps.
///
/// # Errors
/// Orders and enclosing steps move tokens without transitions: a chart that has them is no net.
pub fn pnml(model: &Model) -> Result<String, Vec<Refused>> {
    let refused = refused(model);
    if !refused.is_empty() {
        return Err(refused);
    }
    let mut text = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    // Writing into a text cannot fail.
    _ = write_net(&mut text, model);
    Ok(text)
}

fn refused(model: &Model) -> Vec<Refused> {
    let forces = model.forces.values().map(|force| {
        Refused::at(force.mark, "a forcing order moves tokens without a transition, which no Petri net does")
    });
    let enclosures = model.steps.values().filter(|step| !step.encloses.is_empty()).map(|step| {
        let message = format!("what `{}` encloses begins and ends without a transition, as in no Petri net", step.name);
        Refused::at((&step.name).into(), message)
    });
    forces.chain(enclosures).collect()
}

fn write_net(text: &mut String, model: &Model) -> std::fmt::Result {
    writeln!(text, "<pnml xmlns=\"http://www.pnml.org/version-2009/grammar/pnml\">")?;
    writeln!(text, "  <net id=\"net\" type=\"{PTNET}\">")?;
    writeln!(text, "    <name><text>{}</text></name>", escaped(&plain(&model.name)))?;
    writeln!(text, "    <page id=\"page\">")?;
    for (id, step) in model.steps.iter() {
        writeln!(text, "      <place id=\"{}\">", place(id))?;
        writeln!(text, "        <name><text>{}</text></name>", escaped(&plain(&step.name)))?;
        if step.initial {
            writeln!(text, "        <initialMarking><text>1</text></initialMarking>")?;
        }
        writeln!(text, "      </place>")?;
    }
    for (id, transition) in model.transitions.iter() {
        writeln!(text, "      <transition id=\"t{}\">", id.index() + 1)?;
        writeln!(text, "        <name><text>{}</text></name>", escaped(&named(transition)))?;
        writeln!(text, "      </transition>")?;
    }
    let mut number = 0;
    for (id, transition) in model.transitions.iter() {
        let here = format!("t{}", id.index() + 1);
        let from = transition.sources.iter().map(|step| (place(*step), here.clone()));
        let to = transition.targets.iter().map(|step| (here.clone(), place(*step)));
        for (source, target) in from.chain(to) {
            number += 1;
            writeln!(text, "      <arc id=\"a{number}\" source=\"{source}\" target=\"{target}\"/>")?;
        }
    }
    writeln!(text, "    </page>\n  </net>\n</pnml>")
}

fn place(id: StepId) -> String {
    format!("s{}", id.index() + 1)
}

/// `go: on && !hot`
fn named(transition: &Transition) -> String {
    match &transition.name {
        Some(name) => format!("{}: {}", plain(name), transition.condition.text),
        None => transition.condition.text.clone(),
    }
}

fn plain(name: &proc_macro2::Ident) -> String {
    name.to_string().trim_start_matches("r#").to_owned()
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
