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
        let mut outputs_ = const {
            LongOutputs {
                lamp: false,
                horn: false,
            }
        };
        #[derive(
            core::clone::Clone,
            core::marker::Copy
        )]
        enum __Kind4 {
            K0,
            K1,
            K2,
        }
        let kind_: __Kind4 = {
            const KINDS: [__Kind4; 25usize] = [
                __Kind4::K0,
                __Kind4::K1,
                __Kind4::K0,
                __Kind4::K1,
                __Kind4::K0,
                __Kind4::K1,
                __Kind4::K0,
                __Kind4::K1,
                __Kind4::K0,
                __Kind4::K1,
                __Kind4::K0,
                __Kind4::K1,
                __Kind4::K0,
                __Kind4::K1,
                __Kind4::K0,
                __Kind4::K1,
                __Kind4::K0,
                __Kind4::K1,
                __Kind4::K0,
                __Kind4::K1,
                __Kind4::K0,
                __Kind4::K1,
                __Kind4::K0,
                __Kind4::K1,
                __Kind4::K2,
            ];
            match <[_]>::get(&KINDS, self.situation as usize) {
                Option::Some(found_) => *found_,
                Option::None => KINDS[0],
            }
        };
        let goes_: bool;
        match kind_ {
            __Kind4::K2 => {
                goes_ = true;
            }
            __Kind4::K0 => {
                goes_ = inputs_.a;
            }
            __Kind4::K1 => {
                goes_ = inputs_.b;
            }
        }
        if goes_ {
            self.situation = match self.situation {
                __LongState::S23 => __LongState::S0,
                __LongState::INIT => __LongState::S0,
                _ => {
                    match self.situation {
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
        }
        #[derive(
            core::clone::Clone,
            core::marker::Copy
        )]
        enum __Kind5 {
            K0,
            K1,
            K2,
        }
        let kind_2__: __Kind5 = {
            const KINDS: [__Kind5; 25usize] = [
                __Kind5::K0,
                __Kind5::K1,
                __Kind5::K0,
                __Kind5::K1,
                __Kind5::K0,
                __Kind5::K1,
                __Kind5::K0,
                __Kind5::K1,
                __Kind5::K0,
                __Kind5::K1,
                __Kind5::K0,
                __Kind5::K1,
                __Kind5::K0,
                __Kind5::K1,
                __Kind5::K0,
                __Kind5::K1,
                __Kind5::K0,
                __Kind5::K1,
                __Kind5::K0,
                __Kind5::K1,
                __Kind5::K0,
                __Kind5::K1,
                __Kind5::K0,
                __Kind5::K1,
                __Kind5::K2,
            ];
            match <[_]>::get(&KINDS, self.situation as usize) {
                Option::Some(found_) => *found_,
                Option::None => KINDS[0],
            }
        };
        match kind_2__ {
            __Kind5::K0 => {
                outputs_ = const {
                    LongOutputs {
                        lamp: true,
                        horn: false,
                    }
                };
            }
            __Kind5::K1 => {
                outputs_ = const {
                    LongOutputs {
                        lamp: false,
                        horn: true,
                    }
                };
            }
            __Kind5::K2 => {
                outputs_ = const {
                    LongOutputs {
                        lamp: false,
                        horn: false,
                    }
                };
            }
        }
        outputs_
    }
}
