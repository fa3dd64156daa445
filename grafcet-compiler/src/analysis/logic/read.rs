//! From the tree of a condition to a boolean function.

use super::atoms::{self, Atoms};
use super::formula::Formula;
use crate::analysis::differences::FAR;
use crate::analysis::numbers::{self, Sort, constant, float_constant};
use crate::model::{Binary, Model, Name, Read, TimeRef, Tree, Unary};

/// Reads conditions of one chart.
pub(super) struct Reader<'r> {
    pub(super) model: &'r Model,
    pub(super) atoms: &'r mut Atoms,
}

impl Reader<'_> {
    /// The function that a condition is.
    pub(super) fn formula(&mut self, tree: &Tree) -> Formula {
        match tree {
            Tree::Bool(value) => Formula::Const(*value),
            Tree::Unary(Unary::Not, inner) => self.formula(inner).not(),
            Tree::Elapsed(time, step) => self.elapsed(Read::Active(*step), Read::Since(*step), *time),
            Tree::MacroElapsed(time, id) => self.elapsed(Read::MacroActive(*id), Read::MacroSince(*id), *time),
            Tree::Binary(operator, a, b) if self.is_connective(*operator, a, b) => {
                let (a, b) = (self.formula(a), self.formula(b));
                match operator {
                    Binary::And | Binary::BitAnd => a.and(b),
                    Binary::Or | Binary::BitOr => a.or(b),
                    Binary::Eq => Formula::Same(Box::new(a), Box::new(b)),
                    _ => Formula::Same(Box::new(a), Box::new(b)).not(),
                }
            }
            Tree::Binary(operator, a, b) if operator.is_comparison() => self.compare(*operator, a, b),
            // When it does so is not known, but it only shines while its step is active.
            Tree::Read(Read::Blink(blink)) => self.read(blink.of.active()).and(self.read(Read::Blink(*blink))),
            other => Formula::is_true(self.atoms.boolean(other)),
        }
    }

    /// `Step.X && Step.T >= t`
    fn elapsed(&mut self, active: Read, since: Read, time: TimeRef) -> Formula {
        let elapsed = self.compare(Binary::Ge, &Tree::Read(since), &atoms::time_tree(time));
        self.read(active).and(elapsed)
    }

    pub(super) fn read(&mut self, read: Read) -> Formula {
        Formula::is_true(self.atoms.boolean(&Tree::Read(read)))
    }

    fn compare(&mut self, operator: Binary, a: &Tree, b: &Tree) -> Formula {
        match (a, b) {
            (a, Tree::Int(variant)) if self.model.variants_of_tree(a).is_some() => {
                return self.with_constant(operator, a, *variant);
            }
            (Tree::Int(variant), b) if self.model.variants_of_tree(b).is_some() => {
                return self.with_constant(operator, b, *variant);
            }
            _ => {}
        }
        let sort = numbers::common(self.model, a, b);
        let of = |tree: &Tree| match sort {
            Some(Sort::Float(float)) => float_constant(tree, float),
            _ => constant(tree),
        };
        match (of(a), of(b)) {
            (Some(a), Some(b)) => Formula::Const(holds(operator, a, b)),
            (None, Some(value)) if sort.is_some() => self.with_constant(operator, a, value),
            (Some(value), None) if sort.is_some() => self.with_constant(operator.mirrored(), b, value),
            _ => match sort {
                Some(sort) => self.with_another(operator, a, b, sort == Sort::Total),
                // What the comparisons of such a type have to do with each other is up to its author.
                None => Formula::is_true(self.atoms.boolean(&Tree::Binary(
                    operator,
                    Box::new(a.clone()),
                    Box::new(b.clone()),
                ))),
            },
        }
    }

    /// Comparisons of one number with constants are about the interval in which it lies.
    fn with_constant(&mut self, operator: Binary, value: &Tree, constant: i128) -> Formula {
        if constant.unsigned_abs() >= FAR.unsigned_abs() {
            return self.with_another(operator, value, &Tree::Int(constant), true);
        }
        let atom = self.atoms.number(self.model, value);
        let (low, high) = bounds(operator, constant);
        let leaf = Formula::Leaf { atom, low, high };
        if operator == Binary::Ne { leaf.not() } else { leaf }
    }

    /// Two values that are both unknown: less, equal or greater.
    fn with_another(&mut self, operator: Binary, a: &Tree, b: &Tree, total: bool) -> Formula {
        if a == b && total {
            return Formula::Const(holds(operator, 0, 0));
        }
        let (operator, a, b) = if a <= b { (operator, a, b) } else { (operator.mirrored(), b, a) };
        let atom = self.atoms.order(a, b, total);
        let (low, high) = match operator {
            Binary::Lt => (-1, -1),
            Binary::Le => (-1, 0),
            Binary::Gt => (1, 1),
            Binary::Ge => (0, 1),
            _ => (0, 0),
        };
        let leaf = Formula::Leaf { atom, low, high };
        if operator == Binary::Ne { leaf.not() } else { leaf }
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
            Tree::Bool(_) | Tree::Elapsed(..) | Tree::MacroElapsed(..) | Tree::Binary(Binary::And | Binary::Or, ..) => {
                true
            }
            Tree::Read(Read::Name(name)) => atoms::is_bool_name(self.model, *name),
            Tree::Read(read) => !matches!(read, Read::Since(_) | Read::MacroSince(_) | Read::Ticks(_)),
            Tree::Unary(operator, inner) => *operator == Unary::Not && self.is_boolean(inner),
            Tree::Binary(Binary::BitAnd | Binary::BitOr | Binary::BitXor, a, b) => {
                self.is_boolean(a) && self.is_boolean(b)
            }
            Tree::Binary(operator, ..) => operator.is_comparison(),
            Tree::Int(_) | Tree::Opaque { .. } => false,
        }
    }
}

/// Whether an edge or a delay of this looks at nothing that changes within a cycle.
pub(super) fn is_constant(tree: &Tree) -> bool {
    let mut constant = !tree.may_differ();
    tree.each_read(&mut |read| {
        constant &= matches!(read, Read::Name(Name::Input(_) | Name::Param(_)) | Read::Ticks(_));
    });
    constant
}

fn holds(operator: Binary, a: i128, b: i128) -> bool {
    match operator {
        Binary::Lt => a < b,
        Binary::Le => a <= b,
        Binary::Gt => a > b,
        Binary::Ge => a >= b,
        Binary::Ne => a != b,
        _ => a == b,
    }
}

/// Where `value operator constant` holds; for `!=`, where it does not.
fn bounds(operator: Binary, constant: i128) -> (i128, i128) {
    match operator {
        // `FAR` is where a type ends, so that nothing lies beyond it.
        Binary::Lt => (-FAR, constant.saturating_sub(1)),
        Binary::Le => (-FAR, constant),
        Binary::Gt => (constant.saturating_add(1), FAR),
        Binary::Ge => (constant, FAR),
        _ => (constant, constant),
    }
}
