//! From the model to a chart of the standard.

use std::collections::BTreeMap;

use grafcet_compiler::model::{Id, Model, StepId, TransitionId};
use syn::Attribute;

use super::actions::Actions;
use super::{Action, Block, Chart, Step, Transition, fits, order};
use crate::Refused;
use crate::st::expr::{At, Kind, Scope, Steps, plain};
use crate::st::frame::{self, Frame};
use crate::st::header;
use crate::st::names::Names;
use crate::st::syntax::{Program, Statement, Variable};
use crate::st::text::Text;

/// A chart of the standard, or all that it cannot say.
pub(crate) fn build(model: &Model) -> Result<Chart, Vec<Refused>> {
    let mut refused = fits::refused(model);
    if refused.is_empty() {
        refused.extend(order::refused(model));
    }
    if !refused.is_empty() {
        return Err(refused);
    }
    let mut scope = Scope::new(model, Names::new());
    let names = model.steps.values().map(|step| scope.names.of_step(&plain(&step.name))).collect();
    scope.steps = Some(Steps { names, active: Vec::new() });
    let chart = plain(&model.name);
    // A step may have the chart's name.
    let name = scope.names.own(&chart);
    let renamed = (name != chart).then(|| (chart, name.clone()));
    let transitions = transitions(model, &mut scope)?;
    let mut actions = Actions::new(model, &mut scope);
    actions.make()?;
    let (mut all, mut blocks, always) = (actions.all, actions.blocks, actions.always);
    let mut program = Program { name, ..Program::default() };
    let mut frame = Frame::default();
    frame::declare(&mut scope, &mut program, &mut frame, |_| false).map_err(|error| vec![error])?;
    for (instance, block) in scope.instances.values() {
        program.variables.push(Variable::new(instance, block));
    }
    let scan = each_scan(&mut scope, always, &mut program.variables, &mut blocks).map_err(|error| vec![error])?;
    let scans = scan.is_some();
    all.extend(scan);
    let each_scan = all.last().filter(|_| scans).map(|action| (action.name.clone(), scope.names.own("Scan")));
    describe(model, &mut program);
    Ok(Chart {
        header: header(model, &scope, renamed.as_ref()),
        name: program.name,
        steps: steps(model, &scope, blocks),
        transitions,
        actions: all,
        inputs: program.inputs,
        outputs: program.outputs,
        variables: program.variables,
        each_scan,
        functions: scope.stubs,
        renamed: renamed.into_iter().chain(scope.names.renamed).collect(),
    })
}

fn steps(model: &Model, scope: &Scope<'_>, blocks: Vec<Vec<Block>>) -> Vec<Step> {
    let names = scope.steps.iter().flat_map(|steps| &steps.names);
    let all = model.steps.values().zip(names).zip(blocks);
    all.map(|((step, name), blocks)| Step { name: name.clone(), initial: step.initial, note: doc(&step.attrs), blocks })
        .collect()
}

fn transitions(model: &Model, scope: &mut Scope<'_>) -> Result<Vec<Transition>, Vec<Refused>> {
    let (mut done, mut refused) = (Vec::new(), Vec::new());
    for (id, transition) in model.transitions.iter() {
        match condition(model, scope, id) {
            Err(error) => refused.push(error),
            Ok(condition) => done.push(Transition {
                priority: priority(model, id),
                from: transition.sources.iter().map(|step| step.index()).collect(),
                to: transition.targets.iter().map(|step| step.index()).collect(),
                condition,
            }),
        }
    }
    if refused.is_empty() { Ok(done) } else { Err(refused) }
}

fn condition(model: &Model, scope: &mut Scope<'_>, id: TransitionId) -> Result<String, Refused> {
    let transition = &model.transitions[id];
    let names = scope.steps.as_mut().map(|steps| {
        steps.active.clone_from(&transition.sources);
        steps.names.clone()
    });
    let names = names.unwrap_or_default();
    let active = |step: StepId| Some(Text::word(format!("{}.X", names[step.index()])));
    let at = At { active: &active, before: &BTreeMap::new(), times: true, mark: transition.mark };
    Ok(scope.expr(&transition.condition, &Kind::Bool, &at)?.text)
}

