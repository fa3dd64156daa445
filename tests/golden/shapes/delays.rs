// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

#[repr(u32)]
enum __VatState {
    Idle,
    Fill,
    Heat,
    INIT,
}
struct __VatStateMark(u8);
impl __VatStateMark {
    const fn of(state_: __VatState) -> Self {
        Self(state_ as u8)
    }
    const fn state(self) -> __VatState {
        let number_ = self.0 & 3u8;
        if number_ >= 3u8 {
            __VatState::INIT
        } else {
            match number_ {
                0u8 => __VatState::Idle,
                1u8 => __VatState::Fill,
                _ => __VatState::Heat,
            }
        }
    }
    /// Another state, and the mark as it is.
    const fn with(self, state_: __VatState) -> Self {
        Self(self.0 & 4u8 | state_ as u8)
    }
    const fn unmarked(self) -> Self {
        Self(self.0 & 3u8)
    }
    const fn marked(self) -> Self {
        Self(self.0 | 4u8)
    }
    const fn is_marked(self) -> bool {
        self.0 & 4u8 != 0
    }
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
        if inputs_.stop {
            self.delay0_stage = 2;
        } else {
            if self.delay0_stage == 2 {
                self.delay0_since = now_;
                self.delay0_stage = 3;
            } else {
                if self.delay0_stage == 3
                    && has_reached!(
                        now_.since(self.delay0_since),
                        Ticks::new(500u32)
                    )
                {
                    self.delay0_stage = 0;
                }
            }
        }
        if inputs_.full {
            if self.delay1_stage == 3 {
                self.delay1_stage = 2;
            } else {
                if self.delay1_stage == 0 {
                    self.delay1_since = now_;
                    self.delay1_stage = 1;
                } else {
                    if self.delay1_stage == 1
                        && has_reached!(
                            now_.since(self.delay1_since),
                            Ticks::new(1000u32)
                        )
                    {
                        self.delay1_stage = 2;
                    }
                }
            }
        } else {
            if self.delay1_stage == 1 {
                self.delay1_stage = 0;
            } else {
                if self.delay1_stage == 2 {
                    self.delay1_since = now_;
                    self.delay1_stage = 3;
                } else {
                    if self.delay1_stage == 3
                        && has_reached!(
                            now_.since(self.delay1_since),
                            Ticks::new(200u32)
                        )
                    {
                        self.delay1_stage = 0;
                    }
                }
            }
        }
        if inputs_.hot {
            if self.delay2_stage == 0 {
                self.delay2_since = now_;
                self.delay2_stage = 1;
            } else {
                if self.delay2_stage == 1
                    && has_reached!(
                        now_.since(self.delay2_since),
                        Ticks::new(3000u32)
                    )
                {
                    self.delay2_stage = 2;
                }
            }
        } else {
            self.delay2_stage = 0;
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        let first_: bool = self.situation.state()
            == __VatState::INIT;
        if first_ {
            self.situation = self.situation.with(__VatState::Idle);
        }
        self.reading = now_;
        let mut now_state_: __VatState = self.situation.state();
        self.situation = __VatStateMark::of(now_state_);
        self.situation = self.situation.unmarked();
        let mut evolutions_: u32 = 0;
        loop {
            let inputs_ = core::hint::black_box(inputs_);
            fence_on_armv6m();
            match now_state_ {
                __VatState::Idle => {
                    if self.delay0_stage != 0 {
                        now_state_ = __VatState::Fill;
                    } else {
                        break;
                    }
                }
                __VatState::Fill => {
                    if self.delay1_stage >= 2 {
                        now_state_ = __VatState::Heat;
                    } else {
                        break;
                    }
                }
                __VatState::Heat => {
                    if self.delay2_stage == 2 || inputs_.stop {
                        now_state_ = __VatState::Idle;
                    } else {
                        break;
                    }
                }
                _ => {
                    break;
                }
            }
            self.situation = __VatStateMark::of(now_state_);
            self.situation = self.situation.unmarked();
            evolutions_ = evolutions_.wrapping_add(1);
            if evolutions_ == 8 {
                self.situation = self.situation.marked();
                break;
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.situation.state() {
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
        if !(!(self.situation.state() == __VatState::INIT)
            && !self.situation.is_marked())
        {
            return Option::Some(self.reading);
        }
        let mut soonest_ = Option::None;
        if self.delay0_stage == 3 {
            soonest_ = earlier(
                soonest_,
                self.delay0_since.after(Ticks::new(500u32)),
            );
        }
        if self.delay1_stage == 1 {
            soonest_ = earlier(
                soonest_,
                self.delay1_since.after(Ticks::new(1000u32)),
            );
        }
        if self.delay1_stage == 3 {
            soonest_ = earlier(
                soonest_,
                self.delay1_since.after(Ticks::new(200u32)),
            );
        }
        if self.delay2_stage == 1 {
            soonest_ = earlier(
                soonest_,
                self.delay2_since.after(Ticks::new(3000u32)),
            );
        }
        soonest_
    }
}
