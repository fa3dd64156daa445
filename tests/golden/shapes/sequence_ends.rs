// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Lamp {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(&mut self, inputs: &LampInputs) -> LampOutputs {
        let mut outputs = LampOutputs {
            lamp: false,
            more: false,
        };
        loop {
            let inputs = core::hint::black_box(inputs);
            let before = self.situation;
            let after = match before {
                __LampState::Off => if inputs.on { __LampState::On } else { break }
                __LampState::On => {
                    if inputs.bright { __LampState::Bright } else { break }
                }
                __LampState::Bright => if !inputs.on { __LampState::Off } else { break }
            };
            self.situation = after;
            if core::matches!(after, __LampState::Off) {
                break;
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        let after = self.situation;
        match after {
            __LampState::On => {
                outputs.lamp = true;
            }
            __LampState::Bright => {
                outputs.lamp = true;
                outputs.more = true;
            }
            _ => {}
        }
        outputs
    }
}
