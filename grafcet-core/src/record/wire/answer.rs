//! What the controller says of a command.

use core::fmt::{self, Display};

/// What became of a command.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Answer {
    /// The number of the command.
    pub number: u64,
    /// Whether the program has carried it out.
    pub outcome: Result<(), Refused>,
}

/// Why a command was not carried out.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Refused {
    /// It is for another chart, or another version of the one that runs.
    OtherChart,
    /// Its number is not above that of the last command.
    Old {
        /// The number of the last command.
        last: u64,
    },
    /// It has come too late: what its sender saw has passed, or was before a restart.
    Late {
        /// So many cycles were made since.
        cycles: u32,
    },
    /// It is whole, and says nothing that this version knows.
    Unknown,
    /// The program takes no such command.
    NotOffered,
    /// The program does not take it now.
    NotNow,
    /// These two steps, by their places in [`Chart::STEPS`](crate::Chart::STEPS), are never active together.
    NeverTogether {
        /// One of them.
        one: u32,
        /// The other one.
        other: u32,
    },
    /// The chart has no situation of exactly these steps.
    NoSituation,
}

impl Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::OtherChart => "the controller runs another chart, or another version of it",
            Self::Old { .. } => "a command with a higher number came before",
            Self::Late { .. } => "it has come too late",
            Self::Unknown => "the controller does not know such a command",
            Self::NotOffered => "the program on the controller takes no such command",
            Self::NotNow => "the program on the controller does not take it now",
            Self::NeverTogether { one, other } => {
                return write!(f, "the steps {one} and {other} are never active together");
            }
            Self::NoSituation => "the chart has no situation of exactly these steps",
        })
    }
}

impl core::error::Error for Refused {}

/// The number, what became of it, and eight bytes more of that.
const LEN: usize = 8 + 1 + 8;

impl Answer {
    /// Writes it to the beginning of `to`; how many bytes it takes.
    pub(super) fn write(&self, to: &mut [u8]) -> Option<usize> {
        let pair = |one: u32, other: u32| u64::from(one) | u64::from(other) << 32;
        let (code, more) = match self.outcome {
            Ok(()) => (0, 0),
            Err(Refused::OtherChart) => (1, 0),
            Err(Refused::Old { last }) => (2, last),
            Err(Refused::Unknown) => (3, 0),
            Err(Refused::NotOffered) => (4, 0),
            Err(Refused::NotNow) => (5, 0),
            Err(Refused::NeverTogether { one, other }) => (6, pair(one, other)),
            Err(Refused::NoSituation) => (7, 0),
            Err(Refused::Late { cycles }) => (8, u64::from(cycles)),
        };
        let (number, rest) = to.get_mut(..LEN)?.split_first_chunk_mut()?;
        *number = self.number.to_le_bytes();
        let (first, more_of_it) = rest.split_first_mut()?;
        *first = code;
        more_of_it.copy_from_slice(&u64::to_le_bytes(more));
        Some(LEN)
    }

    /// What was written; `None` where these bytes are no answer.
    pub(super) fn read(bytes: &[u8]) -> Option<Self> {
        let (number, rest) = bytes.split_first_chunk()?;
        let (code, more) = rest.split_first()?;
        let more = u64::from_le_bytes(more.try_into().ok()?);
        let outcome = match (code, more) {
            (0, 0) => Ok(()),
            (1, 0) => Err(Refused::OtherChart),
            (2, last) => Err(Refused::Old { last }),
            (3, 0) => Err(Refused::Unknown),
            (4, 0) => Err(Refused::NotOffered),
            (5, 0) => Err(Refused::NotNow),
            (6, _) => Err(Refused::NeverTogether {
                one: u32::try_from(more & u64::from(u32::MAX)).ok()?,
                other: u32::try_from(more >> 32).ok()?,
            }),
            (7, 0) => Err(Refused::NoSituation),
            (8, _) => Err(Refused::Late { cycles: u32::try_from(more).ok()? }),
            _ => return None,
        };
        Some(Self { number: u64::from_le_bytes(*number), outcome })
    }
}

#[cfg(test)]
mod tests {
    use super::{Answer, LEN, Refused};

    #[test]
    fn what_is_written_is_read() {
        for outcome in [
            Ok(()),
            Err(Refused::OtherChart),
            Err(Refused::Old { last: 0x1234_5678_9abc_def0 }),
            Err(Refused::Unknown),
            Err(Refused::NotOffered),
            Err(Refused::NotNow),
            Err(Refused::NeverTogether { one: 3, other: 0xdead_beef }),
            Err(Refused::NoSituation),
            Err(Refused::Late { cycles: u32::MAX }),
        ] {
            let (answer, mut bytes) = (Answer { number: u64::MAX - 1, outcome }, [0xaa; LEN + 1]);
            assert_eq!(answer.write(&mut bytes), Some(LEN));
            assert_eq!(Answer::read(&bytes[..LEN]), Some(answer));
            assert_eq!((Answer::read(&bytes), Answer::read(&bytes[..LEN - 1])), (None, None));
            assert_eq!(answer.write(&mut bytes[..LEN - 1]), None);
        }
        let mut bytes = [0; LEN];
        bytes[8] = 9;
        assert_eq!(Answer::read(&bytes), None, "there is no such reason");
        // There is one way to write each: those to which nothing belongs have zeros after them, a count of cycles in its upper half.
        for code in [0, 1, 3, 4, 5, 7, 8] {
            (bytes[8], bytes[16]) = (code, 1);
            assert_eq!(Answer::read(&bytes), None, "code {code}");
        }
    }
}
