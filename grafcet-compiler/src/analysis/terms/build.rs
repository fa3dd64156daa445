//! From the tree of an expression to terms.

use super::{ANY, Fit, Node, Operation, Span, Terms, What};
use crate::analysis::numbers;
use crate::model::{Binary, Computed, How, Integer, Model, Read, Tree, Ty, Unary};

/// The least and the greatest value of a type.
pub(super) fn limits(ty: Integer) -> Span {
    match (ty.signed, ty.bits) {
        (true, bits @ 1..=64) => (-(1 << (bits - 1)), (1 << (bits - 1)) - 1),
        (false, bits @ 1..=64) => (0, (1 << bits) - 1),
        _ => ANY,
    }
}

/// The values that a type has on every machine.
pub(super) fn usual(ty: Integer) -> Span {
    if ty.is_size { limits(Integer { bits: 32, ..ty }) } else { limits(ty) }
}

/// The type of an expression, where it is one of integers that can be seen.
pub(crate) fn integer(model: &Model, tree: &Tree) -> Option<Integer> {
    match tree {
        Tree::Read(Read::Name(name)) => match model.ty(*name) {
            Ty::Int { rust, .. } => Integer::of(rust),
            _ => None,
        },
        Tree::Unary(_, inner) => integer(model, inner),
        Tree::Binary(Binary::Shl | Binary::Shr, a, _) => integer(model, a),
        Tree::Binary(operator, a, b) if numbers::is_arithmetic(*operator) => {
            integer(model, a).or_else(|| integer(model, b))
        }
        Tree::Opaque { of: Some(computed), .. } => of_computed(model, computed),
        _ => None,
    }
}

fn of_computed(model: &Model, Computed { how, operands }: &Computed) -> Option<Integer> {
    let same = || operands.iter().find_map(|tree| integer(model, tree));
    match how {
        How::As(ty) => Some(*ty),
        How::Get => Some(TIME),
        How::UnsignedAbs | How::AbsDiff => Some(Integer { signed: false, ..same()? }),
        How::Pow => integer(model, operands.first()?),
        How::If => operands[1..].iter().find_map(|tree| integer(model, tree)),
        How::Other => None,
        _ => same(),
    }
}

/// What a time counts in.
const TIME: Integer = Integer { signed: false, bits: 32, is_size: false };

/// The greatest exponent that is multiplied out.
const EXPONENT: i128 = 8;

impl Terms {
    /// The number of an expression, whose type is `wanted` where it does not tell itself; as it was in the cycle before, if that
    /// is what is asked for.
    pub(in crate::analysis) fn add(
        &mut self,
        model: &Model,
        tree: &Tree,
        wanted: Option<Integer>,
        before: bool,
    ) -> usize {
        if let Tree::Int(value) = tree {
            return self.constant(*value);
        }
        if let Some(known) = self.of(tree, before) {
            return known;
        }
        let found = if tree.may_differ() { None } else { self.computed(model, tree, wanted, before) };
        let number = found.unwrap_or_else(|| self.leaf(model, tree, wanted));
        self.known.insert((tree.clone(), before), number);
        number
    }

