//! The program around a chart on a way: what Rust that is not looked into comes to there, as the solver has chosen it.

use std::cell::RefCell;

use grafcet_compiler::model::Name;
use grafcet_sim::interp::{Value, World};

use crate::aig::Lit;
use crate::circuit::{As, Circuit, Outside, Source};
use crate::play::number;
use crate::task::Way;

/// On the whole way: what is computed of the same values is the same in all cycles.
#[derive(Default)]
pub(crate) struct Around {
    computed: RefCell<Vec<(String, Vec<Value>, Value)>>,
}

/// In one cycle.
pub(crate) struct Told<'a> {
    around: &'a Around,
    values: Vec<(&'a str, Value, Option<&'a [Name]>)>,
    asked: RefCell<Vec<(String, Value)>>,
}

impl Around {
    /// What the program says in a cycle of the way.
    pub(crate) fn in_cycle<'a>(&'a self, circuit: &'a Circuit, way: &Way, cycle: usize) -> Told<'a> {
        let on = &way.inputs[cycle];
        let mut values = Vec::new();
        for wire in &circuit.inputs {
            let Source::Rust(Outside { text, used, can_be_asked: true, of }) = &wire.source else { continue };
            let bits = wire.bits.iter().map(|bit| on.binary_search(&bit.node()).is_ok());
            values.push((&**text, value(*used, &bits.collect::<Vec<bool>>()), of.as_deref()));
        }
        for constant in &circuit.constants {
            let begins = |bit: &Lit| {
                let is_it = |latch: usize| circuit.latches[latch].now == *bit;
                way.initial.iter().any(|(latch, value)| *value && is_it(*latch))
            };
            let bits: Vec<bool> = constant.bits.iter().map(begins).collect();
            values.push((&*constant.text, value(constant.used, &bits), None));
        }
        Told { around: self, values, asked: RefCell::default() }
    }
}

fn value(used: As, bits: &[bool]) -> Value {
    match used {
        As::Bool => Value::Bool(bits.contains(&true)),
        As::Number { signed } => Value::Int(number(bits, signed)),
        As::Time => Value::Ticks(u32::try_from(number(bits, false)).unwrap_or(u32::MAX)),
    }
}

impl Told<'_> {
    /// What was asked for, each text once.
    pub(crate) fn asked(&self) -> Vec<(String, Value)> {
        self.asked.borrow().clone()
    }
}

impl World for Told<'_> {
    fn value(&self, text: &str, look: &dyn Fn(Name) -> Option<Value>) -> Option<Value> {
        let (_, value, of) = self.values.iter().find(|(known, ..)| *known == text)?;
        if let Some(names) = of {
            let of: Vec<Value> = names.iter().map(|name| look(*name)).collect::<Option<_>>()?;
            let mut computed = self.around.computed.borrow_mut();
            match computed.iter().find(|(known, values, _)| known == text && *values == of) {
                Some((.., before)) if before != value => return None,
                Some(_) => {}
                None => computed.push((text.to_owned(), of, *value)),
            }
        }
        let mut asked = self.asked.borrow_mut();
        if asked.iter().all(|(known, _)| known != text) {
            asked.push((text.to_owned(), *value));
        }
        Some(*value)
    }
}
