// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

#[repr(u32)]
enum __LampState {
    Off,
    On,
    Bright,
    INIT,
}
struct __LampStateMark(u8);
impl __LampStateMark {
    const fn of(state_: __LampState) -> Self {
        Self(state_ as u8)
    }
    const fn state(self) -> __LampState {
        let number_ = self.0 & 3u8;
        if number_ >= 3u8 {
            __LampState::INIT
        } else {
            match number_ {
                0u8 => __LampState::Off,
                1u8 => __LampState::On,
                _ => __LampState::Bright,
            }
        }
    }
    /// Another state, and the mark as it is.
    const fn with(self, state_: __LampState) -> Self {
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
impl Lamp {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &LampInputs,
        #[cfg(doc)]
        inputs: &LampInputs,
    ) -> LampOutputs {
        let mut outputs_ = LampOutputs { lamp: false };
        let first_: bool = self.situation.state()
            == __LampState::INIT;
        if first_ {
            self.situation = self.situation.with(__LampState::Off);
        }
        let mut now_state_: __LampState = self.situation.state();
        self.situation = __LampStateMark::of(now_state_);
        self.situation = self.situation.unmarked();
        let mut evolutions_: u32 = 0;
        loop {
            let inputs_ = core::hint::black_box(inputs_);
            fence_on_armv6m();
            match now_state_ {
                __LampState::Off => {
                    if inputs_.on {
                        if evolutions_ == 8 {
                            self.situation = self.situation.marked();
                            break;
                        } else {
                            now_state_ = __LampState::On;
                        }
                    } else {
                        break;
                    }
                }
                __LampState::On => {
                    if inputs_.off {
                        if evolutions_ == 8 {
                            self.situation = self.situation.marked();
                            break;
                        } else {
                            now_state_ = __LampState::Off;
                        }
                    } else {
                        if !self.edge0_before && inputs_.next {
                            if evolutions_ == 8 {
                                self.situation = self.situation.marked();
                                break;
                            } else {
                                now_state_ = __LampState::Bright;
                            }
                        } else {
                            break;
                        }
                    }
                }
                __LampState::Bright => {
                    if inputs_.off {
                        if evolutions_ == 8 {
                            self.situation = self.situation.marked();
                            break;
                        } else {
                            now_state_ = __LampState::Off;
                        }
                    } else {
                        break;
                    }
                }
                _ => {
                    break;
                }
            }
            self.situation = __LampStateMark::of(now_state_);
            self.situation = self.situation.unmarked();
            self.edge0_before = inputs_.next;
            evolutions_ = evolutions_.wrapping_add(1);
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.situation.state() {
            __LampState::On | __LampState::Bright => {
                outputs_.lamp = true;
            }
            _ => {}
        }
        if !self.situation.is_marked() {
            self.edge0_before = inputs_.next;
        }
        outputs_
    }
}
impl Lamp {
    /// One cycle that leads into a situation by hand, whatever the transition conditions say (decision A38): no transition clears, steps that
    /// are not named are left, named ones entered, each with its actions, and nothing of the steps in between runs.
    ///
    /// For commissioning: nothing that the compiler has proved of the chart's ways holds on this one.
    ///
    /// # Errors
    /// The chart is never in exactly these steps; then nothing has happened.
    #[allow(unused_assignments, unused_mut, unused_variables)]
    fn force(
        &mut self,
        #[cfg(not(doc))]
        steps_: &[LampStep],
        #[cfg(doc)]
        steps: &[LampStep],
        #[cfg(not(doc))]
        inputs_: &LampInputs,
        #[cfg(doc)]
        inputs: &LampInputs,
    ) -> Result<
        LampOutputs,
        ForceError<LampStep>,
    > {
        Possible::Alone
            .look(<Self as Chart>::STEPS, steps_)?;
        let mut forced0_: Option<__LampState> = Option::None;
        for step_ in steps_ {
            match *step_ {
                LampStep::Off => {
                    forced0_ = Option::Some(__LampState::Off);
                }
                LampStep::On => {
                    forced0_ = Option::Some(__LampState::On);
                }
                LampStep::Bright => {
                    forced0_ = Option::Some(__LampState::Bright);
                }
            }
        }
        let forced0_ = match forced0_ {
            Option::Some(state_) => state_,
            Option::None => {
                return Result::Err(
                    ForceError::NoSituation,
                );
            }
        };
        Result::Ok({
            let mut outputs_ = LampOutputs { lamp: false };
            let edge0_now_: bool = inputs_.next;
            self.situation = self.situation.with(forced0_);
            self.edge0_before = edge0_now_;
            let was_state_: __LampState = self.situation.state();
            self.situation = self.situation.unmarked();
            let next_lamp_: bool = was_state_ == __LampState::On
                || was_state_ == __LampState::Bright;
            outputs_.lamp = next_lamp_;
            outputs_
        })
    }
}
