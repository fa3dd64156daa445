//! Conditions as boolean functions over their atoms.
//!
//! An atom is a boolean name, a step variable, an edge, a delay, or any Rust that is not looked into, which is equal
//! only to its own text. Comparisons of one integer expression with constants are related to each other: they become
//! one variable that says in which interval between the constants the value lies.

use std::collections::BTreeMap;

use crate::model::{Binary, Expr, Model, Name, Read, Tree, Ty, Unary};

/// Decides questions about conditions of one chart.
pub struct Logic<'m> {
    model: &'m Model,
}

/// How many assignments are tried before a question counts as undecided.
const BUDGET: u32 = 20_000;

/// A boolean function over numbered variables.
enum Function {
    Const(bool),
    /// The variable takes one of the marked values.
    Leaf {
        variable: usize,
        values: Vec<bool>,
    },
    Not(Box<Function>),
    And(Box<Function>, Box<Function>),
    Or(Box<Function>, Box<Function>),
    Same(Box<Function>, Box<Function>),
}

impl<'m> Logic<'m> {
    /// About the conditions of `model`.
    #[must_use]
    pub fn new(model: &'m Model) -> Self {
        Self { model }
    }

    /// Whether two conditions never hold together; `false` where that cannot be shown.
    #[must_use]
    pub fn exclusive(&self, a: &Tree, b: &Tree) -> bool {
        let mut atoms = Atoms::default();
        self.collect(a, &mut atoms);
        self.collect(b, &mut atoms);
        let both = Function::And(Box::new(self.function(a, &atoms)), Box::new(self.function(b, &atoms)));
        Self::unsatisfiable(&both, &atoms)
    }

    /// Whether two conditions always hold together; `false` where that cannot be shown.
    #[must_use]
    pub fn equivalent(&self, a: &Tree, b: &Tree) -> bool {
        let not = |tree: &Tree| Tree::Unary(Unary::Not, Box::new(tree.clone()));
        self.exclusive(a, &not(b)) && self.exclusive(&not(a), b)
    }

    /// Whether a condition can never hold; `false` where that cannot be shown.
    #[must_use]
    pub fn never(&self, condition: &Expr) -> bool {
        let mut atoms = Atoms::default();
        self.collect(&condition.tree, &mut atoms);
        Self::unsatisfiable(&self.function(&condition.tree, &atoms), &atoms)
    }

    fn unsatisfiable(function: &Function, atoms: &Atoms) -> bool {
        let mut search = Satisfy { sizes: atoms.sizes(), values: vec![None; atoms.variables.len()], budget: BUDGET };
        search.possible(function, 0) == Some(false)
    }

    /// Registers the atoms of a condition.
    fn collect(&self, tree: &Tree, atoms: &mut Atoms) {
        match tree {
            Tree::Bool(_) => {}
            Tree::Unary(Unary::Not, inner) => self.collect(inner, atoms),
            Tree::Read(Read::Rising(id) | Read::Falling(id)) => {
                atoms.boolean(tree);
                self.collect(&self.model.edges[*id].of.tree, atoms);
            }
            Tree::Binary(operator, a, b) if self.is_connective(*operator, a, b) => {
                self.collect(a, atoms);
                self.collect(b, atoms);
            }
            Tree::Binary(operator, a, b) => match comparison(*operator, a, b) {
                Some((value, _, constant)) => atoms.thresholds(value).push(constant),
                None => atoms.boolean(tree),
            },
            other => atoms.boolean(other),
        }
    }

