//! The user's expressions. Integers are computed exactly; a result that does not fit into its type goes on at the other end, and is noted.

use grafcet_compiler::model::{Binary, Computed, How, Integer, Name, Read, Tree, Unary};

use super::free::Origin;
use super::sym::{FreeId, Sym, Width};
use super::{Lowering, Refused};
use crate::aig::{Aig, Lit};
use crate::bits::{self, Bits};

type Reads = [(Read, Sym)];

/// The greatest exponent that is multiplied out, as in the compiler's own analysis.
const EXPONENT: i128 = 8;

impl Lowering<'_, '_> {
    pub(super) fn tree(&mut self, tree: &Tree, reads: &Reads) -> Result<Sym, Refused> {
        match tree {
            Tree::Bool(value) => Ok(Sym::bool(*value)),
            Tree::Int(value) => Ok(Sym::int(*value)),
            Tree::Read(read) => bound(*read, reads),
            Tree::Elapsed(time, step) => bound(Read::Elapsed(*time, *step), reads),
            Tree::MacroElapsed(time, id) => bound(Read::MacroElapsed(*time, *id), reads),
            Tree::Unary(operator, operand) => {
                let operand = self.tree(operand, reads)?;
                self.unary(*operator, &operand)
            }
            Tree::Binary(operator @ (Binary::And | Binary::Or), a, b) => {
                let a = self.tree(a, reads)?;
                let a = self.bool(&a)?;
                let path = self.path;
                self.path = self.aig.and(path, a.xor(*operator == Binary::Or));
                let b = self.tree(b, reads)?;
                let b = self.bool(&b)?;
                self.path = path;
                let both = if *operator == Binary::And { self.aig.and(a, b) } else { self.aig.or(a, b) };
                Ok(Sym::Bool(both))
            }
            Tree::Binary(operator, a, b) => {
                let (a, b) = (self.tree(a, reads)?, self.tree(b, reads)?);
                self.binary(*operator, &a, &b)
            }
            Tree::Opaque { text, reads: mentions, call, of, whole, open } => {
                if let Some(computed) = of {
                    if let Some(sym) = self.computed(computed, reads)? {
                        return Ok(sym);
                    }
                    if computed.how != How::Other {
                        self.uncomputed.push(text.clone());
                    }
                }
                let mut values = Vec::new();
                for read in mentions {
                    values.push(bound(*read, reads)?);
                }
                let origin = match (call, text.clone()) {
                    (Some(_), text) => Origin::Text(text, None),
                    // Of integers it is a method of Rust's own, which comes to one value alone.
                    (None, text) if *whole || !(values.is_empty() || *open || is_call(&text)) => Origin::Made(text),
                    (None, text) if !values.is_empty() => match names(mentions) {
                        Some(names) => Origin::Text(text, Some(names)),
                        None => Origin::Made(text),
                    },
                    (None, text) if is_constant(&text) => Origin::Constant(text),
                    (None, text) => Origin::Made(text),
                };
                Ok(Sym::Free(self.free(origin, values, call.is_some())))
            }
        }
    }

    fn unary(&mut self, operator: Unary, operand: &Sym) -> Result<Sym, Refused> {
        Ok(match (operator, operand) {
            (Unary::Not, Sym::Bool(lit)) => Sym::Bool(!*lit),
            (Unary::Not, Sym::Int(value, Some(width))) => {
                Sym::Int(bits::wrap(&bits::flip(value), width.signed, width.bits), Some(*width))
            }
            (Unary::Not, Sym::Int(value, None)) => Sym::Int(bits::flip(value), None),
            (Unary::Not, Sym::Free(id)) => Sym::Bool(!self.free_bool(*id)?),
            (Unary::Neg, Sym::Int(value, width)) => {
                let exact = bits::neg(&mut self.aig, value);
                self.fitted(&exact, *width)
            }
            (operator, Sym::Free(_)) => self.made(&format!("{operator:?}"), vec![operand.clone()]),
            _ => return Err(Refused(format!("{operator:?} of this"))),
        })
    }

