// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __LampState {
    Off,
    On,
    INIT,
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
        match self.situation {
            __LampState::INIT => {
                self.situation = __LampState::Off;
                if inputs_.on {
                    self.situation = __LampState::On;
                }
            }
            __LampState::Off => {
                if inputs_.on {
                    self.situation = __LampState::On;
                }
            }
            __LampState::On => {
                if !inputs_.on {
                    self.situation = __LampState::Off;
                }
            }
        }
        match self.situation {
            __LampState::On => {
                outputs_.lamp = true;
            }
            _ => {}
        }
        outputs_
    }
}