    fn function(&self, tree: &Tree, atoms: &Atoms) -> Function {
        match tree {
            Tree::Bool(value) => Function::Const(*value),
            Tree::Unary(Unary::Not, inner) => Function::Not(Box::new(self.function(inner, atoms))),
            // On a rising edge of `e`, `e` is true; on a falling one it is false.
            Tree::Read(Read::Rising(id)) => {
                let of = self.function(&self.model.edges[*id].of.tree, atoms);
                Function::And(Box::new(atoms.leaf(tree)), Box::new(of))
            }
            Tree::Read(Read::Falling(id)) => {
                let of = self.function(&self.model.edges[*id].of.tree, atoms);
                Function::And(Box::new(atoms.leaf(tree)), Box::new(Function::Not(Box::new(of))))
            }
            Tree::Binary(operator, a, b) if self.is_connective(*operator, a, b) => {
                let (a, b) = (Box::new(self.function(a, atoms)), Box::new(self.function(b, atoms)));
                match operator {
                    Binary::And | Binary::BitAnd => Function::And(a, b),
                    Binary::Or | Binary::BitOr => Function::Or(a, b),
                    Binary::Eq => Function::Same(a, b),
                    _ => Function::Not(Box::new(Function::Same(a, b))),
                }
            }
            Tree::Binary(operator, a, b) => match comparison(*operator, a, b) {
                Some((value, operator, constant)) => atoms.interval(value, operator, constant),
                None => atoms.leaf(tree),
            },
            other => atoms.leaf(other),
        }
    }

    /// `&&` and `||` are; `&`, `|`, `^`, `==`, `!=` are where both sides are boolean.
    fn is_connective(&self, operator: Binary, a: &Tree, b: &Tree) -> bool {
        match operator {
            Binary::And | Binary::Or => true,
            Binary::BitAnd | Binary::BitOr | Binary::BitXor | Binary::Eq | Binary::Ne => {
                self.is_boolean(a) && self.is_boolean(b)
            }
            _ => false,
        }
    }

    fn is_boolean(&self, tree: &Tree) -> bool {
        match tree {
            Tree::Bool(_) | Tree::Elapsed(..) | Tree::MacroElapsed(..) => true,
            Tree::Read(read) => match read {
                Read::Name(Name::Input(id)) => matches!(self.model.inputs[*id].ty, Ty::Bool(_)),
                Read::Name(Name::Output(id)) => matches!(self.model.outputs[*id].ty, Ty::Bool(_)),
                Read::Name(Name::Var(id)) => matches!(self.model.vars[*id].ty, Ty::Bool(_)),
                Read::Name(Name::Param(id)) => matches!(self.model.params[*id].ty, Ty::Bool(_)),
                Read::Since(_) | Read::MacroSince(_) | Read::Ticks(_) => false,
                _ => true,
            },
            Tree::Unary(operator, inner) => *operator == Unary::Not && self.is_boolean(inner),
            Tree::Binary(operator, a, b) => match operator {
                Binary::And
                | Binary::Or
                | Binary::Eq
                | Binary::Ne
                | Binary::Lt
                | Binary::Le
                | Binary::Gt
                | Binary::Ge => true,
                Binary::BitAnd | Binary::BitOr | Binary::BitXor => self.is_boolean(a) && self.is_boolean(b),
                _ => false,
            },
            Tree::Int(_) | Tree::Opaque { .. } => false,
        }
    }
}

/// `value < constant`, whichever side the constant stands on.
fn comparison<'t>(operator: Binary, a: &'t Tree, b: &'t Tree) -> Option<(&'t Tree, Binary, i128)> {
    let flipped = match operator {
        Binary::Eq | Binary::Ne => operator,
        Binary::Lt => Binary::Gt,
        Binary::Le => Binary::Ge,
        Binary::Gt => Binary::Lt,
        Binary::Ge => Binary::Le,
        _ => return None,
    };
    match (constant(a), constant(b)) {
        (None, Some(value)) => Some((a, operator, value)),
        (Some(value), None) => Some((b, flipped, value)),
        _ => None,
    }
}

fn constant(tree: &Tree) -> Option<i128> {
    match tree {
        Tree::Int(value) => Some(*value),
        Tree::Read(Read::Ticks(ticks)) => Some(i128::from(*ticks)),
        _ => None,
    }
}

/// The variables of a question.
#[derive(Default)]
struct Atoms {
    /// The number of a variable and the constants its value is compared with; a boolean has none.
    variables: BTreeMap<Tree, (usize, Vec<i128>)>,
}