    fn binary(&mut self, operator: Binary, a: &Sym, b: &Sym) -> Result<Sym, Refused> {
        match (a, b) {
            (Sym::Int(a, left), Sym::Int(b, right)) => self.integers(operator, a, b, *left, *right),
            (Sym::Int(_, Some(width)), Sym::Free(id)) if keeps_type(operator) => {
                let b = self.free_number(*id, *width)?;
                self.binary(operator, a, &b)
            }
            (Sym::Free(id), Sym::Int(_, Some(width))) if keeps_type(operator) => {
                let a = self.free_number(*id, *width)?;
                self.binary(operator, &a, b)
            }
            (Sym::Int(_, None), Sym::Free(id)) if operator.is_comparison() => {
                let b = self.some_number(*id)?;
                self.binary(operator, a, &b)
            }
            (Sym::Free(id), Sym::Int(_, None)) if operator.is_comparison() => {
                let a = self.some_number(*id)?;
                self.binary(operator, &a, b)
            }
            (Sym::Free(id), Sym::Free(other)) if operator.is_comparison() && id != other => {
                let width = self.known_number(*id).or_else(|| self.known_number(*other));
                let Some(width) = width else {
                    return Ok(self.made(&format!("{operator:?}"), vec![a.clone(), b.clone()]));
                };
                let (a, b) = (self.free_number(*id, width)?, self.free_number(*other, width)?);
                self.binary(operator, &a, &b)
            }
            (Sym::Bool(_), Sym::Free(id)) => {
                let b = Sym::Bool(self.free_bool(*id)?);
                self.binary(operator, a, &b)
            }
            (Sym::Free(id), Sym::Bool(_)) => {
                let a = Sym::Bool(self.free_bool(*id)?);
                self.binary(operator, &a, b)
            }
            (Sym::Free(_), _) | (_, Sym::Free(_)) => {
                Ok(self.made(&format!("{operator:?}"), vec![a.clone(), b.clone()]))
            }
            (Sym::Ticks(a), Sym::Ticks(b)) => match operator {
                Binary::Add => Ok(Sym::Ticks(self.add_times(a, b))),
                Binary::Sub => Ok(Sym::Ticks(self.sub_times(a, b))),
                _ => self.compared(operator, a, b),
            },
            (Sym::Bool(a), Sym::Bool(b)) => {
                let (a, b) = (*a, *b);
                Ok(Sym::Bool(match operator {
                    Binary::BitAnd => self.aig.and(a, b),
                    Binary::BitOr => self.aig.or(a, b),
                    Binary::BitXor | Binary::Ne => self.aig.xor(a, b),
                    Binary::Eq => self.aig.iff(a, b),
                    Binary::Lt => self.aig.and(!a, b),
                    Binary::Le => self.aig.or(!a, b),
                    Binary::Gt => self.aig.and(a, !b),
                    Binary::Ge => self.aig.or(a, !b),
                    _ => return Err(Refused(format!("{operator:?} of booleans"))),
                }))
            }
            _ => Err(Refused(format!("{operator:?} of different things"))),
        }
    }

    /// What is compared with a literal is an integer. Where nothing tells of which type, it is one of 64 bits: what any other one
    /// comes to, a number of these comes to, too.
    fn some_number(&mut self, id: FreeId) -> Result<Sym, Refused> {
        let width = self.known_number(id).unwrap_or(Width { signed: true, bits: 64 });
        self.free_number(id, width)
    }

    fn compared(&mut self, operator: Binary, a: &Bits, b: &Bits) -> Result<Sym, Refused> {
        Ok(Sym::Bool(match operator {
            Binary::Eq => bits::equal(&mut self.aig, a, b),
            Binary::Ne => !bits::equal(&mut self.aig, a, b),
            Binary::Lt => bits::less(&mut self.aig, a, b),
            Binary::Ge => !bits::less(&mut self.aig, a, b),
            Binary::Gt => bits::less(&mut self.aig, b, a),
            Binary::Le => !bits::less(&mut self.aig, b, a),
            _ => return Err(Refused(format!("{operator:?} is no comparison"))),
        }))
    }

