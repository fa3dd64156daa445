// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

#[repr(u32)]
enum __LampState {
    Off,
    On,
    Rest,
}
struct __LampStateMark(u8);
impl __LampStateMark {
    const fn of(state_: __LampState) -> Self {
        Self(state_ as u8)
    }
    const fn state(self) -> __LampState {
        let number_ = self.0 & 3u8;
        if number_ >= 2u8 {
            __LampState::Rest
        } else {
            match number_ {
                0u8 => __LampState::Off,
                _ => __LampState::On,
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
                        if {
                            let pushed = self.pushed;
                            pushed < 3
                        } {
                            let next_pushed_: core::primitive::u8 = {
                                let pushed = self.pushed;
                                (pushed + 1) % 4
                            };
                            if evolutions_ == 8 {
                                self.situation = self.situation.marked();
                                break;
                            } else {
                                now_state_ = __LampState::On;
                                self.pushed = next_pushed_;
                            }
                        } else {
                            now_state_ = __LampState::Rest;
                        }
                    } else {
                        break;
                    }
                }
                __LampState::On => {
                    if inputs_.off {
                        now_state_ = __LampState::Off;
                    } else {
                        break;
                    }
                }
                __LampState::Rest => {
                    if inputs_.off {
                        now_state_ = __LampState::Off;
                    } else {
                        break;
                    }
                }
            }
            if evolutions_ == 8 {
                self.situation = self.situation.marked();
                break;
            }
            self.situation = __LampStateMark::of(now_state_);
            self.situation = self.situation.unmarked();
            evolutions_ = evolutions_.wrapping_add(1);
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.situation.state() {
            __LampState::On => {
                outputs_.lamp = true;
            }
            _ => {}
        }
        outputs_
    }
}