impl Atoms {
    fn boolean(&mut self, tree: &Tree) {
        self.thresholds(tree);
    }

    fn thresholds(&mut self, tree: &Tree) -> &mut Vec<i128> {
        let next = self.variables.len();
        &mut self.variables.entry(tree.clone()).or_insert((next, Vec::new())).1
    }

    fn leaf(&self, tree: &Tree) -> Function {
        match self.variables.get(tree) {
            Some((variable, _)) => Function::Leaf { variable: *variable, values: vec![false, true] },
            None => Function::Const(true),
        }
    }

    /// The intervals in which the comparison holds.
    fn interval(&self, tree: &Tree, operator: Binary, constant: i128) -> Function {
        let Some((variable, thresholds)) = self.variables.get(tree) else { return self.leaf(tree) };
        let values = samples(thresholds)
            .into_iter()
            .map(|sample| {
                let order = sample.cmp(&(constant, 0));
                match operator {
                    Binary::Eq => order.is_eq(),
                    Binary::Ne => order.is_ne(),
                    Binary::Lt => order.is_lt(),
                    Binary::Le => order.is_le(),
                    Binary::Gt => order.is_gt(),
                    _ => order.is_ge(),
                }
            })
            .collect();
        Function::Leaf { variable: *variable, values }
    }

    fn sizes(&self) -> Vec<usize> {
        let mut sizes = vec![2; self.variables.len()];
        for (variable, thresholds) in self.variables.values() {
            sizes[*variable] = samples(thresholds).len().max(2);
        }
        sizes
    }
}

/// One representative of each interval: below, at and between the constants (`(3, 1)` lies just above 3). Where no
/// integer lies between two constants, that interval is left out.
fn samples(thresholds: &[i128]) -> Vec<(i128, i8)> {
    let mut sorted = thresholds.to_vec();
    sorted.sort_unstable();
    sorted.dedup();
    let mut samples = Vec::new();
    for (i, constant) in sorted.iter().enumerate() {
        let gap = i == 0 || sorted[i - 1].checked_add(1) != Some(*constant);
        if gap {
            samples.push((*constant, -1));
        }
        samples.push((*constant, 0));
    }
    samples.extend(sorted.last().map(|last| (*last, 1)));
    samples
}

/// Backtracking over the variables, the function evaluated in three values.
struct Satisfy {
    sizes: Vec<usize>,
    values: Vec<Option<usize>>,
    budget: u32,
}

impl Satisfy {
    /// Whether some assignment makes the function true; `None` when the budget ran out.
    fn possible(&mut self, function: &Function, next: usize) -> Option<bool> {
        self.budget = self.budget.checked_sub(1)?;
        match self.evaluate(function) {
            Some(value) => return Some(value),
            None if next == self.sizes.len() => return Some(true),
            None => {}
        }
        for value in 0..self.sizes[next] {
            self.values[next] = Some(value);
            if self.possible(function, next + 1)? {
                return Some(true);
            }
        }
        self.values[next] = None;
        Some(false)
    }

    fn evaluate(&self, function: &Function) -> Option<bool> {
        match function {
            Function::Const(value) => Some(*value),
            Function::Leaf { variable, values } => {
                self.values[*variable].map(|value| values.get(value).copied().unwrap_or(false))
            }
            Function::Not(inner) => self.evaluate(inner).map(|value| !value),
            Function::And(a, b) => match (self.evaluate(a), self.evaluate(b)) {
                (Some(false), _) | (_, Some(false)) => Some(false),
                (Some(true), Some(true)) => Some(true),
                _ => None,
            },
            Function::Or(a, b) => match (self.evaluate(a), self.evaluate(b)) {
                (Some(true), _) | (_, Some(true)) => Some(true),
                (Some(false), Some(false)) => Some(false),
                _ => None,
            },
            Function::Same(a, b) => Some(self.evaluate(a)? == self.evaluate(b)?),
        }
    }
}
