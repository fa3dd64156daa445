// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

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
        let before_ = self.situation;
        let mut after_ = before_;
        if before_[0usize] & 4u8 != 0 {
            after_ = [1u8];
        } else {
            if before_[0usize] & 3u8 != 0 {
                if before_[0usize] & 1u8 != 0 {
                    if inputs_.on {
                        after_[0usize] &= !1u8;
                        after_[0usize] |= 2u8;
                    }
                } else if before_[0usize] & 2u8 != 0 {
                    if inputs_.off {
                        after_[0usize] &= !2u8;
                        after_[0usize] |= 1u8;
                    }
                }
            }
        }
        self.situation = after_;
        if after_[0usize] & 2u8 != 0 {
            outputs_.lamp = true;
        }
        outputs_
    }
}
