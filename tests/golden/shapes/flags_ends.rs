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
        loop {
            let inputs_ = core::hint::black_box(inputs_);
            let before_ = self.situation;
            let mut after_ = before_;
            let mut moved_ = false;
            if before_[0usize] & 3u8 != 0 {
                if before_[0usize] & 1u8 != 0 {
                    if inputs_.on {
                        after_[0usize] &= !1u8;
                        after_[0usize] |= 2u8;
                        moved_ = true;
                    }
                } else if before_[0usize] & 2u8 != 0 {
                    if !inputs_.on {
                        after_[0usize] &= !2u8;
                        after_[0usize] |= 1u8;
                        moved_ = true;
                    }
                }
            }
            if !moved_ {
                break;
            }
            self.situation = after_;
        }
        let after_ = self.situation;
        if after_[0usize] & 2u8 != 0 {
            outputs_.lamp = true;
        }
        outputs_
    }
}
