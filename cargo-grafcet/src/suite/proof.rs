//! What the search has left open, asked of the prover: a way, or a proof that there is none.

use std::collections::{BTreeMap, BTreeSet};
use std::time::{Duration, Instant};

use grafcet_compiler::analysis::Facts;
use grafcet_compiler::model::{
    Binary, Claim, Dialect, Effect, Expr, Model, Name, Place, Property, Read, StepId, TransitionId, Tree, Ty, Var,
};
use grafcet_compiler::program::counted;
use grafcet_prove::circuit::Circuit;
use grafcet_prove::replay::Shown;
use grafcet_prove::{Limit, Verdict, decide};
use grafcet_sim::interp::Value as Inner;
use grafcet_sim::{Beside, Kind, Value};

use super::goals::Goal;

/// Charts of more steps make circuits that take longer than the search.
const MOST_STEPS: usize = 150;

/// What the prover says of a goal.
pub(crate) enum Told {
    /// It cannot be: a proof, which has been checked.
    Never,
    /// Cycles with their times and inputs, that lead to it or near to it.
    Way(Vec<(u32, Vec<Value>)>),
}

/// What is asked for a goal.
struct Question {
    goal: Goal,
    /// The number of the property.
    property: usize,
}

/// Asks for each goal, all together for `limit` at most; of what is not said the prover knows nothing.
pub(crate) fn ask(
    model: Option<Model>,
    beside: &Beside<'_>,
    open: &BTreeSet<Goal>,
    limit: Duration,
) -> BTreeMap<Goal, Vec<Told>> {
    let mut told: BTreeMap<Goal, Vec<Told>> = BTreeMap::new();
    let Some(mut model) = model.filter(|model| model.steps.len() <= MOST_STEPS && !limit.is_zero()) else {
        return told;
    };
    let end = Instant::now() + limit;
    let questions = questions(&mut model, open);
    // What has no circuit is not asked.
    let Ok(program) = counted(&model, &Facts::of(&model)) else { return told };
    let Ok(circuit) = Circuit::of(&program) else { return told };
    for (number, question) in questions.iter().enumerate() {
        let left = end.saturating_duration_since(Instant::now());
        let others = u32::try_from(questions.len() - number).unwrap_or(u32::MAX);
        let Some(bad) = circuit.bad.iter().find(|bad| bad.property == question.property) else { continue };
        if left.is_zero()
            || told.get(&question.goal).is_some_and(|all| all.iter().any(|one| matches!(one, Told::Never)))
        {
            continue;
        }
        // What takes no time leaves its share to the others.
        let said = match decide(&program, &circuit, *bad, &Limit::time(left / others)) {
            Ok(Verdict::Proved(_)) => Told::Never,
            Ok(Verdict::Violated(way)) => match cycles(&way, beside) {
                Some(way) => Told::Way(way),
                None => continue,
            },
            _ => continue,
        };
        told.entry(question.goal).or_default().push(said);
    }
    told
}

/// Properties of the model that are broken where a goal is shown, or never where it cannot be.
fn questions(model: &mut Model, open: &BTreeSet<Goal>) -> Vec<Question> {
    let drawn: Vec<TransitionId> = model.drawn_transitions().map(|(id, _)| id).collect();
    let mut questions = Vec::new();
    for goal in open {
        let all = match *goal {
            Goal::Cleared(one) if model.dialect == Dialect::Grafcet => vec![Some(cleared(model, drawn[one]))],
            Goal::Cleared(one) => {
                // One evolution a cycle: it begins where the last cycle has ended, and what it enters is active in the end.
                let (from, to) = (sources(model, drawn[one]), model.transitions[drawn[one]].targets.clone());
                vec![all_of(&to), from]
            }
            // It waits from the end of a cycle on.
            Goal::Waited(one) => vec![sources(model, drawn[one])],
            Goal::Pair(..) => continue,
        };
        for (tree, reads) in all.into_iter().flatten() {
            let mark = model.transitions[drawn[0]].mark;
            let tokens = syn::parse_quote!(true);
            let never = Expr { tree, tokens, reads, text: "what is asked".to_owned(), mark };
            model.properties.push(Property { claim: Claim::Never(never), levels: Vec::new(), mark });
            questions.push(Question { goal: *goal, property: model.properties.len() - 1 });
        }
    }
    questions
}

