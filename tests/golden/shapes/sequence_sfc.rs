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
        let elapsed = now.since(self.now);
        self.now = now;
        self.since = self.since + elapsed;
        let before = self.situation;
        self.settled = true;
        let since_before = self.since;
        let after = match before {
            __LampState::Off => {
                if inputs.on {
                    self.since = Ticks::ZERO;
                    self.settled = false;
                    __LampState::On
                } else {
                    __LampState::Off
                }
            }
            __LampState::On => {
                if self.since >= Ticks::new(5000u32) {
                    self.settled = false;
                    __LampState::Off
                } else {
                    __LampState::On
                }
            }
            __LampState::INIT => {
                self.settled = false;
                __LampState::Off
            }
        };
        self.situation = after;
        let in_second = after == __LampState::On;
        outputs.lamp |= in_second;
        outputs
    }
}