    fn integers(
        &mut self,
        operator: Binary,
        a: &Bits,
        b: &Bits,
        left: Option<Width>,
        right: Option<Width>,
    ) -> Result<Sym, Refused> {
        let width = left.or(right);
        let exact = match operator {
            Binary::Add => bits::add(&mut self.aig, a, b),
            Binary::Sub => bits::sub(&mut self.aig, a, b),
            Binary::Mul => bits::mul(&mut self.aig, a, b),
            Binary::Div | Binary::Rem => return Ok(self.divided(operator, a, b, width)),
            Binary::BitAnd => bits::each(&mut self.aig, a, b, Aig::and),
            Binary::BitOr => bits::each(&mut self.aig, a, b, Aig::or),
            Binary::BitXor => bits::each(&mut self.aig, a, b, Aig::xor),
            Binary::Shl | Binary::Shr => return Ok(self.shifted(operator, a, b, left)),
            _ => return self.compared(operator, a, b),
        };
        Ok(self.fitted(&exact, width))
    }

    fn divided(&mut self, operator: Binary, a: &Bits, b: &Bits, width: Option<Width>) -> Sym {
        let zero = bits::equal(&mut self.aig, b, &bits::constant(0));
        self.note_panic(zero);
        let (quotient, rest) = bits::div_rem(&mut self.aig, a, b);
        if let Some(width) = width {
            // The lowest value by -1, which panics in every build, also for the remainder.
            let fits = bits::fits(&mut self.aig, &quotient, width.signed, width.bits);
            self.note_panic(!fits);
        }
        let result = if operator == Binary::Div { quotient } else { rest };
        match width {
            Some(width) => Sym::Int(bits::wrap(&result, width.signed, width.bits), Some(width)),
            None => Sym::Int(result, None),
        }
    }

    /// Bits shifted out are lost; too wide a shift is one of the lowest bits of its count where nothing panics.
    fn shifted(&mut self, operator: Binary, a: &Bits, b: &Bits, width: Option<Width>) -> Sym {
        let of = width.unwrap_or(Width { signed: true, bits: 32 });
        let most = bits::constant(i128::try_from(of.bits).unwrap_or(64));
        let (negative, less) = (bits::sign(b), bits::less(&mut self.aig, b, &most));
        let wide = self.aig.or(negative, !less);
        self.note_overflow(wide);
        let result = if operator == Binary::Shl {
            let moved = bits::shift_left(&mut self.aig, a, b, of.bits);
            bits::wrap(&moved, of.signed, of.bits)
        } else {
            bits::shift_right(&mut self.aig, a, b, of.bits)
        };
        Sym::Int(result, width)
    }

    /// One of two values, of which only one is evaluated.
    fn chosen(&mut self, (condition, then, otherwise): (&Tree, &Tree, &Tree), reads: &Reads) -> Result<Sym, Refused> {
        let condition = self.tree(condition, reads)?;
        let condition = self.bool(&condition)?;
        let path = self.path;
        self.path = self.aig.and(path, condition);
        let then = self.tree(then, reads)?;
        self.path = self.aig.and(path, !condition);
        let otherwise = self.tree(otherwise, reads)?;
        self.path = path;
        self.mux(condition, &then, &otherwise)
    }

