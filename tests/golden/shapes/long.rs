// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __LongState {
    S0,
    S1,
    S2,
    S3,
    S4,
    S5,
    S6,
    S7,
    S8,
    S9,
    S10,
    S11,
    S12,
    S13,
    S14,
    S15,
    S16,
    S17,
    S18,
    S19,
    S20,
    S21,
    S22,
    S23,
    INIT,
}
impl Long {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &LongInputs,
        #[cfg(doc)]
        inputs: &LongInputs,
    ) -> LongOutputs {
        let mut outputs_ = LongOutputs { lamp: false };
        let mut after_: __LongState = self.situation;
        'once: {
            match self.situation {
                __LongState::INIT => {}
                __LongState::S0
                | __LongState::S2
                | __LongState::S4
                | __LongState::S6
                | __LongState::S8
                | __LongState::S10
                | __LongState::S12
                | __LongState::S14
                | __LongState::S16
                | __LongState::S18
                | __LongState::S20
                | __LongState::S22 => {
                    if !inputs_.a {
                        break 'once;
                    }
                }
                __LongState::S1
                | __LongState::S3
                | __LongState::S5
                | __LongState::S7
                | __LongState::S9
                | __LongState::S11
                | __LongState::S13
                | __LongState::S15
                | __LongState::S17
                | __LongState::S19
                | __LongState::S21
                | __LongState::S23 => {
                    if !inputs_.b {
                        break 'once;
                    }
                }
            }
            after_ = {
                const TABLE: [__LongState; 25usize] = [
                    __LongState::S1,
                    __LongState::S2,
                    __LongState::S3,
                    __LongState::S4,
                    __LongState::S5,
                    __LongState::S6,
                    __LongState::S7,
                    __LongState::S8,
                    __LongState::S9,
                    __LongState::S10,
                    __LongState::S11,
                    __LongState::S12,
                    __LongState::S13,
                    __LongState::S14,
                    __LongState::S15,
                    __LongState::S16,
                    __LongState::S17,
                    __LongState::S18,
                    __LongState::S19,
                    __LongState::S20,
                    __LongState::S21,
                    __LongState::S22,
                    __LongState::S23,
                    __LongState::S0,
                    __LongState::S0,
                ];
                match <[_]>::get(&TABLE, after_ as usize) {
                    Option::Some(found_) => *found_,
                    Option::None => after_,
                }
            };
            self.situation = after_;
        }
        match after_ {
            __LongState::S5 => {
                outputs_.lamp = true;
            }
            _ => {}
        }
        outputs_
    }
}
