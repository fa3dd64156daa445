//! Commands from the host: which mode, the push button, a situation by hand, *Init*.
//!
//! [`Commands`] finds them in the bytes that come over a line, in memory that it is given. It carries out nothing: the program does what it takes, and
//! [`Recorder::answer`](super::Recorder::answer) tells the host what became of it. `cargo grafcet watch --steer` is the other end.
//!
//! This is for commissioning, with somebody beside the machine. No command stands for an emergency stop, which is hardware.

mod commands;
mod request;

use super::bits::bytes_for;
use crate::ForceError;

pub use super::wire::{Answer, Refused};
pub use commands::{Commands, command_len};
pub use request::{Request, request_len};

/// The kind of the frame, with the version of the format above it.
const COMMAND: u8 = 0x15;
/// Kind, number, fingerprint, the cycle that was seen, and what is wanted.
const HEAD: usize = 1 + 8 + 4 + 4 + 1;
/// The check sum after it.
const TAIL: usize = 4;
/// What is wanted.
const INIT: u8 = 0;
const MODE: u8 = 1;
const PUSH: u8 = 2;
const FORCE: u8 = 3;

/// How long the commands of a chart with so many steps are at most, before they are encoded.
const fn raw_len(steps: usize) -> usize {
    let situation = bytes_for(steps);
    HEAD + if situation > 1 { situation } else { 1 } + TAIL
}

/// In which way a chart that says `modes;` is run.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Mode {
    /// By itself.
    #[default]
    Automatic,
    /// Step by step: the input `semi_automatic`.
    SemiAutomatic,
    /// By hand: the input `manual`.
    Manual,
    /// Not at all: the input `paused`.
    Paused,
}

impl Mode {
    /// All of them, by their numbers in a command.
    pub const ALL: [Self; 4] = [Self::Automatic, Self::SemiAutomatic, Self::Manual, Self::Paused];
}

/// What a command wants. `S` are the steps of the chart; without the chart, their places.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Wanted<'s, S> {
    /// Back to the initial situation.
    Init,
    /// From now on in this mode.
    Mode(Mode),
    /// The push button, once.
    Push,
    /// By hand into the situation of exactly these steps.
    Force(&'s [S]),
}

/// A command that is whole, new, not too old, and for this chart.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Command<'s, S: 'static> {
    /// Its number.
    pub number: u64,
    /// What it wants.
    pub wanted: Wanted<'s, S>,
    /// All steps of the chart.
    all: &'static [S],
}

impl<S: Eq> Command<'_, S> {
    /// The answer where the program has carried it out, for [`Recorder::answer`](super::Recorder::answer).
    #[must_use]
    pub const fn accepted(&self) -> Answer {
        Answer { number: self.number, outcome: Ok(()) }
    }

    /// The answer where the program has not, for [`Recorder::answer`](super::Recorder::answer). Why is for the program to say: as a
    /// rule [`Refused::NotOffered`] or [`Refused::NotNow`]. What [`Commands`] refuses comes with its answer and is no command.
    #[must_use]
    pub const fn refused(&self, why: Refused) -> Answer {
        Answer { number: self.number, outcome: Err(why) }
    }

    /// The answer where `force` has refused the situation.
    #[must_use]
    pub fn not_forced(&self, error: ForceError<S>) -> Answer {
        let place = |step: &S| {
            let place = self.all.iter().position(|other| other == step);
            place.and_then(|place| u32::try_from(place).ok()).unwrap_or(u32::MAX)
        };
        self.refused(match error {
            ForceError::NeverTogether(one, other) => Refused::NeverTogether { one: place(&one), other: place(&other) },
            ForceError::NoSituation => Refused::NoSituation,
        })
    }
}
