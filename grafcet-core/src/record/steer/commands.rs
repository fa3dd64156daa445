//! Commands out of bytes, on the controller.

use core::marker::PhantomData;

use cobs::{DecodeResult, DecoderState};

use super::{Answer, COMMAND, Command, FORCE, HEAD, INIT, MODE, Mode, PUSH, Refused, Wanted, raw_len};
use crate::record::bits::bytes_for;
use crate::record::chart::Recordable;
use crate::record::wire::checked;

/// How many bytes [`Commands`] needs for the commands of a chart.
#[must_use]
pub const fn command_len<C: Recordable>() -> usize {
    raw_len(C::STEPS.len())
}

/// Finds the commands for a chart in what comes over a line.
///
/// What is damaged, cut off or longer than a command is no command, and nobody hears of it. What is whole but must not be carried out is refused with an answer: for another chart
/// or version, with a number that is not above the last one, as where a line says something twice, or too late, as where a line has kept it back.
#[derive(Debug)]
pub struct Commands<C, B, S> {
    /// Decodes byte by byte: decoding a whole frame where it stands cannot be shown to reach no panic.
    state: DecoderState,
    /// What is decoded of a frame.
    buffer: B,
    /// How much of the buffer is filled; more than it has where a frame is too long.
    filled: usize,
    /// Room for the steps of a situation.
    steps: S,
    /// The number of the last command.
    last: u64,
    /// So many cycles old a command is at most.
    oldest: u32,
    chart: PhantomData<fn() -> C>,
}

impl<C: Recordable, B: AsRef<[u8]> + AsMut<[u8]>, S: AsMut<[C::Step]>> Commands<C, B, S> {
    /// With a buffer of [`command_len`] bytes, and room for the steps of a situation: all steps of the chart, `[Press::STEPS[0]; Press::STEPS.len()]`; or none, `[]`, and
    /// forcing is refused ([`Refused::NotOffered`]).
    ///
    /// A command is taken as long as the controller has made no more than `oldest` cycles since the state that its sender saw: as many as lie in a few seconds, and more than lie
    /// between two frames.
    pub const fn new(buffer: B, steps: S, oldest: u32) -> Self {
        Self { state: DecoderState::Idle, buffer, filled: 0, steps, last: 0, oldest, chart: PhantomData }
    }

    /// Only commands with a number above this one are taken: that of [`last`](Self::last), where the program has stored it over a restart.
    #[must_use]
    pub fn after(mut self, last: u64) -> Self {
        self.last = last;
        self
    }

    /// The number of the last command.
    pub const fn last(&self) -> u64 {
        self.last
    }

    /// Takes a byte, with the [cycles](crate::record::Recorder::cycles) that the chart has made; where it is the last one of a command, that command, or the answer with which it is
    /// refused.
    ///
    /// Nothing happens to the chart: the program carries the command out, or does not, and answers.
    pub fn push(&mut self, byte: u8, cycles: u32) -> Option<Result<Command<'_, C::Step>, Answer>> {
        match self.state.feed(byte) {
            Ok(DecodeResult::DataComplete) => {}
            Ok(DecodeResult::DataStart) => {
                self.filled = 0;
                return None;
            }
            Ok(DecodeResult::DataContinue(decoded)) => {
                if let Some(to) = self.buffer.as_mut().get_mut(self.filled) {
                    *to = decoded;
                }
                self.filled = self.filled.saturating_add(1);
                return None;
            }
            Ok(DecodeResult::NoData) | Err(_) => return None,
        }
        let content = checked(self.buffer.as_ref().get(..self.filled)?)?;
        let (&[kind, ref head @ ..], more) = content.split_first_chunk::<HEAD>()?;
        if kind != COMMAND {
            return None;
        }
        let (number, rest) = head.split_first_chunk()?;
        let (fingerprint, rest) = rest.split_first_chunk()?;
        let (seen, what) = rest.split_first_chunk()?;
        let number = u64::from_le_bytes(*number);
        let refused = |why| Some(Err(Answer { number, outcome: Err(why) }));
        // It may be for a neighbour on the same line: its number says nothing here.
        if u32::from_le_bytes(*fingerprint) != C::FINGERPRINT {
            return refused(Refused::OtherChart);
        }
        if number <= self.last {
            return refused(Refused::Old { last: self.last });
        }
        self.last = number;
        // A cycle that is still to come is one from before a restart.
        let age = cycles.wrapping_sub(u32::from_le_bytes(*seen));
        if age > self.oldest {
            return refused(Refused::Late { cycles: age });
        }
        let wanted = match (*what.first()?, more) {
            (INIT, []) => Wanted::Init,
            (PUSH, []) => Wanted::Push,
            (MODE, [place]) => match Mode::ALL.get(usize::from(*place)) {
                Some(new) => Wanted::Mode(*new),
                None => return refused(Refused::Unknown),
            },
            (FORCE, situation) => match steps::<C>(situation, self.steps.as_mut()) {
                Ok(steps) => Wanted::Force(steps),
                Err(why) => return refused(why),
            },
            _ => return refused(Refused::Unknown),
        };
        Some(Ok(Command { number, wanted, all: C::STEPS }))
    }
}

/// The steps of a situation, which has a bit for each step.
fn steps<'s, C: Recordable>(situation: &[u8], room: &'s mut [C::Step]) -> Result<&'s [C::Step], Refused> {
    let has = |step: usize| situation.get(step / 8).is_some_and(|byte| byte >> (step % 8) & 1 != 0);
    let is_known = situation.len() == bytes_for(C::STEPS.len());
    if !is_known || (C::STEPS.len()..situation.len() * 8).any(has) {
        return Err(Refused::Unknown);
    }
    if room.is_empty() {
        return Err(Refused::NotOffered);
    }
    let mut filled = 0;
    for (place, step) in C::STEPS.iter().enumerate() {
        if has(place) {
            *room.get_mut(filled).ok_or(Refused::NotOffered)? = *step;
            filled += 1;
        }
    }
    room.get(..filled).ok_or(Refused::NotOffered)
}
