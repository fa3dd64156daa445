//! What a condition asks of steps.

use crate::list::List;
use crate::model::{Binary, Id, Model, Read, StepId, Tree, Unary};
use crate::sorted::Set;

/// So many alternatives of a condition are told apart.
const ALTERNATIVES: usize = 32;

/// One way for a condition to hold, as far as it is about steps.
#[derive(Clone, Default, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Demand {
    pub(super) active: Set<usize>,
    pub(super) inactive: Set<usize>,
}

/// The ways in which an expression can have this value, as far as it is about steps.
pub(super) fn holds(model: &Model, tree: &Tree, value: bool) -> Vec<Demand> {
    let anyhow = || vec![Demand::default()];
    let any_of = |steps: &[StepId], value: bool| -> Vec<Demand> {
        let steps = steps.iter().map(|step| step.index());
        if value {
            let one = |step| Demand { active: Set::from([step]), inactive: Set::new() };
            return steps.map(one).list();
        }
        vec![Demand { active: Set::new(), inactive: steps.collect() }]
    };
    match tree {
        Tree::Bool(constant) if *constant == value => anyhow(),
        Tree::Bool(_) => Vec::new(),
        Tree::Read(Read::Active(step)) => any_of(&[*step], value),
        Tree::Read(Read::MacroActive(id)) => any_of(&model.macros[*id].steps, value),
        Tree::Elapsed(_, step) if value => any_of(&[*step], true),
        Tree::MacroElapsed(_, id) if value => any_of(&model.macros[*id].steps, true),
        Tree::Read(Read::Blink(blink)) if value => holds(model, &Tree::Read(blink.of.active()), true),
        Tree::Read(Read::Rising(edge)) if value => holds(model, &model.edges[*edge].of.tree, true),
        Tree::Read(Read::Falling(edge)) if value => holds(model, &model.edges[*edge].of.tree, false),
        Tree::Unary(Unary::Not, inner) => holds(model, inner, !value),
        Tree::Binary(Binary::And | Binary::BitAnd, a, b) if value => {
            all(&holds(model, a, true), &holds(model, b, true))
        }
        Tree::Binary(Binary::And | Binary::BitAnd, a, b) => any(holds(model, a, false), holds(model, b, false)),
        Tree::Binary(Binary::Or | Binary::BitOr, a, b) if value => any(holds(model, a, true), holds(model, b, true)),
        Tree::Binary(Binary::Or | Binary::BitOr, a, b) => all(&holds(model, a, false), &holds(model, b, false)),
        _ => anyhow(),
    }
}

/// Either of two.
fn any(a: Vec<Demand>, b: Vec<Demand>) -> Vec<Demand> {
    let all: Set<Demand> = a.into_iter().and(b).collect();
    // Where one of them demands nothing, that is enough.
    let enough = all.len() > ALTERNATIVES || all.first() == Some(&Demand::default());
    if enough { vec![Demand::default()] } else { all.into_iter().list() }
}

/// Both of two.
fn all(a: &[Demand], b: &[Demand]) -> Vec<Demand> {
    if a.len() * b.len() > ALTERNATIVES {
        return a.to_vec();
    }
    let both = |one: &Demand, other: &Demand| Demand {
        active: one.active.iter().and(&other.active).copied().collect(),
        inactive: one.inactive.iter().and(&other.inactive).copied().collect(),
    };
    let mut found = Set::new();
    for one in a {
        found.extend(b.iter().map(|other| both(one, other)).filter(|way| way.active.is_disjoint(&way.inactive)));
    }
    found.into_iter().list()
}
