// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Lamp {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(&mut self, inputs: &LampInputs) -> LampOutputs {
        let mut outputs = LampOutputs { lamp: false };
        let before = self.situation;
        let mut after = before;
        if before[0usize] & 4u8 != 0 {
            after = [1u8];
        } else {
            if before[0usize] & 3u8 != 0 {
                if before[0usize] & 1u8 != 0 {
                    if inputs.on {
                        after[0usize] &= !1u8;
                        after[0usize] |= 2u8;
                    }
                } else if before[0usize] & 2u8 != 0 {
                    if inputs.off {
                        after[0usize] &= !2u8;
                        after[0usize] |= 1u8;
                    }
                }
            }
        }
        self.situation = after;
        if after[0usize] & 2u8 != 0 {
            outputs.lamp = true;
        }
        outputs
    }
}
