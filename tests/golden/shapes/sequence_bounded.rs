// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Lamp {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(&mut self, inputs: &LampInputs) -> LampOutputs {
        let mut outputs = LampOutputs { lamp: false };
        self.situation = self.situation.unmarked();
        let mut evolutions_left: u32 = 8;
        let mut rising_now_0 = false;
        loop {
            let inputs = core::hint::black_box(inputs);
            let before = self.situation.state();
            let edge_before_0 = self.edge_0;
            let value: bool = inputs.next;
            rising_now_0 = value && !self.edge_0;
            self.edge_0 = value;
            let after = match before {
                __LampState::Off => if inputs.on { __LampState::On } else { break }
                __LampState::On => {
                    if inputs.off {
                        __LampState::Off
                    } else if {
                        let rising_0 = rising_now_0;
                        let off = inputs.off;
                        rising_0 && !off
                    } {
                        __LampState::Bright
                    } else {
                        break
                    }
                }
                __LampState::Bright => if inputs.off { __LampState::Off } else { break }
            };
            if evolutions_left == 0 {
                self.edge_0 = edge_before_0;
                self.situation = self.situation.marked();
                break;
            }
            evolutions_left -= 1;
            self.situation = __LampStateMark::of(after);
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        let after = self.situation.state();
        match after {
            __LampState::On => {
                outputs.lamp = true;
            }
            __LampState::Bright => {
                outputs.lamp = true;
            }
            _ => {}
        }
        outputs
    }
}