/// An expression, with all that it reads.
type Asked = (Tree, Vec<Read>);

/// A variable that the transition sets as it clears.
fn cleared(model: &mut Model, id: TransitionId) -> Asked {
    let mark = model.transitions[id].mark;
    let constant = |value: bool| {
        let tokens = if value { syn::parse_quote!(true) } else { syn::parse_quote!(false) };
        Expr { tree: Tree::Bool(value), tokens, reads: Vec::new(), text: value.to_string(), mark }
    };
    let name = quote::format_ident!("has_cleared_{}", model.vars.len());
    let var = Var {
        name,
        attrs: Vec::new(),
        levels: Vec::new(),
        ty: Ty::Bool(syn::parse_quote!(bool)),
        init: Some(constant(false)),
    };
    let var = model.vars.push(var);
    model.transitions[id].clearing.push(Effect::Assign(Place::Var(var), constant(true)));
    let read = Read::Name(Name::Var(var));
    (Tree::Read(read), vec![read])
}

/// All steps before a transition, or one of those that an `any` leaves; none for a source transition, which waits for nothing.
fn sources(model: &Model, id: TransitionId) -> Option<Asked> {
    let transition = &model.transitions[id];
    match transition.any {
        Some(any) => joined(&model.anys[any].sources, Binary::Or),
        None => all_of(&transition.sources),
    }
}

fn all_of(steps: &[StepId]) -> Option<Asked> {
    joined(steps, Binary::And)
}

fn joined(steps: &[StepId], by: Binary) -> Option<Asked> {
    let reads: Vec<Read> = steps.iter().map(|step| Read::Active(*step)).collect();
    let trees = reads.iter().map(|read| Tree::Read(*read));
    let tree = trees.reduce(|a, b| Tree::Binary(by, Box::new(a), Box::new(b)))?;
    Some((tree, reads))
}

/// With the values as a session has them; none where one has no value there.
fn cycles(way: &[Shown], beside: &Beside<'_>) -> Option<Vec<(u32, Vec<Value>)>> {
    let mut first = beside.first();
    let outside = first.split_off(beside.inputs());
    let (own, asked) = beside.signals().split_at(beside.inputs());
    let cycle = |shown: &Shown| {
        let values = own.iter().zip(&shown.inputs).map(|(signal, value)| given(&signal.kind, *value));
        let answers = asked.iter().zip(&outside).map(|(signal, usual)| {
            let told = shown.told.iter().find(|(text, _)| *text == signal.name);
            told.map_or_else(|| Some(usual.clone()), |(_, value)| given(&signal.kind, *value))
        });
        Some((shown.now, values.chain(answers).collect::<Option<Vec<Value>>>()?))
    };
    way.iter().map(cycle).collect()
}

fn given(kind: &Kind, value: Inner) -> Option<Value> {
    match (kind, value) {
        (Kind::Listed(_, list), Inner::Int(place)) => {
            Some(Value::Name(list.get(usize::try_from(place).ok()?)?.clone()))
        }
        (_, Inner::Bool(value)) => Some(Value::Bool(value)),
        (_, Inner::Int(value)) => Some(Value::Int(value)),
        (_, Inner::Ticks(ticks)) => Some(Value::Ticks(ticks)),
        _ => None,
    }
}

/// The goals of which a proof says that they cannot be; with them the pairs of which one cannot.
pub(crate) fn impossible(told: &BTreeMap<Goal, Vec<Told>>, open: &BTreeMap<Goal, String>) -> BTreeSet<Goal> {
    let is_never = |goal: &Goal| told.get(goal).is_some_and(|all| all.iter().any(|one| matches!(one, Told::Never)));
    let cannot = |goal: &Goal| match *goal {
        Goal::Pair(first, second) => is_never(&Goal::Cleared(first)) || is_never(&Goal::Cleared(second)),
        _ => is_never(goal),
    };
    open.keys().filter(|goal| cannot(goal)).copied().collect()
}
