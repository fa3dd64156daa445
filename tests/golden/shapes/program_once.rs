// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Lamp {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(&mut self, inputs: &LampInputs) -> LampOutputs {
        let mut outputs = LampOutputs { lamp: false };
        let after: __LampState;
        match self.situation {
            __LampState::Off => {
                if inputs.on {
                    after = __LampState::On;
                } else {
                    after = __LampState::Off;
                }
            }
            __LampState::On => {
                if !inputs.on {
                    after = __LampState::Off;
                } else {
                    after = __LampState::On;
                }
            }
        }
        self.situation = after;
        match after {
            __LampState::On => {
                outputs.lamp = true;
            }
            _ => {}
        }
        outputs
    }
}
