// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

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
            #[derive(
                core::clone::Clone,
                core::marker::Copy
            )]
            enum __Kind3 {
                K0,
                K1,
                K2,
            }
            let kind_: __Kind3 = {
                const KINDS: [__Kind3; 25usize] = [
                    __Kind3::K1,
                    __Kind3::K2,
                    __Kind3::K1,
                    __Kind3::K2,
                    __Kind3::K1,
                    __Kind3::K2,
                    __Kind3::K1,
                    __Kind3::K2,
                    __Kind3::K1,
                    __Kind3::K2,
                    __Kind3::K1,
                    __Kind3::K2,
                    __Kind3::K1,
                    __Kind3::K2,
                    __Kind3::K1,
                    __Kind3::K2,
                    __Kind3::K1,
                    __Kind3::K2,
                    __Kind3::K1,
                    __Kind3::K2,
                    __Kind3::K1,
                    __Kind3::K2,
                    __Kind3::K1,
                    __Kind3::K2,
                    __Kind3::K0,
                ];
                match <[_]>::get(&KINDS, self.situation as usize) {
                    Option::Some(found_) => *found_,
                    Option::None => KINDS[0],
                }
            };
            match kind_ {
                __Kind3::K0 => {}
                __Kind3::K1 => {
                    if !inputs_.a {
                        break 'once;
                    }
                }
                __Kind3::K2 => {
                    if !inputs_.b {
                        break 'once;
                    }
                }
            }
            after_ = match after_ {
                __LongState::S23 => __LongState::S0,
                __LongState::INIT => __LongState::S0,
                _ => {
                    match after_ {
                        __LongState::S0 => __LongState::S1,
                        __LongState::S1 => __LongState::S2,
                        __LongState::S2 => __LongState::S3,
                        __LongState::S3 => __LongState::S4,
                        __LongState::S4 => __LongState::S5,
                        __LongState::S5 => __LongState::S6,
                        __LongState::S6 => __LongState::S7,
                        __LongState::S7 => __LongState::S8,
                        __LongState::S8 => __LongState::S9,
                        __LongState::S9 => __LongState::S10,
                        __LongState::S10 => __LongState::S11,
                        __LongState::S11 => __LongState::S12,
                        __LongState::S12 => __LongState::S13,
                        __LongState::S13 => __LongState::S14,
                        __LongState::S14 => __LongState::S15,
                        __LongState::S15 => __LongState::S16,
                        __LongState::S16 => __LongState::S17,
                        __LongState::S17 => __LongState::S18,
                        __LongState::S18 => __LongState::S19,
                        __LongState::S19 => __LongState::S20,
                        __LongState::S20 => __LongState::S21,
                        __LongState::S21 => __LongState::S22,
                        __LongState::S22 => __LongState::S23,
                        __LongState::S23 => __LongState::INIT,
                        __LongState::INIT => __LongState::INIT,
                    }
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
