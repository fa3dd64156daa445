// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __BurnerState {
    Standby,
    Purge,
    Ignite,
    Low,
    High,
    Failed,
    INIT,
}
impl Burner {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &BurnerInputs,
        #[cfg(doc)]
        inputs: &BurnerInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> BurnerOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = const {
            BurnerOutputs {
                ready: false,
                fan: false,
                pump: false,
                spark: false,
                gas: false,
                alarm: false,
            }
        };
        if !inputs_.flame {
            if !self.delay0_in {
                self.delay0_since = now_;
                self.delay0_in = true;
            } else {
                if !self.delay0_out
                    && has_reached!(
                        now_.since(self.delay0_since),
                        Ticks::new(300u32)
                    )
                {
                    self.delay0_out = true;
                }
            }
        } else {
            self.delay0_in = false;
            self.delay0_out = false;
        }
        let was_state_: __BurnerState = self.situation;
        self.before_state = self.situation;
        let mut elapsed_: Ticks = now_.since(self.reading);
        self.reading = now_;
        let passed_: Ticks = now_.since(self.since);
        match self.situation {
            __BurnerState::INIT => {
                elapsed_ = Ticks::ZERO;
                self.situation = __BurnerState::Standby;
            }
            __BurnerState::Standby => {
                if inputs_.demand {
                    self.situation = __BurnerState::Purge;
                }
            }
            __BurnerState::Purge => {
                if has_reached!(
                    passed_, Ticks::new(2000u32)
                ) {
                    self.situation = __BurnerState::Ignite;
                }
            }
            __BurnerState::Ignite => {
                if inputs_.flame {
                    self.situation = __BurnerState::Low;
                    self.sd_ff_pump = true;
                } else {
                    if has_reached!(
                        passed_, Ticks::new(1000u32)
                    ) {
                        self.situation = __BurnerState::Failed;
                    }
                }
            }
            __BurnerState::Low => {
                if self.delay0_out {
                    self.situation = __BurnerState::Failed;
                } else {
                    if has_reached!(
                        passed_, Ticks::new(5000u32)
                    ) {
                        self.situation = __BurnerState::High;
                    }
                }
            }
            __BurnerState::High => {
                if self.delay0_out {
                    self.situation = __BurnerState::Failed;
                } else {
                    if !inputs_.demand {
                        self.situation = __BurnerState::Standby;
                        self.sd_ff_pump = false;
                    }
                }
            }
            __BurnerState::Failed => {
                if inputs_.ack {
                    self.situation = __BurnerState::Standby;
                    self.sd_ff_pump = false;
                }
            }
        }
        if was_state_ != self.situation {
            self.since = now_;
        }
        let mut on_standby_2__: bool = false;
        match self.situation {
            __BurnerState::Standby => {
                on_standby_2__ = true;
                outputs_.ready = true;
            }
            __BurnerState::Purge => {
                outputs_.fan = true;
            }
            __BurnerState::Ignite => {
                outputs_.fan = true;
                outputs_.spark = true;
                outputs_.gas = true;
            }
            __BurnerState::Low | __BurnerState::High => {
                outputs_.fan = true;
                outputs_.gas = true;
            }
            __BurnerState::Failed => {
                outputs_.alarm = true;
            }
            _ => {}
        }
        self.sd_tmr_pump_held = if self.sd_ff_pump && self.sd_tmr_pump_in {
            self.sd_tmr_pump_held + elapsed_
        } else {
            Ticks::ZERO
        };
        self.sd_tmr_pump_in = self.sd_ff_pump;
        outputs_.pump = !on_standby_2__ && self.sd_tmr_pump_in
            && self.sd_tmr_pump_held >= Ticks::new(500u32);
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
        if self.situation == __BurnerState::Purge
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
        if self.situation == __BurnerState::Ignite
            && self.reading.since(self.since) < Ticks::new(1000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(1000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __BurnerState::Low
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
        if self.delay0_in != self.delay0_out {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    (if self.delay0_in {
                        Ticks::new(300u32)
                    } else {
                        Ticks::ZERO
                    }) - self.reading.since(self.delay0_since),
                ),
            );
        }
        if self.sd_tmr_pump_in
            && self.sd_tmr_pump_held < Ticks::new(500u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(500u32) - self.sd_tmr_pump_held,
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
