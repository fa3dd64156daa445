// Recorded by `cargo xtask bless`: state and cycle of the program, without the facade's path.

pub struct Motor {
    situation: __MotorState,
}
impl Motor {
    pub const fn new() -> Self {
        Self {
            situation: __MotorState::INIT,
        }
    }
}
impl Motor {
    pub fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &MotorInputs,
        #[cfg(doc)]
        inputs: &MotorInputs,
    ) -> MotorOutputs {
        let mut outputs_ = const {
            MotorOutputs {
                relay: false,
                green: false,
                red: false,
            }
        };
        let after_: __MotorState;
        match self.situation {
            __MotorState::INIT => {
                after_ = __MotorState::Off;
            }
            __MotorState::Off => {
                if inputs_.on & !inputs_.over_temp {
                    after_ = __MotorState::On;
                } else {
                    after_ = __MotorState::Off;
                }
            }
            __MotorState::On => {
                if inputs_.off | inputs_.over_temp {
                    after_ = __MotorState::Off;
                } else {
                    after_ = __MotorState::On;
                }
            }
        }
        self.situation = after_;
        match after_ {
            __MotorState::Off => {
                outputs_ = const {
                    MotorOutputs {
                        relay: false,
                        green: false,
                        red: true,
                    }
                };
            }
            __MotorState::On => {
                outputs_ = const {
                    MotorOutputs {
                        relay: true,
                        green: true,
                        red: false,
                    }
                };
            }
            _ => {
                outputs_ = const {
                    MotorOutputs {
                        relay: false,
                        green: false,
                        red: false,
                    }
                };
            }
        }
        outputs_
    }
}