    fn computed(&mut self, model: &Model, tree: &Tree, wanted: Option<Integer>, before: bool) -> Option<usize> {
        if let Some(value) = numbers::constant(tree) {
            return Some(self.constant(value));
        }
        if let (Tree::Binary(operator @ (Binary::Add | Binary::Sub), a, b), true) = (tree, is_time(model, tree)) {
            let [a, b] = [a, b].map(|tree| self.add(model, tree, Some(TIME), before));
            let operation = if *operator == Binary::Add { Operation::Add } else { Operation::Sub };
            return Some(self.fitting(operation, a, b, Fit::Saturating(TIME), TIME));
        }
        let ty = integer(model, tree).or(wanted).filter(|ty| ty.bits <= 64)?;
        match tree {
            Tree::Unary(operator, inner) => {
                let inner = self.add(model, inner, Some(ty), before);
                let (from, fit) = match operator {
                    Unary::Neg => (0, Fit::Checked(ty)),
                    Unary::Not => (if ty.signed { -1 } else { limits(ty).1 }, Fit::Wrapping(ty)),
                };
                // All bits of a `usize` are as many as the machine has.
                if *operator == Unary::Not && ty.is_size && !ty.signed {
                    return None;
                }
                let from = self.constant(from);
                Some(self.fitting(Operation::Sub, from, inner, fit, ty))
            }
            Tree::Binary(operator @ (Binary::Shl | Binary::Shr), a, by) => {
                // Where bits are pushed out nobody panics, but by how many must be known.
                let by = numbers::constant(by).filter(|by| (0..i128::from(usual_bits(ty))).contains(by))?;
                let (a, factor) = (self.add(model, a, Some(ty), before), self.constant(1 << by));
                Some(match operator {
                    Binary::Shl => self.fitting(Operation::Mul, a, factor, Fit::Wrapping(ty), ty),
                    _ => self.exact(Operation::DivEuclid, a, factor, ty),
                })
            }
            Tree::Binary(operator, a, b) => {
                let operation = operation(*operator)?;
                let [a, b] = [a, b].map(|tree| self.add(model, tree, Some(ty), before));
                Some(match operation {
                    Operation::And | Operation::Or | Operation::Xor | Operation::Rem => self.exact(operation, a, b, ty),
                    _ => self.fitting(operation, a, b, Fit::Checked(ty), ty),
                })
            }
            Tree::Opaque { of: Some(computed), .. } => self.called(model, computed, ty, before),
            _ => None,
        }
    }

    /// A cast, or a method.
    fn called(&mut self, model: &Model, computed: &Computed, ty: Integer, before: bool) -> Option<usize> {
        let Computed { how, operands } = computed;
        if matches!(how, How::If | How::Other) {
            return None;
        }
        let (first, second) = (operands.first()?, operands.get(1));
        if let How::As(_) = how {
            // What a literal is before it is cast nobody has to know.
            let of = self.add(model, first, integer(model, first), before);
            let known = integer(model, first).is_some() || numbers::constant(first).is_some() || is_bool(model, first);
            return known.then(|| self.fit(of, Fit::Wrapping(ty), ty));
        }
        if *how == How::Get {
            return Some(self.add(model, first, Some(TIME), before));
        }
        let own = operands.iter().find_map(|tree| integer(model, tree)).filter(|own| own.bits <= 64)?;
        let a = self.add(model, first, Some(own), before);
        if *how == How::Pow {
            let exponent = numbers::constant(second?).filter(|exponent| (1..=EXPONENT).contains(exponent))?;
            return Some(
                (1..exponent).fold(a, |power, _| self.fitting(Operation::Mul, power, a, Fit::Checked(ty), ty)),
            );
        }
        let zero = self.constant(0);
        let b = second.map(|tree| self.add(model, tree, Some(own), before));
        Some(match how {
            How::Wrapping(operator) => self.fitting(operation(*operator)?, a, b?, Fit::Wrapping(ty), ty),
            How::Saturating(operator) => self.fitting(operation(*operator)?, a, b?, Fit::Saturating(ty), ty),
            How::Min => self.exact(Operation::Min, a, b?, ty),
            How::Max => self.exact(Operation::Max, a, b?, ty),
            How::DivEuclid => self.fitting(Operation::DivEuclid, a, b?, Fit::Checked(ty), ty),
            How::RemEuclid => self.exact(Operation::RemEuclid, a, b?, ty),
            How::Clamp => {
                let (low, high) = (numbers::constant(second?)?, numbers::constant(operands.get(2)?)?);
                let ends = [self.constant(low), self.constant(high)];
                let above = self.exact(Operation::Max, a, ends[0], ty);
                (low <= high).then(|| self.exact(Operation::Min, above, ends[1], ty))?
            }
            How::Abs | How::UnsignedAbs => {
                let opposite = self.exact(Operation::Sub, zero, a, ty);
                self.fitting(Operation::Max, a, opposite, Fit::Checked(ty), ty)
            }
            How::AbsDiff => {
                let ways = [self.exact(Operation::Sub, a, b?, ty), self.exact(Operation::Sub, b?, a, ty)];
                self.fitting(Operation::Max, ways[0], ways[1], Fit::Checked(ty), ty)
            }
            How::Signum => {
                let ends = [self.constant(-1), self.constant(1)];
                let above = self.exact(Operation::Max, a, ends[0], ty);
                self.exact(Operation::Min, above, ends[1], ty)
            }
            How::As(_) | How::Get | How::Pow | How::If | How::Other => return None,
        })
    }

