// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __VatState {
    Idle,
    Fill,
    Heat,
    INIT,
}
impl Vat {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &VatInputs,
        #[cfg(doc)]
        inputs: &VatInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> VatOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = const {
            VatOutputs {
                pump: false,
                heat: false,
            }
        };
        let first_: bool = self.situation == __VatState::INIT;
        if first_ {
            self.situation = __VatState::Idle;
        }
        self.reading = now_;
        if inputs_.stop {
            self.delay0_in = true;
            self.delay0_out = true;
        } else {
            if self.delay0_in {
                self.delay0_since = now_;
                self.delay0_in = false;
            } else {
                if self.delay0_out
                    && has_reached!(
                        now_.since(self.delay0_since),
                        Ticks::new(500u32)
                    )
                {
                    self.delay0_out = false;
                }
            }
        }
        if inputs_.full {
            if !self.delay1_in {
                self.delay1_since = now_;
                self.delay1_in = true;
            } else {
                if !self.delay1_out
                    && has_reached!(
                        now_.since(self.delay1_since),
                        Ticks::new(1000u32)
                    )
                {
                    self.delay1_out = true;
                }
            }
        } else {
            if self.delay1_in {
                self.delay1_since = now_;
                self.delay1_in = false;
            } else {
                if self.delay1_out
                    && has_reached!(
                        now_.since(self.delay1_since),
                        Ticks::new(200u32)
                    )
                {
                    self.delay1_out = false;
                }
            }
        }
        if inputs_.hot {
            if !self.delay2_in {
                self.delay2_since = now_;
                self.delay2_in = true;
            } else {
                if !self.delay2_out
                    && has_reached!(
                        now_.since(self.delay2_since),
                        Ticks::new(3000u32)
                    )
                {
                    self.delay2_out = true;
                }
            }
        } else {
            self.delay2_in = false;
            self.delay2_out = false;
        }
        let mut now_state_: __VatState = self.situation;
        self.situation = now_state_;
        self.stable = true;
        let mut evolutions_: u32 = 0;
        loop {
            let inputs_ = core::hint::black_box(inputs_);
            fence_on_armv6m();
            match now_state_ {
                __VatState::Idle => {
                    if self.delay0_out {
                        now_state_ = __VatState::Fill;
                    } else {
                        break;
                    }
                }
                __VatState::Fill => {
                    if self.delay1_out {
                        now_state_ = __VatState::Heat;
                    } else {
                        break;
                    }
                }
                __VatState::Heat => {
                    if self.delay2_out || inputs_.stop {
                        now_state_ = __VatState::Idle;
                    } else {
                        break;
                    }
                }
                _ => {
                    break;
                }
            }
            self.situation = now_state_;
            self.stable = true;
            evolutions_ = evolutions_.wrapping_add(1);
            if evolutions_ == 8 {
                self.stable = false;
                break;
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.situation {
            __VatState::Fill => {
                outputs_ = const {
                    VatOutputs {
                        pump: true,
                        heat: false,
                    }
                };
            }
            __VatState::Heat => {
                outputs_ = const {
                    VatOutputs {
                        pump: false,
                        heat: true,
                    }
                };
            }
            _ => {
                outputs_ = const {
                    VatOutputs {
                        pump: false,
                        heat: false,
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
        if !(!(self.situation == __VatState::INIT) && self.stable) {
            return Option::Some(self.reading);
        }
        let mut soonest_ = Option::None;
        if self.delay0_in != self.delay0_out {
            soonest_ = earlier(
                soonest_,
                self
                    .delay0_since
                    .after(
                        if self.delay0_in {
                            Ticks::ZERO
                        } else {
                            Ticks::new(500u32)
                        },
                    ),
            );
        }
        if self.delay1_in != self.delay1_out {
            soonest_ = earlier(
                soonest_,
                self
                    .delay1_since
                    .after(
                        if self.delay1_in {
                            Ticks::new(1000u32)
                        } else {
                            Ticks::new(200u32)
                        },
                    ),
            );
        }
        if self.delay2_in != self.delay2_out {
            soonest_ = earlier(
                soonest_,
                self
                    .delay2_since
                    .after(
                        if self.delay2_in {
                            Ticks::new(3000u32)
                        } else {
                            Ticks::ZERO
                        },
                    ),
            );
        }
        soonest_
    }
}
