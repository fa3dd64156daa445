// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __LampState {
    Off,
    On,
    Bright,
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
        let mut outputs_ = const {
            LampOutputs {
                lamp: false,
                more: false,
            }
        };
        let mut now_state_: __LampState = self.situation;
        loop {
            let inputs_ = core::hint::black_box(inputs_);
            fence_on_armv6m();
            match now_state_ {
                __LampState::Off => {
                    if inputs_.on {
                        now_state_ = __LampState::On;
                    } else {
                        break;
                    }
                }
                __LampState::On => {
                    if inputs_.bright {
                        now_state_ = __LampState::Bright;
                    } else {
                        break;
                    }
                }
                __LampState::Bright => {
                    if !inputs_.on {
                        now_state_ = __LampState::Off;
                    } else {
                        break;
                    }
                }
            }
            self.situation = now_state_;
            if now_state_ == __LampState::Off {
                break;
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.situation {
            __LampState::On => {
                outputs_ = const {
                    LampOutputs {
                        lamp: true,
                        more: false,
                    }
                };
            }
            __LampState::Bright => {
                outputs_ = const {
                    LampOutputs {
                        lamp: true,
                        more: true,
                    }
                };
            }
            _ => {
                outputs_ = const {
                    LampOutputs {
                        lamp: false,
                        more: false,
                    }
                };
            }
        }
        outputs_
    }
}