    /// Methods and casts, as far as they are known.
    fn computed(&mut self, computed: &Computed, reads: &Reads) -> Result<Option<Sym>, Refused> {
        if let (How::If, [condition, then, otherwise]) = (computed.how, &computed.operands[..]) {
            return self.chosen((condition, then, otherwise), reads).map(Some);
        }
        let mut operands = Vec::new();
        for operand in &computed.operands {
            operands.push(self.tree(operand, reads)?);
        }
        if let (How::As(to), [Sym::Bool(lit)]) = (computed.how, &operands[..]) {
            return Ok(Some(Sym::Int(vec![*lit, Lit::FALSE].into(), width_of(to))));
        }
        if let (How::Get, [Sym::Ticks(ticks)]) = (computed.how, &operands[..]) {
            return Ok(Some(Sym::Int(ticks.clone(), Some(Width { signed: false, bits: 32 }))));
        }
        let mut numbers = Vec::new();
        for operand in &operands {
            let Sym::Int(bits, width) = operand else { return Ok(None) };
            numbers.push((bits.clone(), *width));
        }
        let Some(((a, left), rest)) = numbers.split_first() else { return Ok(None) };
        let width = left.or_else(|| rest.iter().find_map(|(_, width)| *width));
        let b = rest.first().map(|(bits, _)| bits.clone());
        Ok(match (computed.how, b, width) {
            (How::As(to), ..) => width_of(to).map(|to| Sym::Int(bits::wrap(a, to.signed, to.bits), Some(to))),
            (How::Wrapping(operator), Some(b), Some(width)) => self
                .exact(operator, a, &b)
                .map(|exact| Sym::Int(bits::wrap(&exact, width.signed, width.bits), Some(width))),
            (How::Saturating(operator), Some(b), Some(width)) => {
                let exact = self.exact(operator, a, &b);
                exact.map(|exact| Sym::Int(self.saturated(&exact, width), Some(width)))
            }
            (How::Min, Some(b), _) => Some(Sym::Int(self.lower(a, &b), width)),
            (How::Max, Some(b), _) => Some(Sym::Int(self.higher(a, &b), width)),
            (How::Clamp, Some(low), _) => {
                let Some((high, _)) = rest.get(1) else { return Ok(None) };
                let crossed = bits::less(&mut self.aig, high, &low);
                self.note_panic(crossed);
                let raised = self.higher(a, &low);
                Some(Sym::Int(self.lower(&raised, high), width))
            }
            (How::Abs, ..) => {
                let exact = self.magnitude(a);
                Some(self.fitted(&exact, width))
            }
            (How::UnsignedAbs, _, Some(width)) => {
                Some(Sym::Int(self.magnitude(a), Some(Width { signed: false, ..width })))
            }
            (How::AbsDiff, Some(b), Some(width)) => {
                let difference = bits::sub(&mut self.aig, a, &b);
                Some(Sym::Int(self.magnitude(&difference), Some(Width { signed: false, ..width })))
            }
            (How::DivEuclid | How::RemEuclid, Some(b), Some(width)) => Some(self.euclidean(computed.how, a, &b, width)),
            (How::Pow, Some(exponent), _) => {
                let Some(exponent) = bits::known(&exponent).filter(|exponent| (0..=EXPONENT).contains(exponent)) else {
                    return Ok(None);
                };
                let one = Sym::Int(bits::constant(1), width);
                let power = (0..exponent).try_fold(one, |power, _| self.binary(Binary::Mul, &power, &operands[0]));
                Some(power?)
            }
            (How::Signum, ..) => {
                let zero = bits::equal(&mut self.aig, a, &bits::constant(0));
                let one = bits::mux(&mut self.aig, bits::sign(a), &bits::constant(-1), &bits::constant(1));
                Some(Sym::Int(bits::mux(&mut self.aig, zero, &bits::constant(0), &one), width))
            }
            _ => None,
        })
    }

    /// The rest is never negative, and the quotient goes with it. As with `%`, the division has to fit.
    fn euclidean(&mut self, how: How, a: &Bits, b: &Bits, width: Width) -> Sym {
        let zero = bits::equal(&mut self.aig, b, &bits::constant(0));
        self.note_panic(zero);
        let (quotient, rest) = bits::div_rem(&mut self.aig, a, b);
        let (is_short, magnitude) = (bits::sign(&rest), self.magnitude(b));
        let lifted = bits::add(&mut self.aig, &rest, &magnitude);
        let one = bits::mux(&mut self.aig, bits::sign(b), &bits::constant(-1), &bits::constant(1));
        let lowered = bits::sub(&mut self.aig, &quotient, &one);
        let quotient = bits::mux(&mut self.aig, is_short, &lowered, &quotient);
        let fits = bits::fits(&mut self.aig, &quotient, width.signed, width.bits);
        self.note_panic(!fits);
        let rest = bits::mux(&mut self.aig, is_short, &lifted, &rest);
        let result = if how == How::DivEuclid { quotient } else { rest };
        Sym::Int(bits::wrap(&result, width.signed, width.bits), Some(width))
    }

