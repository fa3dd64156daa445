//! A chart as Rust source.

use std::collections::{BTreeMap, BTreeSet};

use super::actions::Actions;
use super::declare::{declared, left_out};
use super::expr::{Kind, Scope};
use super::facts::{Facts, action};
use super::names::{Names, camel};
use super::parser::expression;
use super::source::{Action, Block, Pou, Section, Step, Transition, What, same};
use super::types::Enum;
use super::{Chart, Wrong};

/// No line of a chain is longer, if it can be.
pub(super) const WIDTH: usize = 110;

/// The text of one chart, and of the functions after it.
pub(super) struct Source {
    chart: Vec<String>,
    functions: Vec<String>,
    /// By their places in the file, enums that the chart needs.
    enums: BTreeMap<usize, Vec<String>>,
}

/// A program as a chart. `pous` are all of its file.
pub(super) fn chart(pou: &Pou, pous: &[Pou]) -> Result<(Chart, Source), Wrong> {
    checked(pou)?;
    let pou = &without_scan_step(pou);
    let mut plain = BTreeSet::new();
    loop {
        let (chart, source, read) = attempt(pou, pous, &plain);
        if read.is_empty() {
            return Ok((chart, source));
        }
        plain.extend(read);
    }
}

/// Without a step that is always active and stands alone: what it does the first step of the chart sets.
fn without_scan_step(pou: &Pou) -> Pou {
    let mut pou = pou.clone();
    let touched = |step: &Step| {
        let mut all = pou.transitions.iter().flat_map(|transition| transition.from.iter().chain(&transition.to));
        all.any(|name| same(name, &step.name))
    };
    let is_action = |block: &Block| {
        matches!(&block.what, What::Named(name) if action(&pou, name).is_some()) && same(&block.qualifier, "N")
    };
    let alone =
        |step: &Step| step.initial && !touched(step) && !step.blocks.is_empty() && step.blocks.iter().all(is_action);
    let (alone, mut others): (Vec<Step>, Vec<Step>) = pou.steps.clone().into_iter().partition(alone);
    if let Some(first) = others.iter_mut().find(|step| step.initial) {
        let blocks = alone.into_iter().flat_map(|step| step.blocks);
        first.blocks.extend(blocks.map(|block| Block { qualifier: "S".to_owned(), ..block }));
        pou.steps = others;
    }
    pou
}

/// The same, and what was taken for the memory of an edge, and is none.
fn attempt(pou: &Pou, pous: &[Pou], plain: &BTreeSet<String>) -> (Chart, Source, BTreeSet<String>) {
    let facts = Facts::of(pou, plain);
    let mut pou = pou.clone();
    pou.variables.extend(facts.added.iter().cloned());
    let pou = &pou;
    let mut notes: Vec<Wrong> =
        pou.lost.iter().map(|(at, what)| Wrong { at: at.clone(), message: format!("left out: {what}") }).collect();
    notes.extend(unused(pou, &facts));
    notes.extend(facts.differs.iter().map(|(at, message)| Wrong { at: at.clone(), message: message.clone() }));
    let mut scope = scope(pou, pous, &facts);
    let mut actions = Actions::new(pou, &facts, &mut scope);
    let bodies: Vec<Vec<String>> = (0..pou.steps.len()).map(|number| actions.of_step(number)).collect();
    let (code, more, stubs) = (actions.code, actions.notes, actions.stubs);
    notes.extend(more);
    // What only a stub would write comes from outside.
    let written = facts.written(&stubs);
    let declared = declared(pou, &facts, (&written, &mut scope), &mut notes);
    notes.extend(left_out(pou, &facts, &scope, &code));
    let within: Vec<Option<String>> = pou.steps.iter().map(|step| longest(step, &mut scope, &mut notes)).collect();
    let mut functions = Vec::new();
    let conditions = conditions(pou, &mut scope, &mut notes, &mut functions);
    functions.extend(called(&scope));
    let name = camel(&pou.name);
    let mut lines = Vec::new();
    docs(&mut lines, &about(pou), "    ///");
    lines.push(format!("    pub sfc {name} {{"));
    // Each network of a program has an initial step of its own.
    if pou.steps.iter().filter(|step| step.initial).count() > 1 {
        lines.push("        #![allow(grafcet::several_initial_steps)]".to_owned());
    }
    lines.extend(declared);
    for (name, (said, parameters)) in &code {
        docs(&mut lines, said, "        ///");
        lines.push(format!("        action {name}({parameters});"));
    }
    lines.push(String::new());
    steps(pou, &scope, (&bodies, &within), &mut lines);
    lines.push(String::new());
    chains(pou, &scope, &conditions, &mut lines);
    lines.push("    }".to_owned());
    let used: BTreeMap<usize, &Enum> = scope.used.iter().map(|of| (*of, &scope.enums[*of])).collect();
    let mut renamed = scope.names.renamed;
    renamed.extend(used.values().flat_map(|one| one.renamed()));
    let enums = used.into_iter().map(|(of, one)| (of, one.lines())).collect();
    if name != pou.name {
        renamed.insert(0, (pou.name.clone(), name.clone()));
    }
    notes.sort_by_key(|note| note.at.start);
    notes.dedup();
    (Chart { name, renamed, notes }, Source { chart: lines, functions, enums }, scope.plain)
}