/// Its place among those that leave the same steps; none where it is alone.
fn priority(model: &Model, id: TransitionId) -> Option<usize> {
    let first = model.transitions[id].sources.first()?;
    let all = &model.leaving[first.index()];
    let place = all.iter().position(|other| *other == id)?;
    (all.len() > 1).then_some(place + 1)
}

/// What is done in each scan, by an action that the initial step sets and nothing resets: what depends on conditions and values, and after it what edges compare with in the next
/// one, whose transitions come first.
fn each_scan(
    scope: &mut Scope<'_>,
    mut body: Vec<Statement>,
    variables: &mut Vec<Variable>,
    blocks: &mut [Vec<Block>],
) -> Result<Option<Action>, Refused> {
    for (id, [_, _, was]) in scope.edges.clone() {
        let of = &scope.model.edges[id].of;
        let at = At { active: &|_| None, before: &BTreeMap::new(), times: false, mark: of.mark };
        let value = scope.expr(of, &Kind::Bool, &at)?;
        variables.push(Variable::new(&*was, "BOOL").init("FALSE").note(format!("{} in the scan before", of.text)));
        body.push(Statement::assign(was, value.text));
    }
    if body.is_empty() {
        return Ok(None);
    }
    let name = scope.names.own("Always");
    let initial = scope.model.steps.values().zip(blocks).find(|(step, _)| step.initial);
    if let Some((_, blocks)) = initial {
        blocks.push(Block { qualifier: "S", time: None, action: name.clone() });
    }
    Ok(Some(Action { name, body }))
}

/// What is said of inputs, parameters, outputs and variables.
fn describe(model: &Model, program: &mut Program) {
    let inputs = model.inputs.values().map(|input| &input.attrs);
    let inputs = inputs.chain(model.params.values().map(|param| &param.attrs));
    let outputs = model.outputs.values().map(|output| &output.attrs);
    let vars = model.vars.values().map(|var| &var.attrs);
    let lists = [&mut program.inputs, &mut program.outputs, &mut program.variables];
    let docs: [Vec<String>; 3] = [
        inputs.map(|attrs| doc(attrs)).collect(),
        outputs.map(|attrs| doc(attrs)).collect(),
        vars.map(|attrs| doc(attrs)).collect(),
    ];
    for (variables, docs) in lists.into_iter().zip(docs) {
        for (variable, doc) in variables.iter_mut().zip(docs) {
            let both: Vec<String> = [variable.note.clone(), doc].into_iter().filter(|text| !text.is_empty()).collect();
            variable.note = both.join(": ");
        }
    }
}

/// A doc comment on one line.
fn doc(attrs: &[Attribute]) -> String {
    let lines = attrs.iter().filter(|attr| attr.path().is_ident("doc")).filter_map(|attr| {
        let syn::Meta::NameValue(named) = &attr.meta else { return None };
        let syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) = &named.value else { return None };
        Some(text.value())
    });
    lines.collect::<Vec<_>>().join(" ").split_whitespace().collect::<Vec<_>>().join(" ")
}

fn header(model: &Model, scope: &Scope<'_>, chart: Option<&(String, String)>) -> Vec<String> {
    let mut lines = vec![
        format!("The chart `{}` (sfc) as SFC of IEC 61131-3. Written by cargo grafcet.", plain(&model.name)),
        "One scan is one cycle of the chart: the transitions are evaluated on the situation of the scan before, in the order of their priorities, then the actions run.".to_owned(),
        "What runs under N, P, L or D runs once more when it ends (final call); the standard lets a PLC leave that out, as Beremiz does. P1 and P0 run once.".to_owned(),
        "What is left to the PLC: in its first scan the chart evaluates no transition, and a step that is left and entered in one scan begins anew.".to_owned(),
    ];
    let about = doc(&model.attrs);
    if !about.is_empty() {
        lines.insert(0, about);
    }
    lines.extend(chart.map(|(chart, name)| format!("Renamed: the chart `{chart}` is {name}.")));
    header::own_names(scope, &mut lines);
    if let Some(late) = header::supervised(model) {
        lines.push(header::left_out(&late));
    }
    lines
}
