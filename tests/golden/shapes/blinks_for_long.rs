// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __BeaconState {
    Rest,
    Alarm,
    INIT,
}
impl Beacon {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &BeaconInputs,
        #[cfg(doc)]
        inputs: &BeaconInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> BeaconOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = const {
            BeaconOutputs {
                lamp: false,
                horn: false,
            }
        };
        let was_state_: __BeaconState = self.situation;
        self.before_state = self.situation;
        let elapsed_: Ticks = now_.since(self.reading);
        self.reading = now_;
        match self.situation {
            __BeaconState::INIT => {
                self.situation = __BeaconState::Rest;
            }
            __BeaconState::Rest => {
                if inputs_.fault {
                    self.situation = __BeaconState::Alarm;
                    outputs_ = const {
                        BeaconOutputs {
                            lamp: true,
                            horn: true,
                        }
                    };
                }
            }
            __BeaconState::Alarm => {
                self.phase = phase(
                    self.phase,
                    elapsed_,
                    Ticks::new(400u32),
                );
                if inputs_.ack {
                    self.situation = __BeaconState::Rest;
                    self.phase = Ticks::ZERO;
                } else {
                    outputs_.lamp = self.phase
                        < Ticks::new(200u32);
                    outputs_.horn = now_.since(self.since)
                        < Ticks::new(60000u32);
                    if has_reached!(
                        now_.since(self.since),
                        Ticks::new(60000u32)
                    ) {
                        self.since = now_
                            .since(Ticks::new(60000u32));
                    }
                }
            }
        }
        if was_state_ != self.situation {
            self.since = now_;
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
        if self.situation == __BeaconState::Alarm
            && self.reading.since(self.since)
                < Ticks::new(60000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(60000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __BeaconState::Alarm {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    (if self.phase < Ticks::new(200u32) {
                        Ticks::new(200u32)
                    } else {
                        Ticks::new(400u32)
                    }) - self.phase,
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
