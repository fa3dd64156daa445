//! The structure of a chart as a Mermaid flowchart, for pages that render it themselves.

use std::fmt::Write as _;

use grafcet_core::description::{Description, Let, Step};

use crate::sorted::List;
use crate::wording::{any_text, assigned};

/// The text of a Mermaid diagram: steps are boxes with their actions, initial ones with a double frame, and transitions are
/// arrows with their conditions; where parallel branches begin or end, a transition is a node of its own. What an `any` leaves
/// is a rounded box, and what named conditions stand for is a flag by itself.
#[must_use]
pub fn mermaid(chart: &Description<'_>) -> String {
    let mut out = String::from("flowchart TD\n");
    let named = |partial: usize| chart.partials.get(partial).map_or("", |partial| partial.name);
    for partial in 0..chart.partials.len() {
        let name = named(partial);
        if !name.is_empty() {
            let _ = writeln!(out, "    subgraph p{partial}[\"{}\"]", escape(name));
        }
        let steps = chart.steps.iter().enumerate().filter(|(_, step)| step.partial == partial);
        for (id, step) in steps {
            let (open, close) = if step.initial { ("[[", "]]") } else { ("[", "]") };
            let _ = writeln!(out, "    s{id}{open}\"{}\"{close}", label(step));
        }
        if !name.is_empty() {
            out.push_str("    end\n");
        }
    }
    for (id, transition) in chart.transitions.iter().enumerate() {
        let mut text = transition.condition.to_owned();
        if !transition.name.is_empty() {
            text = format!("{}: {text}", transition.name);
        }
        let text = escape(&text);
        if let Some(any) = &transition.any {
            let _ = writeln!(out, "    a{id}([\"{}\"])", escape(&any_text(any)));
            if let [to] = transition.targets {
                let _ = writeln!(out, "    a{id} -->|\"{text}\"| s{to}");
                continue;
            }
        }
        if let ([from], [to]) = (transition.sources, transition.targets) {
            let _ = writeln!(out, "    s{from} -->|\"{text}\"| s{to}");
            continue;
        }
        let _ = writeln!(out, "    t{id}{{{{\"{text}\"}}}}");
        if transition.any.is_some() {
            let _ = writeln!(out, "    a{id} --> t{id}");
        }
        for from in transition.sources {
            let _ = writeln!(out, "    s{from} --> t{id}");
        }
        for to in transition.targets {
            let _ = writeln!(out, "    t{id} --> s{to}");
        }
    }
    if !chart.lets.is_empty() {
        let lines = chart.lets.iter().map(stands_for).list();
        let _ = writeln!(out, "    names>\"{}\"]", lines.join("<br>"));
    }
    out
}

/// `go = auto || rising(next)`, with what is said of it.
fn stands_for(named: &Let<'_>) -> String {
    let mut text = escape(&format!("{} = {}", named.name, named.text));
    if !named.doc.is_empty() {
        let _ = write!(text, "<br>{}", escape(named.doc));
    }
    text
}

fn label(step: &Step<'_>) -> String {
    let mut text = escape(step.name);
    for action in step.actions {
        let words = [action.qualifier, action.time, &assigned(action.text)].map(escape);
        let words = words.iter().map(String::as_str).filter(|word| !word.is_empty()).list();
        text.push_str("<br>");
        text.push_str(&words.join(" "));
        if !action.condition.is_empty() {
            let _ = write!(text, " if {}", escape(action.condition));
        }
    }
    if !step.within.is_empty() {
        let _ = write!(text, "<br>within {}", escape(step.within));
    }
    for force in step.forces {
        let _ = write!(text, "<br>force {}", escape(force));
    }
    text
}

/// Mermaid's own entities: `#quot;`.
fn escape(text: &str) -> String {
    let mut escaped = String::new();
    for c in text.chars() {
        match c {
            '"' => escaped.push_str("#quot;"),
            '#' => escaped.push_str("#35;"),
            '<' => escaped.push_str("#lt;"),
            '>' => escaped.push_str("#gt;"),
            '&' => escaped.push_str("#amp;"),
            '|' => escaped.push_str("#124;"),
            c if c.is_control() => escaped.push(' '),
            c => escaped.push(c),
        }
    }
    escaped
}
