// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __LampState {
    Off,
    On,
    Dim,
    INIT,
}
impl Lamp {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &LampInputs,
        #[cfg(doc)]
        inputs: &LampInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> LampOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = LampOutputs { lamp: false };
        let was_state_: __LampState = self.situation;
        self.before_state = self.situation;
        self.reading = now_;
        let passed_: Ticks = now_.since(self.since);
        match self.situation {
            __LampState::INIT => {
                self.situation = __LampState::Off;
            }
            __LampState::Off => {
                if inputs_.on {
                    self.situation = __LampState::On;
                }
            }
            __LampState::On => {
                if has_reached!(
                    passed_, Ticks::new(5000u32)
                ) {
                    self.situation = __LampState::Dim;
                    outputs_.lamp = true;
                }
            }
            __LampState::Dim => {
                if has_reached!(
                    passed_, Ticks::new(3000u32)
                ) {
                    if !inputs_.on {
                        self.situation = __LampState::Off;
                    } else {
                        outputs_.lamp = false;
                        self.since = now_
                            .since(Ticks::new(3000u32));
                    }
                } else {
                    outputs_.lamp = passed_ < Ticks::new(2000u32);
                }
            }
        }
        if was_state_ != self.situation {
            self.since = now_;
        }
        match self.situation {
            __LampState::On => {
                outputs_.lamp = true;
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
        if self.before_state != self.situation {
            return Option::Some(self.since);
        }
        let mut soonest_ = Option::None;
        if self.situation == __LampState::On
            && self.reading.since(self.since) < Ticks::new(5000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(5000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __LampState::Dim
            && self.reading.since(self.since) < Ticks::new(2000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(2000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __LampState::Dim
            && self.reading.since(self.since) < Ticks::new(3000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(3000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        match soonest_ {
            Option::Some(time_) => {
                Option::Some(self.reading.after(time_))
            }
            Option::None => Option::None,
        }
    }
}
