//! The qualifiers of actions: what each of them is, told once. A new qualifier is a row here and what it does in a cycle.

use crate::ast::Dialect;

/// The qualifiers of IEC 61131-3 (Table 59), and `on` of IEC 60848.
#[derive(Clone, Copy, PartialEq, Eq, Debug, PartialOrd, Ord)]
pub enum Qualifier {
    /// Not stored: as long as the step is active.
    N,
    /// Set: stored until a reset.
    S,
    /// Reset: ends what is stored.
    R,
    /// Limited: at most for its time.
    L,
    /// Delayed: from its time on.
    D,
    /// Pulse: in the cycle in which the step becomes active.
    P,
    /// Pulse on the rising edge of the step: once on activation.
    P1,
    /// Pulse on its falling edge: once on deactivation.
    P0,
    /// Stored and delayed: the time runs on after the step.
    Sd,
    /// Delayed and stored: stored if the step lasts for its time.
    Ds,
    /// Stored and limited: from activation on, at most for its time.
    Sl,
    /// `on event`: the stored action on event.
    On,
}

/// When an action with a qualifier acts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Trigger {
    /// As long as the step is active.
    Active,
    /// When the step has become active.
    Activation,
    /// When the step has been left.
    Deactivation,
    /// At an event while the step is active.
    Event,
}

impl Qualifier {
    /// All of them, in the order of the standard.
    pub const ALL: [Self; 12] = [
        Self::N,
        Self::S,
        Self::R,
        Self::L,
        Self::D,
        Self::P,
        Self::P1,
        Self::P0,
        Self::Sd,
        Self::Ds,
        Self::Sl,
        Self::On,
    ];

    /// How it is written.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::N => "N",
            Self::S => "S",
            Self::R => "R",
            Self::L => "L",
            Self::D => "D",
            Self::P => "P",
            Self::P1 => "P1",
            Self::P0 => "P0",
            Self::Sd => "SD",
            Self::Ds => "DS",
            Self::Sl => "SL",
            Self::On => "on",
        }
    }

    /// The qualifier that is written in letters so; `on` is a form of its own.
    #[must_use]
    pub(crate) fn of_letters(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|qualifier| *qualifier != Self::On && qualifier.word() == word)
    }

    /// Whether charts of this dialect have it.
    #[must_use]
    pub fn is_of(self, dialect: Dialect) -> bool {
        match self {
            Self::P | Self::Sd | Self::Ds | Self::Sl => dialect == Dialect::Sfc,
            Self::On => dialect == Dialect::Grafcet,
            Self::N | Self::S | Self::R | Self::L | Self::D | Self::P1 | Self::P0 => true,
        }
    }

    /// Whether a time belongs to it: L, D, SD, DS, SL.
    #[must_use]
    pub const fn has_time(self) -> bool {
        matches!(self, Self::L | Self::D | Self::Sd | Self::Ds | Self::Sl)
    }

    /// Whether a flip-flop of the action control keeps what it does beyond its step: S, SD, DS, SL.
    #[must_use]
    pub const fn has_flip_flop(self) -> bool {
        matches!(self, Self::S | Self::Sd | Self::Ds | Self::Sl)
    }

    /// Whether it sets or resets at once what stays: S and R.
    #[must_use]
    pub const fn sets_or_resets(self) -> bool {
        matches!(self, Self::S | Self::R)
    }

    /// Whether it acts while its step is active and ends with it: N, L, D.
    #[must_use]
    pub const fn is_continuous(self) -> bool {
        matches!(self, Self::N | Self::L | Self::D)
    }

    /// Whether it acts while its step is active at most, and nothing of it stays: N, L, D and the pulse of P.
    #[must_use]
    pub(crate) const fn shows_with_its_step(self) -> bool {
        self.drives_q() && !self.has_flip_flop()
    }

    /// Whether an association under it has neither timer nor flip-flop, so that it drives Q by itself: N, P.
    #[must_use]
    pub const fn drives_q_at_once(self) -> bool {
        self.shows_with_its_step() && !self.has_time()
    }

    /// Whether it acts until its time is over, and not from then on: L, SL.
    #[must_use]
    pub const fn limits(self) -> bool {
        matches!(self, Self::L | Self::Sl)
    }

    /// Whether its time is that of a flip-flop, which goes on after the step: SD, SL.
    #[must_use]
    pub const fn times_its_flip_flop(self) -> bool {
        matches!(self, Self::Sd | Self::Sl)
    }

    /// Whether its time is that of its step, and begins anew where this is entered anew: L, D, DS.
    #[must_use]
    pub const fn restarts_with_step(self) -> bool {
        self.has_time() && !self.times_its_flip_flop()
    }

    /// Whether its flip-flop is set when its time is over, and not when its step asks: DS.
    #[must_use]
    pub const fn stores_when_time_is_over(self) -> bool {
        self.has_flip_flop() && self.restarts_with_step()
    }

    /// Whether it runs something once and has no part in Q of the action control: P1, P0, `on`.
    #[must_use]
    pub const fn runs_once(self) -> bool {
        matches!(self, Self::P1 | Self::P0 | Self::On)
    }

    /// Whether it makes Q of the action control true: not R, and not what runs once.
    #[must_use]
    pub const fn drives_q(self) -> bool {
        !matches!(self, Self::R) && !self.runs_once()
    }

    /// Whether a `grafcet` acts at an instant under it (IEC 60848, stored action): S, R, P1, P0, `on`.
    #[must_use]
    pub(crate) const fn is_stored_action(self) -> bool {
        self.sets_or_resets() || self.runs_once()
    }

    /// When it acts. Under S and R a `grafcet` acts once, on activation; in an `sfc` they are inputs of flip-flops.
    #[must_use]
    pub fn trigger(self, dialect: Dialect) -> Trigger {
        match self {
            Self::P | Self::P1 => Trigger::Activation,
            Self::S | Self::R if dialect == Dialect::Grafcet => Trigger::Activation,
            Self::P0 => Trigger::Deactivation,
            Self::On => Trigger::Event,
            Self::N | Self::S | Self::R | Self::L | Self::D | Self::Sd | Self::Ds | Self::Sl => Trigger::Active,
        }
    }
}

// A new one that is not in the list would be passed by.
const _: () = assert!(Qualifier::ALL.len() == Qualifier::On as usize + 1, "`Qualifier::ALL` holds all of them");

#[cfg(test)]
mod tests {
    use super::Qualifier;
    use crate::list::List;

    /// The words of those for which something holds.
    fn with(is: fn(Qualifier) -> bool) -> String {
        let mut all = Qualifier::ALL.to_vec();
        all.retain(|qualifier| is(*qualifier));
        all.into_iter().map(Qualifier::word).list().join(" ")
    }

    #[test]
    fn what_each_of_them_is() {
        assert_eq!(with(Qualifier::has_time), "L D SD DS SL");
        assert_eq!(with(Qualifier::has_flip_flop), "S SD DS SL");
        assert_eq!(with(Qualifier::drives_q), "N S L D P SD DS SL");
        assert_eq!(with(Qualifier::drives_q_at_once), "N P");
        assert_eq!(with(Qualifier::is_continuous), "N L D");
        assert_eq!(with(Qualifier::shows_with_its_step), "N L D P");
        assert_eq!(with(Qualifier::limits), "L SL");
        assert_eq!(with(Qualifier::restarts_with_step), "L D DS");
        assert_eq!(with(Qualifier::times_its_flip_flop), "SD SL");
        assert_eq!(with(Qualifier::stores_when_time_is_over), "DS");
        assert_eq!(with(Qualifier::runs_once), "P1 P0 on");
    }
}
