// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Lamp {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(&mut self, inputs: &LampInputs) -> LampOutputs {
        let mut outputs = const {
            LampOutputs {
                lamp: false,
                more: false,
            }
        };
        let mut now_state: __LampState = self.situation;
        loop {
            let inputs = core::hint::black_box(inputs);
            fence_on_armv6m();
            match now_state {
                __LampState::Off => {
                    if inputs.on {
                        now_state = __LampState::On;
                    } else {
                        break;
                    }
                }
                __LampState::On => {
                    if inputs.bright {
                        now_state = __LampState::Bright;
                    } else {
                        break;
                    }
                }
                __LampState::Bright => {
                    if !inputs.on {
                        now_state = __LampState::Off;
                    } else {
                        break;
                    }
                }
            }
            self.situation = now_state;
            if now_state == __LampState::Off {
                break;
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.situation {
            __LampState::On => {
                outputs = const {
                    LampOutputs {
                        lamp: true,
                        more: false,
                    }
                };
            }
            __LampState::Bright => {
                outputs = const {
                    LampOutputs {
                        lamp: true,
                        more: true,
                    }
                };
            }
            _ => {
                outputs = const {
                    LampOutputs {
                        lamp: false,
                        more: false,
                    }
                };
            }
        }
        outputs
    }
}
