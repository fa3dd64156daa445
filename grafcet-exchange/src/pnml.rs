//! PNML (ISO/IEC 15909-2), which tools for Petri nets read.

use std::fmt::Write as _;

use grafcet_compiler::analysis::{Concurrency, Facts, Logic};
use grafcet_compiler::model::{Binary, Id, Model, Read, Step, StepId, Transition, TransitionId, Tree};

use crate::Refused;

/// The type of net: places and transitions without colours.
const PTNET: &str = "http://www.pnml.org/version-2009/grammar/ptnet";

/// A chart as a net: a place for each step, with a token where the step is initial, and a transition for each transition; conditions are names
/// of transitions alone. What the chart can reach, the net can reach: what clears in one evolution fires one after the other, and a place has a
/// token as long as its step is active. Macro-steps are expanded, and an `any` is a transition from each of its steps.
///
/// # Errors
/// What no net does, so that it would show something else than the chart: orders and enclosing steps move tokens without transitions; branches that clear
/// together would need a token each; what is activated while it is active would have two; and an `any` takes away whatever is there.
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
    let mut refused: Vec<Refused> = forces.chain(enclosures).collect();
    if refused.is_empty() {
        refused = branches(model);
    }
    if refused.is_empty() {
        // Each token is taken by one transition.
        let concurrency = Concurrency::of_exclusive_branches(model);
        refused.extend(twice(model, &concurrency));
        refused.extend(anys(model, &concurrency));
    }
    refused
}

/// Branches that clear together (rule 4 of IEC 60848).
fn branches(model: &Model) -> Vec<Refused> {
    let facts = Facts::of(model);
    let logic = Logic::assuming(model, &facts.never);
    let known = facts.exclusive(model);
    let overlapping = model.steps.iter().filter(|(id, _)| {
        let all = &model.leaving[id.index()];
        !known[id.index()] && !exclusive(model, &logic, all)
    });
    let refuse = |(_, step): (StepId, &Step)| {
        let message = format!(
            "two branches of `{}` may clear together, and a Petri net gives the token to one of them: let their conditions exclude each other, or write `else`",
            step.name
        );
        Refused::at((&step.name).into(), message)
    };
    overlapping.map(refuse).collect()
}

/// What would have a second token.
fn twice(model: &Model, concurrency: &Concurrency) -> Vec<Refused> {
    let steps = model.steps.iter().filter(|(id, _)| concurrency.activated_while_active(*id));
    let refuse = |name: &proc_macro2::Ident| {
        let message = format!(
            "`{name}` may be activated while it is active, which changes nothing in the chart and makes a second token in a Petri net"
        );
        Refused::at(name.into(), message)
    };
    steps.map(|(_, step)| refuse(&step.name)).collect()
}

/// Whether at most one of these clears at a time, as far as their conditions and the steps that they leave tell.
fn exclusive(model: &Model, logic: &Logic<'_>, all: &[TransitionId]) -> bool {
    let clears = |id: &TransitionId| {
        let transition = &model.transitions[*id];
        let active = transition.sources.iter().map(|step| Tree::Read(Read::Active(*step)));
        let and = |one, other| Tree::Binary(Binary::And, Box::new(one), Box::new(other));
        logic.condition(&active.fold(transition.condition.tree.clone(), and))
    };
    let conditions: Vec<_> = all.iter().map(clears).collect();
    (0..all.len()).all(|at| {
        (at + 1..all.len()).all(|other| {
            model.exclude_each_other(all[at], all[other]) || logic.exclusive(&conditions[at], &conditions[other])
        })
    })
}

/// An `any` beside parallel branches.
fn anys(model: &Model, concurrency: &Concurrency) -> Vec<Refused> {
    let mut refused = Vec::new();
    for any in model.anys.ids() {
        let all = model.transitions.values().filter(|transition| transition.any == Some(any));
        let (marks, left): (Vec<_>, Vec<StepId>) =
            all.flat_map(|transition| transition.sources.iter().map(|step| (transition.mark, *step))).unzip();
        let pairs =
            left.iter().enumerate().flat_map(|(at, one)| left[at + 1..].iter().map(move |other| (*one, *other)));
        let mut together = pairs.filter(|(one, other)| concurrency.together(*one, *other));
        let Some((one, other)) = together.next() else { continue };
        let message = format!(
            "`any` leaves all that is active at once, such as `{}` and `{}`, and a transition of a Petri net takes the same tokens each time",
            model.steps[one].name, model.steps[other].name
        );
        refused.extend(marks.first().map(|mark| Refused::at(*mark, message)));
    }
    refused
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
