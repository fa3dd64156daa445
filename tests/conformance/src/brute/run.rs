//! One random chart after the other.

use grafcet_compiler::model::{Binary, Id, Model, Name, Read, StepId, Tree, Ty, Unary};

use super::compare::{Comparison, Difference, compare};
use super::graph::Graph;
use super::{claims, make, resolve, rules};
use crate::random::Rng;
use crate::simpler::simpler;

/// What came of one chart.
pub enum Outcome {
    /// A rule that cannot be allowed refuses it.
    Refused(String),
    /// It has more states than asked for.
    Large,
    /// Both looked at it.
    Compared(Comparison),
}

/// What is compared.
#[derive(Clone, Copy, Debug)]
pub struct Kind {
    /// The dialect.
    pub grafcet: bool,
    /// With times, of which brute force sees some behaviour only.
    pub timed: bool,
    /// The most cycles of brute force.
    pub cycles: usize,
}

/// Makes the chart of a number and compares it.
///
/// # Errors
/// The chart is not understood by the interpreter: a mistake of the generator.
pub fn number(number: u64, kind: Kind) -> Result<(String, Outcome), String> {
    let text = make::chart(number, kind.grafcet, kind.timed);
    let outcome = chart(&text, kind.cycles).map_err(|error| format!("{error}\n{text}"))?;
    Ok((text, outcome))
}

/// Compares one chart.
///
/// # Errors
/// The interpreter does not understand it.
pub fn chart(text: &str, cycles: usize) -> Result<Outcome, String> {
    let model = match resolve(text) {
        Ok(model) => model,
        Err(rule) if rule.contains("nothing is left") => return nothing_left(text, cycles),
        Err(rule) => return Ok(Outcome::Refused(rule)),
    };
    let Some(graph) = Graph::of(&model, cycles)? else { return Ok(Outcome::Large) };
    if graph.valuations.is_empty() {
        return Err("assumptions that exclude everything are not refused".to_owned());
    }
    let mut rng = Rng::new(0x9ab5);
    let watched: Vec<Tree> = (0..4).map(|_| property(&model, &mut rng, 2)).collect();
    let initial: Vec<StepId> = model.steps.iter().filter(|(_, step)| step.initial).map(|(id, _)| id).collect();
    let mut comparison = compare(&model, &graph, &watched, &initial)?;
    comparison.differences.extend(rules::check(&model, &graph, text, comparison.exact)?);
    claims::check(&model, &graph, text, &mut comparison)?;
    Ok(Outcome::Compared(comparison))
}

/// Assumptions that are refused because they exclude every input.
fn nothing_left(text: &str, cycles: usize) -> Result<Outcome, String> {
    let refused = Outcome::Refused("assumptions that exclude everything".to_owned());
    let Some(model) = super::look(text).0 else { return Ok(refused) };
    let Some(graph) = Graph::of(&model, cycles)? else { return Ok(refused) };
    if graph.valuations.is_empty() {
        return Ok(refused);
    }
    let difference =
        Difference { kind: "assumptions leave something".to_owned(), text: format!("{:?}", graph.valuations[0]) };
    Ok(Outcome::Compared(Comparison { differences: vec![difference], exact: true, claims: [0; 3], nested: [0; 2] }))
}

/// The smallest chart found with a difference of the same kind, and that difference.
#[must_use]
pub fn smallest(text: &str, difference: &Difference, cycles: usize) -> (String, Difference) {
    let mut best = (text.to_owned(), difference.clone());
    let same = |text: &str| match chart(text, cycles) {
        Ok(Outcome::Compared(comparison)) => {
            comparison.differences.into_iter().find(|other| other.kind == difference.kind)
        }
        _ => None,
    };
    loop {
        let shorter = simpler(&best.0).into_iter().filter(|text| text.len() < best.0.len());
        let found = shorter.map(|text| (same(&text), text)).find_map(|(found, text)| Some((text, found?)));
        match found {
            Some(found) => best = found,
            None => return best,
        }
    }
}

/// An expression over boolean inputs, outputs and steps.
fn property(model: &Model, rng: &mut Rng, depth: usize) -> Tree {
    if depth > 0 {
        let operator = *rng.pick(&[Binary::And, Binary::And, Binary::Or]);
        let (left, right) = (property(model, rng, depth - 1), property(model, rng, depth - 1));
        return Tree::Binary(operator, Box::new(left), Box::new(right));
    }
    let bools = |ty: &Ty| matches!(ty, Ty::Bool(_));
    let inputs = model.inputs.iter().filter(|(_, input)| bools(&input.ty)).map(|(id, _)| Name::Input(id));
    let outputs = model.outputs.iter().filter(|(_, output)| bools(&output.ty)).map(|(id, _)| Name::Output(id));
    let names: Vec<Name> = inputs.chain(outputs).collect();
    let leaf = match rng.maybe(&names) {
        Some(name) if rng.chance(40) => Read::Name(*name),
        _ => Read::Active(StepId::new(rng.below(model.steps.len()))),
    };
    let leaf = Tree::Read(leaf);
    if rng.chance(40) { Tree::Unary(Unary::Not, Box::new(leaf)) } else { leaf }
}
