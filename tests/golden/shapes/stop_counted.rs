// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __StopCountedState {
    Idle,
    Fill,
    Choose,
    Wash,
    Rinse,
    Spin,
    Rest,
    Stopped,
    INIT,
}
impl StopCounted {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &StopCountedInputs,
        #[cfg(doc)]
        inputs: &StopCountedInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> StopCountedOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = const {
            StopCountedOutputs {
                p: false,
                q: false,
                r: false,
                s: false,
            }
        };
        let was_state_: __StopCountedState = self.situation;
        self.before_state = self.situation;
        let elapsed_: Ticks = now_.since(self.reading);
        self.reading = now_;
        self.time = self.time + elapsed_;
        match self.situation {
            __StopCountedState::INIT => {
                self.time = Ticks::ZERO;
                self.situation = __StopCountedState::Idle;
            }
            __StopCountedState::Idle => {
                if inputs_.a {
                    self.situation = __StopCountedState::Fill;
                }
            }
            __StopCountedState::Fill => {
                if inputs_.stop {
                    self.situation = __StopCountedState::Stopped;
                } else {
                    if inputs_.b
                        && has_reached!(
                            self.time, Ticks::new(1000u32)
                        )
                    {
                        self.situation = __StopCountedState::Choose;
                    }
                }
            }
            __StopCountedState::Choose => {
                if inputs_.stop {
                    self.situation = __StopCountedState::Stopped;
                } else {
                    if inputs_.c {
                        self.situation = __StopCountedState::Rinse;
                    } else {
                        self.situation = __StopCountedState::Wash;
                    }
                }
            }
            __StopCountedState::Wash => {
                if inputs_.stop {
                    self.situation = __StopCountedState::Stopped;
                } else {
                    if self.time >= self.params.soak {
                        self.situation = __StopCountedState::Rinse;
                    }
                }
            }
            __StopCountedState::Rinse => {
                if inputs_.stop {
                    self.situation = __StopCountedState::Stopped;
                } else {
                    if inputs_.b
                        && has_reached!(
                            self.time, Ticks::new(3000u32)
                        )
                    {
                        self.situation = __StopCountedState::Spin;
                    }
                }
            }
            __StopCountedState::Spin => {
                if inputs_.stop {
                    self.situation = __StopCountedState::Stopped;
                } else {
                    if has_reached!(
                        self.time, Ticks::new(4000u32)
                    ) {
                        self.situation = __StopCountedState::Rest;
                    }
                }
            }
            __StopCountedState::Rest => {
                if inputs_.stop {
                    self.situation = __StopCountedState::Stopped;
                } else {
                    if !inputs_.a {
                        self.situation = __StopCountedState::Idle;
                    }
                }
            }
            __StopCountedState::Stopped => {
                if !inputs_.stop {
                    self.situation = __StopCountedState::Idle;
                }
            }
        }
        if was_state_ != self.situation {
            self.time = Ticks::ZERO;
        }
        match self.situation {
            __StopCountedState::Fill => {
                outputs_ = const {
                    StopCountedOutputs {
                        p: true,
                        q: false,
                        r: false,
                        s: false,
                    }
                };
            }
            __StopCountedState::Wash => {
                outputs_ = const {
                    StopCountedOutputs {
                        p: false,
                        q: true,
                        r: false,
                        s: false,
                    }
                };
            }
            __StopCountedState::Rinse => {
                outputs_ = const {
                    StopCountedOutputs {
                        p: true,
                        q: true,
                        r: false,
                        s: false,
                    }
                };
            }
            __StopCountedState::Spin => {
                outputs_ = const {
                    StopCountedOutputs {
                        p: false,
                        q: false,
                        r: true,
                        s: false,
                    }
                };
            }
            __StopCountedState::Rest => {
                outputs_ = const {
                    StopCountedOutputs {
                        p: false,
                        q: false,
                        r: false,
                        s: true,
                    }
                };
            }
            __StopCountedState::Stopped => {
                outputs_ = const {
                    StopCountedOutputs {
                        p: false,
                        q: false,
                        r: true,
                        s: true,
                    }
                };
            }
            _ => {
                outputs_ = const {
                    StopCountedOutputs {
                        p: false,
                        q: false,
                        r: false,
                        s: false,
                    }
                };
            }
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
            return Option::Some(self.reading);
        }
        let mut soonest_ = Option::None;
        if self.situation == __StopCountedState::Fill
            && self.time < Ticks::new(1000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(1000u32) - self.time,
                ),
            );
        }
        if self.situation == __StopCountedState::Wash && self.time < self.params.soak {
            soonest_ = sooner(
                soonest_,
                Option::Some(self.params.soak - self.time),
            );
        }
        if self.situation == __StopCountedState::Rinse
            && self.time < Ticks::new(3000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(3000u32) - self.time,
                ),
            );
        }
        if self.situation == __StopCountedState::Spin
            && self.time < Ticks::new(4000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(4000u32) - self.time,
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