    fn exact(&mut self, operator: Binary, a: &Bits, b: &Bits) -> Option<Bits> {
        match operator {
            Binary::Add => Some(bits::add(&mut self.aig, a, b)),
            Binary::Sub => Some(bits::sub(&mut self.aig, a, b)),
            Binary::Mul => Some(bits::mul(&mut self.aig, a, b)),
            _ => None,
        }
    }

    fn saturated(&mut self, exact: &Bits, width: Width) -> Bits {
        let magnitude = width.bits - usize::from(width.signed);
        let most = (1_i128 << magnitude) - 1;
        let least = if width.signed { -most - 1 } else { 0 };
        let raised = self.higher(exact, &bits::constant(least));
        let kept = self.lower(&raised, &bits::constant(most));
        bits::wrap(&kept, width.signed, width.bits)
    }

    fn lower(&mut self, a: &Bits, b: &Bits) -> Bits {
        let less = bits::less(&mut self.aig, a, b);
        bits::mux(&mut self.aig, less, a, b)
    }

    fn higher(&mut self, a: &Bits, b: &Bits) -> Bits {
        let less = bits::less(&mut self.aig, a, b);
        bits::mux(&mut self.aig, less, b, a)
    }

    fn magnitude(&mut self, a: &Bits) -> Bits {
        let minus = bits::neg(&mut self.aig, a);
        bits::mux(&mut self.aig, bits::sign(a), &minus, a)
    }
}

/// None where it reads anything else.
fn names(reads: &[Read]) -> Option<Vec<Name>> {
    let name = |read: &Read| if let Read::Name(name) = read { Some(*name) } else { None };
    reads.iter().map(name).collect()
}

/// `near(x)`, `sensors::near(x)`, which may be said to be pure; no arithmetic of the chart's own.
fn is_call(text: &str) -> bool {
    let is_path = |text: &str| text.chars().all(|c| c.is_alphanumeric() || "_: ".contains(c)) && !text.is_empty();
    text.ends_with(')') && text.split_once('(').is_some_and(|(path, _)| is_path(path) && !path.contains(' '))
}

/// `MOST`, `limits::MOST`: a path to what is written in capitals is a constant, and has one value for ever.
fn is_constant(text: &str) -> bool {
    let is_word = |word: &str| word.chars().all(|c| c.is_alphanumeric() || c == '_') && !word.is_empty();
    let last = text.rsplit("::").next().unwrap_or_default().trim();
    let capital = last.len() > 1 && last.starts_with(char::is_uppercase) && !last.contains(char::is_lowercase);
    capital && text.split("::").all(|word| is_word(word.trim()))
}

/// What meets an integer in it is one of the same type. Others may be multiplied with one, or divide it, as durations do; a shift has its own.
fn keeps_type(operator: Binary) -> bool {
    !matches!(operator, Binary::Mul | Binary::Div | Binary::Shl | Binary::Shr)
}

/// None of `usize`, whose limits are those of the machine.
fn width_of(integer: Integer) -> Option<Width> {
    (!integer.is_size && integer.bits <= 64).then_some(Width { signed: integer.signed, bits: integer.bits as usize })
}

fn bound(read: Read, reads: &Reads) -> Result<Sym, Refused> {
    let found = reads.iter().find(|(other, _)| *other == read);
    found.map(|(_, sym)| sym.clone()).ok_or_else(|| Refused(format!("{read:?}, which nothing is bound to")))
}
