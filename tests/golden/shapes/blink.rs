// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __GateState {
    Closed,
    Opening,
    Opened,
    INIT,
}
impl Gate {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &GateInputs,
        #[cfg(doc)]
        inputs: &GateInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> GateOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = const {
            GateOutputs {
                motor: false,
                lamp: false,
            }
        };
        let was_state_: __GateState = self.situation;
        self.before_state = self.situation;
        match self.situation {
            __GateState::INIT => {
                self.situation = __GateState::Closed;
            }
            __GateState::Closed => {
                if inputs_.open {
                    self.situation = __GateState::Opening;
                    outputs_.lamp = true;
                }
            }
            __GateState::Opening => {
                if inputs_.up {
                    self.situation = __GateState::Opened;
                } else {
                    outputs_.lamp = rest(
                        now_.since(self.since),
                        Ticks::new(1000u32),
                    ) < Ticks::new(500u32);
                    if has_reached!(
                        rest(now_.since(self.since),
                        Ticks::new(1000u32)),
                        Ticks::new(500u32)
                    ) {
                        self.before_state = __GateState::INIT;
                    }
                    if has_reached!(
                        now_.since(self.since), Ticks::new(1000u32)
                    ) {
                        self.since = now_
                            .since(
                                rest(
                                    now_.since(self.since),
                                    Ticks::new(1000u32),
                                ),
                            );
                    }
                }
            }
            __GateState::Opened => {
                if !inputs_.open {
                    self.situation = __GateState::Closed;
                }
            }
        }
        if was_state_ != self.situation {
            self.since = now_;
        }
        match self.situation {
            __GateState::Opening => {
                outputs_.motor = true;
            }
            _ => {}
        }
        outputs_
    }
    /// The reading of the clock before which nothing changes unless an input does (or the recipe): a controller
    /// that sleeps until then behaves like one that scans all the time. The reading of the last cycle means
    /// "scan again at once"; `None` means "only an input can change anything".
    #[must_use]
    fn next_deadline(
        &self,
    ) -> Option<Ticks> {
        if self.before_state != self.situation
            && !(self.before_state == __GateState::INIT
                && self.situation == __GateState::Opening)
        {
            return Option::Some(self.since);
        }
        let mut soonest_ = Option::None;
        if self.situation == __GateState::Opening
            && self.before_state != __GateState::INIT
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(500u32),
                ),
            );
        }
        if self.situation == __GateState::Opening {
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
