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
            if self.delay0_stage == 0 {
                self.delay0_since = now_;
                self.delay0_stage = 1;
            } else {
                if self.delay0_stage == 1
                    && has_reached!(
                        now_.since(self.delay0_since),
                        Ticks::new(300u32)
                    )
                {
                    self.delay0_stage = 2;
                }
            }
        } else {
            self.delay0_stage = 0;
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        let was_state_: __BurnerState = self.situation;
        self.before_state = self.situation;
        let passed_: Ticks = now_.since(self.since);
        match self.situation {
            __BurnerState::INIT => {
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
                if self.delay0_stage == 2 {
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
                if self.delay0_stage == 2 {
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
        if self.sd_ff_pump {
            if self.sd_tmr_pump_stage == 0 {
                self.sd_tmr_pump_since = now_;
                self.sd_tmr_pump_stage = 1;
            } else {
                if self.sd_tmr_pump_stage == 1
                    && has_reached!(
                        now_.since(self.sd_tmr_pump_since),
                        Ticks::new(500u32)
                    )
                {
                    self.sd_tmr_pump_stage = 2;
                }
            }
        } else {
            self.sd_tmr_pump_stage = 0;
        }
        outputs_.pump = !on_standby_2__ && self.sd_tmr_pump_stage == 2;
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
        if self.situation == __BurnerState::Purge {
            soonest_ = earlier(
                soonest_,
                self.since.after(Ticks::new(2000u32)),
            );
        }
        if self.situation == __BurnerState::Ignite {
            soonest_ = earlier(
                soonest_,
                self.since.after(Ticks::new(1000u32)),
            );
        }
        if self.situation == __BurnerState::Low {
            soonest_ = earlier(
                soonest_,
                self.since.after(Ticks::new(5000u32)),
            );
        }
        if self.delay0_stage == 1 {
            soonest_ = earlier(
                soonest_,
                self.delay0_since.after(Ticks::new(300u32)),
            );
        }
        if self.sd_tmr_pump_stage == 1 {
            soonest_ = earlier(
                soonest_,
                self.sd_tmr_pump_since.after(Ticks::new(500u32)),
            );
        }
        soonest_
    }
}
