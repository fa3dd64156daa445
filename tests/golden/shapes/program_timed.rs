// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Lamp {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        inputs: &LampInputs,
        now: impl core::convert::Into<Ticks>,
    ) -> LampOutputs {
        let now: Ticks = core::convert::Into::into(
            now,
        );
        let mut outputs = LampOutputs { lamp: false };
        let was_state: __LampState = self.situation;
        self.before_state = self.situation;
        self.reading = now;
        let passed: Ticks = now.since(self.since);
        match self.situation {
            __LampState::INIT => {
                self.situation = __LampState::Off;
            }
            __LampState::Off => {
                if inputs.on {
                    self.situation = __LampState::On;
                }
            }
            __LampState::On => {
                if passed >= Ticks::new(5000u32) {
                    self.situation = __LampState::Dim;
                    outputs.lamp = true;
                }
            }
            __LampState::Dim => {
                if !inputs.on && passed >= Ticks::new(3000u32) {
                    self.situation = __LampState::Off;
                } else {
                    outputs.lamp = passed < Ticks::new(2000u32);
                    if passed >= Ticks::new(3000u32) {
                        self.since = now
                            .since(Ticks::new(3000u32));
                    }
                }
            }
        }
        if was_state != self.situation {
            self.since = now;
        }
        match self.situation {
            __LampState::On => {
                outputs.lamp = true;
            }
            _ => {}
        }
        outputs
    }
}
