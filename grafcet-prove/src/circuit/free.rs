//! Rust that is not looked into: its value is an input of the circuit, the same for the same text of the same values in one cycle.

use super::sym::{FreeId, Sym};
use super::{Lowering, Refused, Source, Wire};
use crate::aig::Lit;
use crate::bits::{self, Bits};

/// Where such a value comes from.
pub(super) enum Origin {
    Rust(String),
    /// One value or another.
    Choice(Lit, Sym, Sym),
}

impl Lowering<'_, '_> {
    /// The value of a text by what it reads; another one each time, where that can be.
    pub(super) fn free(&mut self, text: &str, reads: Vec<Sym>, again: bool) -> FreeId {
        let key = (text.to_owned(), reads);
        if let (false, Some(id)) = (again, self.by_text.get(&key)) {
            return *id;
        }
        self.origins.push(Origin::Rust(text.to_owned()));
        let id = self.origins.len() - 1;
        if !again {
            self.by_text.insert(key, id);
        }
        id
    }

    pub(super) fn choice(&mut self, condition: Lit, then: &Sym, otherwise: &Sym) -> FreeId {
        self.origins.push(Origin::Choice(condition, then.clone(), otherwise.clone()));
        self.origins.len() - 1
    }

    pub(super) fn free_bool(&mut self, id: FreeId) -> Result<Lit, Refused> {
        if let Some(Sym::Bool(lit)) = self.as_bool.get(&id) {
            return Ok(*lit);
        }
        let lit = match &self.origins[id] {
            Origin::Rust(text) => {
                let text = text.clone();
                self.wires(&text, 1)[0]
            }
            Origin::Choice(condition, then, otherwise) => {
                let (condition, then, otherwise) = (*condition, then.clone(), otherwise.clone());
                let (then, otherwise) = (self.bool(&then)?, self.bool(&otherwise)?);
                self.aig.mux(condition, then, otherwise)
            }
        };
        self.as_bool.insert(id, Sym::Bool(lit));
        Ok(lit)
    }

    /// The same as a number of so many bits.
    pub(super) fn free_bits(&mut self, id: FreeId, width: usize, signed: bool) -> Result<Bits, Refused> {
        if let Some(bits) = self.as_bits.get(&(id, width, signed)) {
            return Ok(bits.clone());
        }
        let bits = match &self.origins[id] {
            Origin::Rust(text) => {
                let text = text.clone();
                let wires = self.wires(&text, width);
                if signed { wires.into() } else { bits::unsigned(&wires) }
            }
            Origin::Choice(condition, then, otherwise) => {
                let (condition, then, otherwise) = (*condition, then.clone(), otherwise.clone());
                let (then, otherwise) = (self.part(then, width, signed)?, self.part(otherwise, width, signed)?);
                bits::mux(&mut self.aig, condition, &then, &otherwise)
            }
        };
        self.as_bits.insert((id, width, signed), bits.clone());
        Ok(bits)
    }

    fn part(&mut self, sym: Sym, width: usize, signed: bool) -> Result<Bits, Refused> {
        match sym {
            Sym::Int(bits, _) | Sym::Ticks(bits) => Ok(bits),
            Sym::Free(id) => self.free_bits(id, width, signed),
            _ => Err(Refused("a number that is none".to_owned())),
        }
    }

    fn wires(&mut self, text: &str, width: usize) -> Vec<Lit> {
        let bits: Vec<Lit> = (0..width).map(|_| self.aig.free()).collect();
        self.inputs.push(Wire { source: Source::Rust(text.to_owned()), bits: bits.clone() });
        bits
    }
}
