//! The Rust that makes a chart [`Recorded`](super::Recorded).

use crate::chart;
use crate::emit::{self, plain, take, taken};

/// What the module of a chart has beside what `emit` writes: its type is `Own`.
///
/// # Errors
/// What the compiler says about the chart.
pub fn module(text: &str) -> Result<String, String> {
    let model = chart::resolve(text)?;
    let name = &model.name;
    let inputs: String = model.inputs.values().map(|i| take(&i.name, "values")).collect();
    let silent = if model.actions.is_empty() {
        String::new()
    } else {
        emit::actions(&model, "Silent", "", |_, _| String::new())
    };
    let silently = if model.actions.is_empty() { "()" } else { "Silent::default()" };
    let (calls, called) = if model.actions.is_empty() { ("()", "Vec::new()") } else { ("Calls::default()", "calls.0") };
    let params: Vec<_> = model.params.values().map(|param| param.name.to_string()).collect();
    let replaced = params.iter().map(|name| format!("replace(recipe, \"{}\", &mut params.{name}); ", plain(name)));
    let set_params = match params[..] {
        [] => String::new(),
        _ => format!(
            "let mut params = {name}Params::default(); {}chart.set_params(params){};",
            replaced.collect::<String>(),
            taken(&model, ".expect(\"a recipe in its ranges\")")
        ),
    };
    Ok(format!(
        "struct Own;
{silent}
pub(super) const CHECKS: [grafcet_conformance::recorded::Check; 2] = grafcet_conformance::recorded::checks::<Own>();
pub(super) const SOAK: grafcet_conformance::recorded::Soak = grafcet_conformance::recorded::soak::<Own>;
impl grafcet_conformance::recorded::Recorded for Own {{
    type Chart = {name};
    fn make() -> {name} {{ {name}::new() }}
    fn inputs(values: &Values) -> {name}Inputs {{ {name}Inputs {{ {inputs} }} }}
    fn called(run: &mut dyn FnMut(&mut <{name} as Chart>::Actions<'_>)) -> Vec<String> {{
        let mut calls = {calls};
        run(&mut calls);
        {called}
    }}
    fn silently(run: &mut dyn FnMut(&mut <{name} as Chart>::Actions<'_>)) {{ run(&mut {silently}) }}
    fn shown(chart: &{name}, outputs: &{name}Outputs) -> Shown {{ shown(chart, outputs, Vec::new()) }}
    fn begun(chart: &{name}) -> Shown {{ shown(chart, &Default::default(), Vec::new()) }}
    fn set_params(chart: &mut {name}, recipe: &Values) {{ {set_params} }}
}}
"
    ))
}
