// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Long {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(&mut self, inputs: &LongInputs) -> LongOutputs {
        let mut outputs = LongOutputs { lamp: false };
        let before = self.situation;
        let after = 'evolved: {
            {
                enum Kind {
                    K0,
                    K1,
                    K2,
                }
                const KINDS: [Kind; 25usize] = [
                    Kind::K0,
                    Kind::K1,
                    Kind::K0,
                    Kind::K1,
                    Kind::K0,
                    Kind::K1,
                    Kind::K0,
                    Kind::K1,
                    Kind::K0,
                    Kind::K1,
                    Kind::K0,
                    Kind::K1,
                    Kind::K0,
                    Kind::K1,
                    Kind::K0,
                    Kind::K1,
                    Kind::K0,
                    Kind::K1,
                    Kind::K0,
                    Kind::K1,
                    Kind::K0,
                    Kind::K1,
                    Kind::K0,
                    Kind::K1,
                    Kind::K2,
                ];
                match KINDS.get(before as usize) {
                    core::option::Option::Some(Kind::K0) => {
                        if inputs.a {} else { break 'evolved before }
                    }
                    core::option::Option::Some(Kind::K1) => {
                        if inputs.b {} else { break 'evolved before }
                    }
                    core::option::Option::Some(Kind::K2) => {}
                    _ => {}
                }
            }
            let next = match before {
                __LongState::S23 => __LongState::S0,
                __LongState::INIT => __LongState::S0,
                _ => {
                    match before {
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
                        __LongState::S23 => __LongState::S23,
                        __LongState::INIT => __LongState::S0,
                    }
                }
            };
            self.situation = next;
            next
        };
        match after {
            __LongState::S5 => {
                outputs.lamp = true;
            }
            _ => {}
        }
        outputs
    }
}
