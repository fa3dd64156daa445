// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

#[repr(u32)]
enum __ReaderState {
    Always,
}
struct __ReaderStateMark(u8);
impl __ReaderStateMark {
    const fn of(state_: __ReaderState) -> Self {
        Self(state_ as u8)
    }
    const fn state(self) -> __ReaderState {
        let number_ = self.0 & 0u8;
        {
            let _ = number_;
            __ReaderState::Always
        }
    }
    /// Another state, and the mark as it is.
    const fn with(self, state_: __ReaderState) -> Self {
        Self(self.0 & 1u8 | state_ as u8)
    }
    const fn unmarked(self) -> Self {
        Self(self.0 & 0u8)
    }
    const fn marked(self) -> Self {
        Self(self.0 | 1u8)
    }
    const fn is_marked(self) -> bool {
        self.0 & 1u8 != 0
    }
}
impl Reader {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &ReaderInputs,
        #[cfg(doc)]
        inputs: &ReaderInputs,
    ) -> ReaderOutputs {
        copied::<Code>();
        let mut outputs_ = ReaderOutputs {
            last: Code::NONE,
            shown: default_value::<Code>(),
        };
        let edge0_now_: bool = inputs_.there;
        let mut was_state_: __ReaderState = __ReaderState::Always;
        let mut evolutions_: u32 = 0;
        loop {
            was_state_ = self.situation.state();
            let mut next_last_: Code = self.last;
            if was_state_ == __ReaderState::Always && !self.edge0_before && edge0_now_ {
                next_last_ = inputs_.code;
            }
            if !(was_state_ != self.situation.state()
                || !is_same::<Code>(&self.last, &next_last_))
            {
                self.situation = self.situation.unmarked();
                break;
            }
            if evolutions_ == 4 {
                self.situation = self.situation.marked();
                self.situation = self.situation.with(was_state_);
                break;
            }
            self.last = next_last_;
            self.edge0_before = edge0_now_;
            evolutions_ = evolutions_.wrapping_add(1);
        }
        let next_shown_: Code;
        if was_state_ == __ReaderState::Always && inputs_.there {
            next_shown_ = inputs_.code;
        } else {
            next_shown_ = default_value::<Code>();
        }
        outputs_.shown = next_shown_;
        if !self.situation.is_marked() {
            self.edge0_before = edge0_now_;
        }
        outputs_.last = self.last;
        outputs_
    }
}
