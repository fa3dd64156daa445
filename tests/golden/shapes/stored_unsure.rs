// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __StoredUnsureState {
    Rest,
    Close,
    Work,
    Open,
    Fault,
    INIT,
}
impl StoredUnsure {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &StoredUnsureInputs,
        #[cfg(doc)]
        inputs: &StoredUnsureInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> StoredUnsureOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = const {
            StoredUnsureOutputs {
                clamp: false,
                red: false,
            }
        };
        let was_state_: __StoredUnsureState = self.situation;
        self.before_state = self.situation;
        let passed_: Ticks = now_.since(self.since);
        let after_: __StoredUnsureState;
        match self.situation {
            __StoredUnsureState::INIT => {
                after_ = __StoredUnsureState::Rest;
            }
            __StoredUnsureState::Rest => {
                if inputs_.start {
                    after_ = __StoredUnsureState::Close;
                } else {
                    after_ = __StoredUnsureState::Rest;
                }
            }
            __StoredUnsureState::Close => {
                if inputs_.closed {
                    after_ = __StoredUnsureState::Work;
                } else {
                    if has_reached!(
                        passed_, Ticks::new(1000u32)
                    ) {
                        after_ = __StoredUnsureState::Fault;
                    } else {
                        after_ = __StoredUnsureState::Close;
                    }
                }
            }
            __StoredUnsureState::Work => {
                if inputs_.done {
                    after_ = __StoredUnsureState::Open;
                } else {
                    if has_reached!(
                        passed_, Ticks::new(9000u32)
                    ) {
                        after_ = __StoredUnsureState::Fault;
                    } else {
                        after_ = __StoredUnsureState::Work;
                    }
                }
            }
            __StoredUnsureState::Open => {
                if !inputs_.closed {
                    after_ = __StoredUnsureState::Rest;
                } else {
                    if has_reached!(
                        passed_, Ticks::new(1000u32)
                    ) {
                        after_ = __StoredUnsureState::Fault;
                    } else {
                        after_ = __StoredUnsureState::Open;
                    }
                }
            }
            __StoredUnsureState::Fault => {
                if inputs_.ack {
                    after_ = __StoredUnsureState::Rest;
                } else {
                    after_ = __StoredUnsureState::Fault;
                }
            }
        }
        self.situation = after_;
        if was_state_ != after_ {
            self.since = now_;
        }
        match after_ {
            __StoredUnsureState::Rest | __StoredUnsureState::Open => {
                self.s_ff_clamp = false;
            }
            __StoredUnsureState::Close => {
                self.s_ff_clamp = true;
            }
            __StoredUnsureState::Fault => {
                outputs_.red = true;
            }
            _ => {}
        }
        outputs_.clamp = self.s_ff_clamp;
        outputs_
    }
    /// The reading of the clock before which nothing changes unless an input does (or the recipe): a controller
    /// that sleeps until then behaves like one that scans all the time. The reading of the last cycle means
    /// "scan again at once"; `None` means "only an input can change anything".
    #[must_use]
    fn next_deadline(
        &self,
    ) -> Option<Ticks> {
        if self.before_state != self.situation {
            return Option::Some(self.since);
        }
        let mut soonest_ = Option::None;
        if self.situation == __StoredUnsureState::Close {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(1000u32),
                ),
            );
        }
        if self.situation == __StoredUnsureState::Work {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(9000u32),
                ),
            );
        }
        if self.situation == __StoredUnsureState::Open {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(1000u32),
                ),
            );
        }
        match soonest_ {
            Option::Some(time_) => {
                Option::Some(self.since.after(time_))
            }
            Option::None => Option::None,
        }
    }
}
