// Recorded by `cargo xtask bless`: state and cycle of the program, without the facade's path.

pub struct Motor {
    state: __MotorState,
}
impl Motor {
    pub const fn new() -> Self {
        Self { state: __MotorState::INIT }
    }
}
impl Motor {
    pub fn cycle(&mut self, inputs: &MotorInputs) -> MotorOutputs {
        let mut outputs = MotorOutputs {
            relay: false,
            green: false,
            red: false,
        };
        match self.state {
            __MotorState::INIT => {
                self.state = __MotorState::Off;
            }
            __MotorState::Off => {
                if inputs.on && !inputs.over_temp {
                    self.state = __MotorState::On;
                }
            }
            __MotorState::On => {
                if inputs.off || inputs.over_temp {
                    self.state = __MotorState::Off;
                }
            }
        }
        match self.state {
            __MotorState::Off => {
                outputs.red = true;
            }
            __MotorState::On => {
                outputs.relay = true;
                outputs.green = true;
            }
            _ => {}
        }
        outputs
    }
}