/// Actions that belong to no step, and that none calls.
fn unused(pou: &Pou, facts: &Facts) -> Vec<Wrong> {
    let at_step = |name: &str| {
        let blocks = pou.steps.iter().flat_map(|step| &step.blocks);
        blocks.into_iter().any(|block| matches!(&block.what, What::Named(other) if same(other, name)))
    };
    let unused =
        pou.actions.iter().filter(|one| !at_step(&one.name) && !facts.called.contains(&one.name.to_lowercase()));
    let note = |one: &Action| Wrong {
        at: one.body.at.clone(),
        message: format!("left out: the action `{}`, which belongs to no step", one.name),
    };
    unused.map(note).collect()
}

/// Transitions lead from steps to steps, and each step is there once.
fn checked(pou: &Pou) -> Result<(), Wrong> {
    for (index, step) in pou.steps.iter().enumerate() {
        if pou.steps[..index].iter().any(|other| same(&other.name, &step.name)) {
            return Err(Wrong { at: step.at.clone(), message: format!("there are two steps `{}`", step.name) });
        }
    }
    for transition in &pou.transitions {
        for name in transition.from.iter().chain(&transition.to) {
            if !pou.steps.iter().any(|step| same(&step.name, name)) {
                return Err(Wrong { at: transition.at.clone(), message: format!("there is no step `{name}`") });
            }
        }
    }
    Ok(())
}

fn scope<'p>(pou: &Pou, pous: &'p [Pou], facts: &Facts) -> Scope<'p> {
    let mut names = Names::new();
    let (mut kinds, mut counters) = (BTreeMap::new(), BTreeMap::new());
    for variable in pou.variables.iter().filter(|variable| !facts.memory.contains_key(&variable.name.to_lowercase())) {
        let Some(kind) = pou.kind(&variable.ty) else { continue };
        if facts.counters.contains(&variable.name.to_lowercase()) {
            counters.insert(variable.name.to_lowercase(), kind);
            names.value(&variable.name);
            continue;
        }
        if kinds.insert(variable.name.to_lowercase(), kind).is_none() {
            names.value(&variable.name);
        }
    }
    for step in &pou.steps {
        names.step(&step.name);
    }
    Scope {
        names,
        kinds,
        steps: pou.steps.iter().map(|step| step.name.to_lowercase()).collect(),
        memory: facts.memory.clone(),
        instances: facts.instances.clone(),
        pous,
        enums: pous.first().map(|pou| &pou.enums[..]).unwrap_or_default(),
        used: BTreeSet::new(),
        counters,
        called: BTreeSet::new(),
        active: Vec::new(),
        plain: BTreeSet::new(),
        differs: Vec::new(),
    }
}

/// A piece of the file, line by line, as code.
pub(super) fn original(text: &str) -> Vec<String> {
    let text = text.trim().trim_start_matches(":=").trim_start();
    text.lines().map(|line| format!("    {}", line.trim())).collect()
}

/// What is said in front of a program, without what `cargo grafcet export` says of it.
fn about(pou: &Pou) -> Vec<String> {
    let own = |line: &&String| line.contains("Written by cargo grafcet.");
    let end = pou.notes.iter().position(|line| own(&line)).unwrap_or(pou.notes.len());
    pou.notes[..end].iter().map(|line| line.trim().to_owned()).filter(|line| !line.is_empty()).collect()
}

pub(super) fn docs(lines: &mut Vec<String>, said: &[String], mark: &str) {
    lines.extend(said.iter().map(|line| format!("{mark} {line}").trim_end().to_owned()));
}

