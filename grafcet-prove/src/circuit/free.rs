//! Rust that is not looked into: its value is an input of the circuit, the same for the same text of the same values in one evaluation. A
//! constant has one value for ever.

use grafcet_compiler::model::Name;

use super::sym::{FreeId, Sym, Width};
use super::{Constant, Field, Latch, Lowering, Outside, Refused, Source, Wire};
use crate::aig::Lit;
use crate::bits::{self, Bits};

/// Where such a value comes from.
pub(super) enum Origin {
    /// What stands in the chart, which the program around it can be asked for.
    Text(String, Option<Vec<Name>>),
    /// `MOST`, `limits::MOST`
    Constant(String),
    /// What is made of such values, or written by a block: nobody can be asked.
    Made(String),
    /// One value or another.
    Choice(Lit, Sym, Sym),
}

/// What it is used as.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum As {
    Bool,
    Number {
        signed: bool,
    },
    /// In ticks of the clock.
    Time,
}

impl Lowering<'_, '_> {
    /// The value of a text by what it reads; another one each time, where that can be.
    pub(super) fn free(&mut self, origin: Origin, reads: Vec<Sym>, again: bool) -> FreeId {
        let (Origin::Text(text, _) | Origin::Constant(text) | Origin::Made(text)) = &origin else {
            self.origins.push(origin);
            return self.origins.len() - 1;
        };
        let key = (text.clone(), reads);
        if let (false, Some(id)) = (again, self.by_text.get(&key)) {
            return *id;
        }
        self.origins.push(origin);
        let id = self.origins.len() - 1;
        if !again {
            self.by_text.insert(key, id);
        }
        id
    }

    /// What an operator makes of values of which one is not known, and not even its type; an interpreter that is told the value computes it.
    pub(super) fn made(&mut self, operator: &str, operands: Vec<Sym>) -> Sym {
        for operand in &operands {
            let Sym::Free(id) = operand else { continue };
            if let Origin::Text(text, _) | Origin::Constant(text) = &self.origins[*id] {
                self.uncomputed.push(text.clone());
            }
        }
        Sym::Free(self.free(Origin::Made(operator.to_owned()), operands, false))
    }

    pub(super) fn free_bool(&mut self, id: FreeId) -> Result<Lit, Refused> {
        if let Some(Sym::Bool(lit)) = self.as_bool.get(&id) {
            return Ok(*lit);
        }
        let lit = match &self.origins[id] {
            Origin::Choice(condition, then, otherwise) => {
                let (condition, then, otherwise) = (*condition, then.clone(), otherwise.clone());
                let (then, otherwise) = (self.bool(&then)?, self.bool(&otherwise)?);
                self.aig.mux(condition, then, otherwise)
            }
            _ => self.wires(id, 1, As::Bool)[0],
        };
        self.as_bool.insert(id, Sym::Bool(lit));
        Ok(lit)
    }

    /// The same as a number of so many bits.
    pub(super) fn free_bits(&mut self, id: FreeId, width: usize, used: As) -> Result<Bits, Refused> {
        if let Some(bits) = self.as_bits.get(&(id, width, used)) {
            return Ok(bits.clone());
        }
        let bits = match &self.origins[id] {
            Origin::Choice(condition, then, otherwise) => {
                let (condition, then, otherwise) = (*condition, then.clone(), otherwise.clone());
                let (then, otherwise) = (self.part(then, width, used)?, self.part(otherwise, width, used)?);
                bits::mux(&mut self.aig, condition, &then, &otherwise)
            }
            _ => {
                let wires = self.wires(id, width, used);
                as_number(used, &wires)
            }
        };
        self.as_bits.insert((id, width, used), bits.clone());
        Ok(bits)
    }

    /// As what number it has been used already.
    pub(super) fn known_number(&self, id: FreeId) -> Option<Width> {
        let same = self.as_bits.range((id, 0, As::Bool)..(id + 1, 0, As::Bool));
        { same }.find_map(|((_, bits, used), _)| match used {
            As::Number { signed } => Some(Width { signed: *signed, bits: *bits }),
            As::Bool | As::Time => None,
        })
    }

    fn part(&mut self, sym: Sym, width: usize, used: As) -> Result<Bits, Refused> {
        match sym {
            Sym::Int(bits, _) | Sym::Ticks(bits) => Ok(bits),
            Sym::Free(id) => self.free_bits(id, width, used),
            _ => Err(Refused("a number that is none".to_owned())),
        }
    }

    /// Wires for a value that is no choice.
    fn wires(&mut self, id: FreeId, width: usize, used: As) -> Vec<Lit> {
        let bits: Vec<Lit> = (0..width).map(|_| self.aig.free()).collect();
        let (text, can_be_asked, of) = match &self.origins[id] {
            Origin::Constant(text) => {
                self.constants.push(Constant { text: text.clone(), used, bits: bits.clone() });
                return bits;
            }
            Origin::Text(text, of) => (text.clone(), !self.is_plant, of.clone()),
            Origin::Made(text) => (text.clone(), false, None),
            Origin::Choice(..) => (String::new(), false, None),
        };
        let source = Source::Rust(Outside { text, used, can_be_asked, of });
        self.inputs.push(Wire { source, bits: bits.clone() });
        bits
    }

    /// Latches that hold what the constants are, whatever that is.
    pub(super) fn keep_constants(&self, latches: &mut Vec<Latch>, fields: &mut Vec<Field>) {
        for constant in &self.constants {
            let (name, first, width) = (constant.text.clone(), latches.len(), constant.bits.len());
            let signed = constant.used == (As::Number { signed: true });
            fields.push(Field { place: None, plant: None, name, first, width, signed });
            latches.extend(constant.bits.iter().map(|bit| Latch { now: *bit, next: *bit, initial: None }));
        }
    }

    /// A text has two values in one cycle, as two calls of one function may: nobody can tell an interpreter which is which.
    pub(super) fn differing(&mut self) -> Lit {
        let mut all: Vec<(String, As, Vec<Lit>)> = Vec::new();
        for wire in &self.inputs {
            if let Source::Rust(Outside { text, used, can_be_asked: true, .. }) = &wire.source {
                all.push((text.clone(), *used, wire.bits.clone()));
            }
        }
        all.extend(self.constants.iter().map(|constant| (constant.text.clone(), constant.used, constant.bits.clone())));
        let mut differ = Lit::FALSE;
        for (index, (text, used, bits)) in all.iter().enumerate() {
            let Some((_, first, before)) = all[..index].iter().find(|(other, ..)| other == text) else { continue };
            if (*first == As::Bool) != (*used == As::Bool) {
                return Lit::TRUE;
            }
            let (before, bits) = (as_number(*first, before), as_number(*used, bits));
            let same = bits::equal(&mut self.aig, &before, &bits);
            differ = self.aig.or(differ, !same);
        }
        differ
    }
}

/// The number that wires are.
fn as_number(used: As, wires: &[Lit]) -> Bits {
    if used == (As::Number { signed: true }) { wires.into() } else { bits::unsigned(wires) }
}