    fn leaf(&mut self, model: &Model, tree: &Tree, wanted: Option<Integer>) -> usize {
        let of_type = integer(model, tree).or(wanted).filter(|ty| ty.bits <= 64);
        let known = if is_bool(model, tree) { Some((0, 1)) } else { numbers::range(model, tree) };
        let (range, usual) = match (known, of_type) {
            (Some(known), Some(ty)) => (meet(known, limits(ty)), meet(known, usual(ty))),
            (Some(known), None) => (known, known),
            (None, Some(ty)) => (limits(ty), usual(ty)),
            (None, None) => (ANY, ANY),
        };
        self.push(What::Leaf, range, usual)
    }

    pub(super) fn constant(&mut self, value: i128) -> usize {
        if let Some(known) = self.constants.get(&value) {
            return *known;
        }
        let number = self.push(What::Constant, (value, value), (value, value));
        self.constants.insert(value, number);
        number
    }

    /// A result that always fits into its type, or is no result of Rust.
    fn exact(&mut self, operation: Operation, a: usize, b: usize, ty: Integer) -> usize {
        let span = match operation {
            Operation::And | Operation::Or | Operation::Xor => limits(ty),
            _ => ANY,
        };
        self.push(What::Exact(operation, a, b), span, span)
    }

    fn fitting(&mut self, operation: Operation, a: usize, b: usize, fit: Fit, ty: Integer) -> usize {
        let of = self.push(What::Exact(operation, a, b), ANY, ANY);
        self.fit(of, fit, ty)
    }

    fn fit(&mut self, of: usize, fit: Fit, ty: Integer) -> usize {
        self.push(What::Fit(of, fit), limits(ty), usual(ty))
    }

    fn push(&mut self, what: What, range: Span, usual: Span) -> usize {
        self.nodes.push(Node { what, range, usual });
        self.nodes.len() - 1
    }
}

pub(super) fn meet(a: Span, b: Span) -> Span {
    (a.0.max(b.0), a.1.min(b.1))
}

fn usual_bits(ty: Integer) -> u32 {
    if ty.is_size { 32 } else { ty.bits }
}

fn operation(operator: Binary) -> Option<Operation> {
    Some(match operator {
        Binary::Add => Operation::Add,
        Binary::Sub => Operation::Sub,
        Binary::Mul => Operation::Mul,
        Binary::Div => Operation::Div,
        Binary::Rem => Operation::Rem,
        Binary::BitAnd => Operation::And,
        Binary::BitOr => Operation::Or,
        Binary::BitXor => Operation::Xor,
        _ => return None,
    })
}

fn is_bool(model: &Model, tree: &Tree) -> bool {
    matches!(tree, Tree::Read(Read::Name(name)) if matches!(model.ty(*name), Ty::Bool(_)))
}

/// Whether it is a time, whose arithmetic stays at the ends.
fn is_time(model: &Model, tree: &Tree) -> bool {
    match tree {
        Tree::Read(Read::Since(_) | Read::MacroSince(_) | Read::Ticks(_)) => true,
        Tree::Read(Read::Name(name)) => model.is_time(*name),
        Tree::Binary(Binary::Add | Binary::Sub, a, b) => is_time(model, a) && is_time(model, b),
        _ => false,
    }
}