/// By transition, in Rust; what has no translation is a function that has to be written.
fn conditions(pou: &Pou, scope: &mut Scope<'_>, notes: &mut Vec<Wrong>, functions: &mut Vec<String>) -> Vec<String> {
    let mut done = Vec::new();
    for transition in &pou.transitions {
        scope.active.clone_from(&transition.from);
        let text = &transition.condition;
        let rust = match &text.language {
            Some(language) => Err(format!("it is written in {language}")),
            None => {
                expression(text).map_err(|wrong| wrong.message).and_then(|expr| scope.rust(&expr, Some(Kind::Bool)))
            }
        };
        for message in std::mem::take(&mut scope.differs) {
            notes.push(Wrong { at: text.at.clone(), message });
        }
        done.push(rust.unwrap_or_else(|why| {
            let (from, to) = (transition.from.join("_"), transition.to.join("_"));
            let name = scope.names.value(&format!("{from}_to_{to}"));
            scope.names.renamed.pop();
            let message = format!("`{name}` is a function to be written in Rust: {why}");
            notes.push(Wrong { at: text.at.clone(), message });
            let mut lines = vec![format!("/// To be written: the condition from {from} to {to}, which was")];
            docs(&mut lines, &original(&text.text), "///");
            lines.push(format!("fn {name}() -> bool {{\n    todo!(\"the condition from {from} to {to}\")\n}}"));
            functions.push(lines.join("\n"));
            format!("{name}()")
        }));
    }
    done
}

/// Functions of the file that conditions call.
fn called(scope: &Scope<'_>) -> Vec<String> {
    let functions = scope.pous.iter().filter(|pou| scope.called.contains(&pou.name.to_lowercase()));
    let one = |pou: &Pou| {
        let inputs = pou.variables.iter().filter(|variable| variable.section == Section::Input);
        let mut names = Names::new();
        let inputs: Vec<String> = inputs
            .map(|input| {
                format!(
                    "_{}: {}",
                    names.value(&input.name),
                    outside(scope, &input.ty).unwrap_or_else(|| "()".to_owned())
                )
            })
            .collect();
        let returns = pou.returns.as_deref().and_then(|ty| outside(scope, ty)).unwrap_or_else(|| "bool".to_owned());
        let name = scope.names.get(&pou.name).unwrap_or_default();
        let mut lines = vec![format!("/// To be written: the function `{}`, which was", pou.name)];
        docs(&mut lines, &original(&pou.body), "///");
        lines.push(format!(
            "fn {name}({}) -> {returns} {{\n    todo!(\"the function {}\")\n}}",
            inputs.join(", "),
            pou.name
        ));
        lines.join("\n")
    };
    functions.map(one).collect()
}

/// A type as a function outside of the chart has it.
fn outside(scope: &Scope<'_>, ty: &str) -> Option<String> {
    Some(match scope.kind_of(ty)? {
        Kind::Time => "grafcet::Ticks".to_owned(),
        kind => scope.type_of(kind),
    })
}

/// The longest time that a step may take.
fn longest(step: &Step, scope: &mut Scope<'_>, notes: &mut Vec<Wrong>) -> Option<String> {
    let text = step.within.as_ref()?;
    let time = expression(text).map_err(|wrong| wrong.message);
    let time = time.and_then(|time| scope.rust(&time, Some(Kind::Time)));
    let wrong = |why| {
        let message = format!("left out: that `{}` takes {} at most: {why}", step.name, text.text);
        notes.push(Wrong { at: text.at.clone(), message });
    };
    time.map_err(wrong).ok()
}

fn steps(pou: &Pou, scope: &Scope<'_>, (bodies, within): (&[Vec<String>], &[Option<String>]), lines: &mut Vec<String>) {
    for (index, (step, body)) in pou.steps.iter().zip(bodies).enumerate() {
        if !step.note.is_empty() {
            docs(lines, std::slice::from_ref(&step.note), "        ///");
        }
        let leaves = pou.transitions.iter().any(|transition| transition.from.iter().any(|from| same(from, &step.name)));
        let word = match (step.initial, leaves) {
            (true, true) => "initial step",
            (true, false) => "initial final step",
            (false, true) => "step",
            (false, false) => "final step",
        };
        let name = scope.names.get_step(&step.name).unwrap_or_default();
        let one = body.join(" ");
        let name = within
            .get(index)
            .and_then(|within| within.as_ref())
            .map_or_else(|| name.to_owned(), |within| format!("{name} within {within}"));
        if body.is_empty() {
            lines.push(format!("        {word} {name};"));
        } else if one.len() < 70
            && !one.contains("{ ")
            && !body.iter().any(|line| line == "}" || line.starts_with("//"))
        {
            lines.push(format!("        {word} {name} {{ {one} }}"));
        } else {
            lines.push(format!("        {word} {name} {{"));
            lines.extend(body.iter().map(|line| format!("            {line}")));
            lines.push("        }".to_owned());
        }
    }
}

