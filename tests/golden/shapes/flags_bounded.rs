// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Lamp {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(&mut self, inputs: &LampInputs) -> LampOutputs {
        let mut outputs = LampOutputs { lamp: false };
        self.situation[0usize] &= !4u8;
        let mut evolutions_left: u32 = 6;
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
                    if inputs.off {
                        after[0usize] &= !2u8;
                        after[0usize] |= 1u8;
                        moved = true;
                    }
                }
            }
            if !moved {
                break;
            }
            if evolutions_left == 0 {
                self.situation[0usize] |= 4u8;
                break;
            }
            evolutions_left -= 1;
            self.situation = after;
        }
        let after = self.situation;
        if after[0usize] & 2u8 != 0 {
            outputs.lamp = true;
        }
        outputs
    }
}
