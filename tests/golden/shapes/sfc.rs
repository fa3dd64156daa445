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
        let after_: __LampState;
        match self.situation {
            __LampState::INIT => {
                after_ = __LampState::Off;
            }
            __LampState::Off => {
                if inputs_.on {
                    after_ = __LampState::On;
                } else {
                    after_ = __LampState::Off;
                }
            }
            __LampState::On => {
                if inputs_.off {
                    after_ = __LampState::Off;
                } else {
                    after_ = __LampState::On;
                }
            }
        }
        self.situation = after_;
        match after_ {
            __LampState::On => {
                outputs_.lamp = true;
            }
            _ => {}
        }
        outputs_
    }
}
