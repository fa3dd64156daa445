// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __WinchState {
    Rest,
    Up,
    Down,
    INIT,
}
impl Winch {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &WinchInputs,
        #[cfg(doc)]
        inputs: &WinchInputs,
    ) -> WinchOutputs {
        let mut outputs_ = const {
            WinchOutputs {
                up: false,
                down: false,
            }
        };
        let after_: __WinchState;
        match self.situation {
            __WinchState::INIT => {
                after_ = __WinchState::Rest;
            }
            __WinchState::Rest => {
                if inputs_.up_key {
                    after_ = __WinchState::Up;
                } else {
                    if inputs_.down_key {
                        after_ = __WinchState::Down;
                    } else {
                        after_ = __WinchState::Rest;
                    }
                }
            }
            __WinchState::Up => {
                if !inputs_.up_key {
                    after_ = __WinchState::Rest;
                } else {
                    after_ = __WinchState::Up;
                }
            }
            __WinchState::Down => {
                if !inputs_.down_key {
                    after_ = __WinchState::Rest;
                } else {
                    after_ = __WinchState::Down;
                }
            }
        }
        self.situation = after_;
        match after_ {
            __WinchState::Up => {
                outputs_ = const {
                    WinchOutputs {
                        up: true,
                        down: false,
                    }
                };
            }
            __WinchState::Down => {
                outputs_ = const {
                    WinchOutputs {
                        up: false,
                        down: true,
                    }
                };
            }
            _ => {
                outputs_ = const {
                    WinchOutputs {
                        up: false,
                        down: false,
                    }
                };
            }
        }
        outputs_
    }
}
