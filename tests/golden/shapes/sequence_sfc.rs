// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Lamp {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(&mut self, inputs: &LampInputs) -> LampOutputs {
        let mut outputs = LampOutputs { lamp: false };
        let before = self.situation;
        let after = match before {
            __LampState::Off => {
                if inputs.on { __LampState::On } else { __LampState::Off }
            }
            __LampState::On => {
                if inputs.off { __LampState::Off } else { __LampState::On }
            }
            __LampState::INIT => __LampState::Off,
        };
        self.situation = after;
        let in_second = after == __LampState::On;
        outputs.lamp |= in_second;
        outputs
    }
}
