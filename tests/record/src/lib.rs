//! The charts of the examples, with what the flight recorder needs to know of them, and a storm of inputs.

#[path = "../../../examples/charts/branch_on_result.rs"]
pub mod branch_on_result;
#[path = "../../../examples/charts/cell.rs"]
pub mod cell;
#[path = "../../../examples/charts/controller.rs"]
pub mod controller;
#[path = "../../../examples/charts/line24v.rs"]
pub mod line24v;
#[path = "../../../examples/charts/motor.rs"]
pub mod motor;
#[path = "../../../examples/charts/pick_and_place.rs"]
pub mod pick_and_place;
#[path = "../../../examples/charts/recipe.rs"]
pub mod recipe;
#[path = "../../../examples/charts/script.rs"]
pub mod script;
#[path = "../../../examples/charts/stroke.rs"]
pub mod stroke;
#[path = "../../../examples/charts/tickless.rs"]
pub mod tickless;

pub mod fram;
pub mod fuzz;
pub mod mixed;
pub mod wrong;

/// The page of the manual.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/record.md")]
struct Page;

use controller::{CalledActions, Message, RemoteActions};
use grafcet::record::{Reader, Record};
use grafcet::{Phase, Ticks};
use recipe::DyerActions;

/// Carries out no action of any chart.
#[derive(Debug)]
pub struct Nobody;

impl CalledActions for Nobody {
    fn control(&mut self, _: Phase, _: i16, _: i16) {}
}

impl RemoteActions for Nobody {
    fn send(&mut self, _: Phase, _: Message) {}
}

impl DyerActions for Nobody {
    fn heat(&mut self, _: Phase, _: i16) {}
    fn drum(&mut self, _: Phase, _: u16) {}
}

/// Numbers that look like chance and are the same each time.
#[derive(Debug)]
pub struct Chance(u64);

impl Chance {
    /// A sequence of its own for each seed.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    /// Any number.
    pub fn number(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    /// A number below `limit`.
    pub fn below(&mut self, limit: u32) -> u32 {
        u32::try_from(self.number() % u64::from(limit.max(1))).unwrap_or(0)
    }
}

/// Inputs and readings of the clock, cycle by cycle. Inputs stay as they are for a while; few bits of them change at a time.
#[derive(Debug)]
pub struct Storm<I> {
    chance: Chance,
    bytes: Vec<u8>,
    inputs: I,
    now: Ticks,
}

impl<I: Record + Default> Storm<I> {
    /// A storm of its own for each seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        let inputs = I::default();
        let mut bytes = vec![0; I::BITS.div_ceil(8)];
        inputs.write(&mut grafcet::record::Writer::new(&mut bytes));
        // Soon the clock wraps around.
        Self { chance: Chance::new(seed), bytes, inputs, now: Ticks::new(u32::MAX - 20_000) }
    }

    /// The next cycle.
    pub fn cycle(&mut self) -> (I, Ticks) {
        if self.chance.below(4) == 0 && I::BITS > 0 {
            let before = self.bytes.clone();
            let bit = self.chance.below(u32::try_from(I::BITS).unwrap_or(u32::MAX)) as usize;
            self.bytes[bit / 8] ^= 1 << (bit % 8);
            match I::read(&mut Reader::new(&self.bytes)) {
                Some(inputs) => self.inputs = inputs,
                None => self.bytes = before,
            }
        }
        let step = [0, 1, 1, 10, 10, 10, 100, 5_000][self.chance.below(8) as usize];
        self.now = self.now.after(Ticks::new(step));
        (self.inputs, self.now)
    }
}
