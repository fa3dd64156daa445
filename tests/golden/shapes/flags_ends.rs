// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Lamp {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(&mut self, inputs: &LampInputs) -> LampOutputs {
        let mut outputs = LampOutputs { lamp: false };
        loop {
            let inputs = core::hint::black_box(inputs);
            let before = self.situation;
            let mut after = before;
            let mut moved = false;
            if before[0usize] & 3u8 != 0 {
                if before[0usize] & 1u8 != 0 {
                    if inputs.on {
                        after[0usize] &= !1u8;
                        after[0usize] |= 2u8;
                        moved = true;
                    }
                } else if before[0usize] & 2u8 != 0 {
                    if !inputs.on {
                        after[0usize] &= !2u8;
                        after[0usize] |= 1u8;
                        moved = true;
                    }
                }
            }
            if !moved {
                break;
            }
            self.situation = after;
        }
        let after = self.situation;
        if after[0usize] & 2u8 != 0 {
            outputs.lamp = true;
        }
        outputs
    }
}
