// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Lamp {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(&mut self, inputs: &LampInputs) -> LampOutputs {
        let mut outputs = LampOutputs { lamp: false };
        let mut now_state: __LampState = self.situation.state();
        self.situation = __LampStateMark::of(now_state);
        self.situation = self.situation.unmarked();
        let inputs = core::hint::black_box(inputs);
        let mut evolutions: u32 = 0;
        loop {
            match now_state {
                __LampState::Off => {
                    if inputs.on {
                        now_state = __LampState::On;
                    } else {
                        break;
                    }
                }
                __LampState::On => {
                    if inputs.off {
                        now_state = __LampState::Off;
                    } else {
                        break;
                    }
                }
            }
            self.situation = __LampStateMark::of(now_state);
            self.situation = self.situation.unmarked();
            evolutions = evolutions.wrapping_add(1);
            if evolutions == 6 {
                self.situation = self.situation.marked();
                break;
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.situation.state() {
            __LampState::On => {
                outputs.lamp = true;
            }
            _ => {}
        }
        outputs
    }
}
