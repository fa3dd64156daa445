//! A trace as a page: the chart and its chronogram, with marks that move along the time.

use grafcet_compiler::describe::with_description;

use super::chronogram::{Paper, STYLE};
use super::escape;
use super::json::Json;
use crate::chart::Chart;
use crate::cycle::Cycle;
use crate::names::Signal;
use crate::trace::Trace;
use crate::value::Value;

/// A trace as a page that needs nothing else: the chart with marks on its active steps beside the chronogram. One drags along the time
/// or uses the keys, cycle by cycle or evolution by evolution, and reads what happened and what the chart waited for.
///
/// The trace is one of this chart.
#[must_use]
pub fn page(chart: &Chart, trace: &Trace) -> String {
    let picture = with_description(chart.model(), grafcet_draw::svg_live);
    let paper = Paper::of(trace);
    let chronogram = format!(
        "<svg id=\"chronogram\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"Chronogram\">{2}\
         <rect id=\"span\" y=\"24\" height=\"{3}\"/></svg>",
        paper.width,
        paper.height,
        paper.body,
        paper.height.saturating_sub(24)
    );
    let mut data = String::new();
    told(trace, &paper).write(&mut data);
    let warnings: Vec<String> =
        trace.warnings.iter().map(|text| format!("<p class=\"warning\" role=\"alert\">{}</p>", escape(text))).collect();
    let parts = [
        ("{{name}}", escape(&trace.names.chart)),
        ("{{warnings}}", warnings.concat()),
        ("{{style}}", include_str!("page.css").replace("{{chronogram}}", STYLE)),
        ("{{script}}", include_str!("page.js").to_owned()),
        ("{{last}}", trace.cycles.len().saturating_sub(1).to_string()),
        ("{{picture}}", picture),
        ("{{chronogram}}", chronogram),
        ("{{data}}", data),
    ];
    // Each place is filled once: what is put in is not looked at again.
    let mut rest = include_str!("page.html");
    let mut page = String::new();
    while let Some((at, (mark, text))) =
        parts.iter().filter_map(|part| Some((rest.find(part.0)?, part))).min_by_key(|found| found.0)
    {
        page.push_str(&rest[..at]);
        page.push_str(text);
        rest = &rest[at + mark.len()..];
    }
    page.push_str(rest);
    page
}

/// What the script of the page reads.
fn told(trace: &Trace, paper: &Paper) -> Json {
    let names = &trace.names;
    let signals = |signals: &[Signal]| Json::texts(signals.iter().map(|signal| signal.name.as_str()));
    let starts = paper.axis.starts.iter().chain([&paper.axis.end]);
    let time = |start: &u64| if paper.axis.is_time { paper.axis.label(trace, *start) } else { String::new() };
    let times = paper.axis.starts.iter().map(time);
    let cycles = trace.cycles.iter().zip(times).map(|(cycle, time)| of_cycle(trace, cycle, time));
    Json::Object(vec![
        ("steps", Json::texts(names.steps.iter().map(|step| step.name.as_str()))),
        ("transitions", Json::texts(names.transitions.iter().map(|transition| transition.name.as_str()))),
        ("inputs", signals(&names.inputs)),
        ("outputs", signals(&names.outputs)),
        ("variables", signals(&names.variables)),
        ("initial", Json::numbers(&trace.initial)),
        ("left", Json::number(paper.left)),
        ("length", Json::number(paper.length)),
        ("starts", Json::list(starts.map(Json::number))),
        ("entered", Json::list(trace.coverage.entered().iter().map(Json::number))),
        ("cleared", Json::list(trace.coverage.cleared().iter().map(Json::number))),
        ("cycles", Json::list(cycles)),
    ])
}

fn of_cycle(trace: &Trace, cycle: &Cycle, time: String) -> Json {
    let names = &trace.names;
    let values = |values: &[Value]| Json::list(values.iter().map(value));
    let evolutions = cycle.evolutions.iter().map(|evolution| {
        Json::Object(vec![
            ("cleared", Json::numbers(&evolution.cleared)),
            ("left", Json::numbers(&evolution.deactivated)),
            ("entered", Json::numbers(&evolution.activated)),
            ("steps", Json::numbers(&evolution.steps)),
        ])
    });
    let forced = cycle.forced.iter().map(|forced| {
        format!("{} forces {} {}", names.steps[forced.by].name, names.partials[forced.partial], forced.order)
    });
    let calls = cycle.calls.iter().map(|call| {
        let args: Vec<String> = call.args.iter().map(ToString::to_string).collect();
        format!("{}({}), {} call", call.action, args.join(", "), format!("{:?}", call.phase).to_lowercase())
    });
    let ran = cycle.ran.iter().map(|ran| format!("{}: {}", names.steps[ran.step].name, ran.text));
    let did: Vec<String> = forced.chain(calls).chain(ran).collect();
    let waiting: Vec<String> = cycle.blocked.to_string().lines().map(str::to_owned).collect();
    let gap = cycle.gap.as_ref().map_or_else(|| Json::Raw("null".to_owned()), |gap| Json::text(&gap.reason));
    Json::Object(vec![
        ("time", Json::Text(time)),
        ("steps", Json::numbers(&cycle.steps)),
        ("inputs", values(&cycle.inputs)),
        ("outputs", values(&cycle.outputs)),
        ("variables", values(&cycle.variables)),
        ("evolutions", Json::list(evolutions)),
        ("did", Json::texts(did.iter().map(String::as_str))),
        ("waits", Json::texts(waiting.iter().map(String::as_str))),
        ("stable", Json::Raw(cycle.is_stable.to_string())),
        ("gap", gap),
    ])
}

fn value(value: &Value) -> Json {
    match value {
        Value::Bool(value) => Json::Raw(value.to_string()),
        value => Json::text(value.to_string()),
    }
}
