// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Lamp {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(&mut self, inputs: &LampInputs) -> LampOutputs {
        let mut outputs = LampOutputs { lamp: false };
        let mut state = self.situation.state();
        self.situation = __LampStateMark::of(state);
        'search: {
            let inputs = core::hint::black_box(inputs);
            for _ in 0..6u32 {
                let before = state;
                let after = match before {
                    __LampState::Off => {
                        if inputs.on { __LampState::On } else { break 'search }
                    }
                    __LampState::On => {
                        if inputs.off { __LampState::Off } else { break 'search }
                    }
                };
                state = after;
                self.situation = __LampStateMark::of(after);
            }
            self.situation = self.situation.marked();
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        let after = self.situation.state();
        let in_second = after == __LampState::On;
        outputs.lamp |= in_second;
        outputs
    }
}
