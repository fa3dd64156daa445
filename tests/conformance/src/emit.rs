//! The Rust that makes a chart a [`Subject`](crate::Subject): the macro call, and a shim that knows its types.

use std::fmt::Write as _;

use grafcet_compiler::model::{Model, Ty};
use proc_macro2::Ident;

use super::{chart, fragments};

/// The macro that users call.
pub const MACRO: &str = "grafcet::grafcet";

/// The items of a module for one chart that a macro makes: its type is `Compiled`.
///
/// # Errors
/// What the compiler says about the chart.
pub fn module(text: &str, by: &str) -> Result<String, String> {
    let model = chart::resolve(text)?;
    let macro_call = fragments::call(text, by);
    let name = &model.name;
    let inputs: String = model.inputs.values().map(|i| take(&i.name, "inputs")).collect();
    let outputs: Vec<_> = model.outputs.values().map(|o| o.name.to_string()).collect();
    let outputs: String = outputs.iter().map(|o| format!("(\"{}\", number(o.{o})), ", plain(o))).collect();
    let (calls, no_calls) =
        if model.actions.is_empty() { (String::new(), "()") } else { (noted(&model), "Calls::default()") };
    let late = if model.steps.values().any(|step| step.late.is_some()) { "chart.late_steps()" } else { "[]" };
    let called = if model.actions.is_empty() { "Vec::new()" } else { "calls.0" };
    let (declare, params) = params(&model);
    // What is printed from programs cannot be forced.
    let force = if model.forceable && by == MACRO { force(name, &inputs, no_calls, called) } else { String::new() };
    Ok(format!(
        "use grafcet_conformance::generated::*;
{macro_call}
{calls}
pub(super) struct Compiled {{ chart: {name}, shown: Shown, {declare} }}
fn shown(chart: &{name}, o: &{name}Outputs, calls: Vec<String>) -> Shown {{
    let _ = o;
    Shown {{ steps: steps(chart, &chart.active_steps()), stable: chart.is_stable(), outputs: outputs([{outputs}], late(chart, {late})), calls }}
}}
impl Default for Compiled {{
    fn default() -> Self {{
        let chart = {name}::new();
        let shown = shown(&chart, &Default::default(), Vec::new());
        Self {{ chart, shown {} }}
    }}
}}
impl Subject for Compiled {{
    fn cycle(&mut self, inputs: &Values, now: u32) -> Result<Shown, String> {{
        let _ = inputs;
        let inputs = {name}Inputs {{ {inputs} }};
        #[allow(unused_mut)]
        let mut calls = {no_calls};
        let outputs = Chart::scan(&mut self.chart, &inputs, Ticks::new(now), &mut calls);
        self.shown = shown(&self.chart, &outputs, Vec::new());
        Ok(Shown {{ calls: {called}, ..self.shown.clone() }})
    }}
    {force}
    fn init(&mut self) -> Result<(), String> {{
        self.chart.init();
        self.shown = shown(&self.chart, &Default::default(), Vec::new());
        Ok(())
    }}
    fn set_params(&mut self, changed: &Values) -> Result<(), String> {{
        let _ = changed;
        {params}
        Ok(())
    }}
    fn shown(&self) -> Shown {{ self.shown.clone() }}
    fn next_deadline(&self) -> Option<u32> {{ self.chart.next_deadline().map(Ticks::get) }}
}}
",
        if declare.is_empty() { "" } else { ", params: Default::default()" }
    ))
}

/// The method of the shim that forces the chart.
fn force(name: &Ident, inputs: &str, no_calls: &str, called: &str) -> String {
    format!(
        "fn force(&mut self, steps: &BTreeSet<String>, inputs: &Values, now: u32) -> Result<Option<Shown>, String> {{
        let _ = inputs;
        let inputs = {name}Inputs {{ {inputs} }};
        #[allow(unused_mut)]
        let mut calls = {no_calls};
        let steps = named(&self.chart, steps);
        let before = format!(\"{{:?}}\", self.chart);
        let Ok(outputs) = Forceable::force(&mut self.chart, &steps, &inputs, Ticks::new(now), &mut calls) else {{
            assert_eq!(before, format!(\"{{:?}}\", self.chart), \"refused, and something happened\");
            return Ok(None);
        }};
        self.shown = shown(&self.chart, &outputs, Vec::new());
        Ok(Some(Shown {{ calls: {called}, ..self.shown.clone() }}))
    }}"
    )
}

/// `on: take(inputs, "on"), `
pub(crate) fn take(name: &Ident, from: &str) -> String {
    format!("{name}: take({from}, \"{}\"), ", plain(&name.to_string()))
}

pub(crate) fn plain(name: &str) -> &str {
    name.trim_start_matches("r#")
}

/// The code actions, writing down every call.
fn noted(model: &Model) -> String {
    actions(model, "Calls", "Vec<String>", |name, args| {
        format!("self.0.push(call(phase, \"{}\", &[{args}]));", plain(name))
    })
}

/// A type that carries out the code actions: what it holds, and what a call does, by the action's name and its arguments as numbers.
pub(crate) fn actions(model: &Model, by: &str, holds: &str, does: impl Fn(&str, &str) -> String) -> String {
    let mut methods = String::new();
    for action in model.actions.values() {
        let params = action.params.iter().map(|(name, ty)| format!(", {name}: {}", rust(ty)));
        let args = action.params.iter().map(|(name, _)| format!("number({name}), "));
        let (params, args, name) = (params.collect::<String>(), args.collect::<String>(), action.name.to_string());
        let body = does(&name, &args);
        _ = writeln!(methods, "    fn {name}(&mut self, phase: Phase{params}) {{ {body} }}");
    }
    format!("#[derive(Default)] struct {by}({holds});\nimpl {}Actions for {by} {{\n{methods}}}", model.name)
}

/// What stands after an exchange of the recipe: a chart with ranges may refuse it.
pub(crate) fn taken<'o>(model: &Model, or: &'o str) -> &'o str {
    if model.params.values().any(|param| param.range.is_some()) { or } else { "" }
}

/// The field with the recipe, and how it is exchanged.
fn params(model: &Model) -> (String, String) {
    if model.params.is_empty() {
        return (String::new(), String::new());
    }
    let names = model.params.values().map(|param| param.name.to_string());
    let set = names.map(|name| format!("replace(changed, \"{}\", &mut self.params.{name});\n        ", plain(&name)));
    let set = set.collect::<String>()
        + "self.chart.set_params(self.params)"
        + taken(model, ".map_err(|error| error.to_string())?")
        + ";";
    (format!("params: {}Params", model.name), set)
}

pub(crate) fn rust(ty: &Ty) -> String {
    match ty {
        Ty::Time(_) => "Ticks".to_owned(),
        Ty::Bool(ty) | Ty::Int { rust: ty, .. } | Ty::Other(ty) => quote::quote!(#ty).to_string(),
    }
}