/// Transitions as people draw them: on from where the last one has led, branches in the order of their priority.
fn chains(pou: &Pou, scope: &Scope<'_>, conditions: &[String], lines: &mut Vec<String>) {
    let mut order: Vec<usize> = (0..pou.transitions.len()).collect();
    order.sort_by_key(|index| pou.transitions[*index].priority.unwrap_or(u64::MAX));
    let mut left: Vec<bool> = vec![true; order.len()];
    let step = |name: &String| pou.steps.iter().position(|step| same(&step.name, name)).unwrap_or_default();
    let set = |names: &[String]| names.iter().map(step).collect::<BTreeSet<usize>>();
    let begins =
        |steps: &BTreeSet<usize>| steps.iter().next().map_or((true, 0), |first| (!pou.steps[*first].initial, *first));
    let next = |from: &BTreeSet<usize>, left: &[bool]| {
        order.iter().copied().find(|index| left[*index] && set(&pou.transitions[*index].from) == *from)
    };
    loop {
        let rest = order.iter().copied().filter(|index| left[*index]);
        let Some(first) = rest.min_by_key(|index| begins(&set(&pou.transitions[*index].from))) else { return };
        let mut at = set(&pou.transitions[first].from);
        let mut parts: Vec<String> = vec![named(scope, &pou.transitions[first].from)];
        while let Some(index) = next(&at, &left) {
            let transition = &pou.transitions[index];
            // What is said of a transition stands above it.
            if !transition.note.is_empty() && parts.len() > 1 {
                break;
            }
            left[index] = false;
            if !transition.note.is_empty() {
                lines.push(format!("        // {}", transition.note));
            }
            let label = label(transition);
            parts.push(format!("-[{label}{}]-> {}", conditions[index], named(scope, &transition.to)));
            at = set(&transition.to);
        }
        wrapped(&parts, lines);
    }
}

/// The name of a transition that has one.
fn label(transition: &Transition) -> String {
    transition.name.as_ref().map(|name| format!("{}: ", Names::new().value(name))).unwrap_or_default()
}

fn named(scope: &Scope<'_>, steps: &[String]) -> String {
    let names: Vec<&str> = steps.iter().map(|step| scope.names.get_step(step).unwrap_or_default()).collect();
    if let [one] = names[..] { one.to_owned() } else { format!("({})", names.join(", ")) }
}

fn wrapped(parts: &[String], lines: &mut Vec<String>) {
    let mut line = String::from("       ");
    for (index, part) in parts.iter().enumerate() {
        if index > 1 && line.len() + part.len() > WIDTH {
            lines.push(line);
            line = String::from("           ");
        }
        line.push(' ');
        line.push_str(part);
    }
    lines.push(format!("{line};"));
}

/// The whole file.
pub(super) fn file(from: &str, charts: &[Chart], sources: &[Source]) -> String {
    let mut lines = vec![format!("// Imported from {} by cargo grafcet.", one_line(from))];
    for chart in charts {
        if !chart.renamed.is_empty() {
            lines.push("//".to_owned());
            lines.push(format!("// Renamed in {}:", chart.name));
            lines.extend(chart.renamed.iter().map(|(there, here)| format!("//   {there} is {here}")));
        }
        if !chart.notes.is_empty() {
            lines.push("//".to_owned());
            lines.push(format!("// To be looked at in {}:", chart.name));
            lines.extend(chart.notes.iter().map(|note| format!("//   {}", one_line(&note.message))));
        }
    }
    lines.extend([String::new(), "use grafcet::grafcet;".to_owned()]);
    let enums: BTreeMap<&usize, &Vec<String>> = sources.iter().flat_map(|source| &source.enums).collect();
    for one in enums.into_values() {
        lines.push(String::new());
        lines.extend(one.iter().cloned());
    }
    let mut functions = BTreeSet::new();
    for source in sources {
        lines.extend([String::new(), "grafcet! {".to_owned()]);
        lines.extend(source.chart.iter().cloned());
        lines.push("}".to_owned());
        functions.extend(source.functions.iter().cloned());
    }
    for function in functions {
        lines.extend([String::new(), function]);
    }
    lines.push(String::new());
    lines.join("\n")
}

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
