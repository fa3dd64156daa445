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
    pub fn cycle(&mut self, inputs: &MotorInputs) -> MotorOutputs {
        let mut outputs = const {
            MotorOutputs {
                relay: false,
                green: false,
                red: false,
            }
        };
        let after: __MotorState;
        match self.situation {
            __MotorState::INIT => {
                after = __MotorState::Off;
            }
            __MotorState::Off => {
                if inputs.on & !inputs.over_temp {
                    after = __MotorState::On;
                } else {
                    after = __MotorState::Off;
                }
            }
            __MotorState::On => {
                if inputs.off | inputs.over_temp {
                    after = __MotorState::Off;
                } else {
                    after = __MotorState::On;
                }
            }
        }
        self.situation = after;
        match after {
            __MotorState::Off => {
                outputs = const {
                    MotorOutputs {
                        relay: false,
                        green: false,
                        red: true,
                    }
                };
            }
            __MotorState::On => {
                outputs = const {
                    MotorOutputs {
                        relay: true,
                        green: true,
                        red: false,
                    }
                };
            }
            _ => {
                outputs = const {
                    MotorOutputs {
                        relay: false,
                        green: false,
                        red: false,
                    }
                };
            }
        }
        outputs
    }
}
