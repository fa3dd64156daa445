// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __NumberShownState {
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
    INIT,
}
impl NumberShown {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &NumberShownInputs,
        #[cfg(doc)]
        inputs: &NumberShownInputs,
    ) -> NumberShownOutputs {
        let mut outputs_ = NumberShownOutputs {
            phase: 9,
            p: false,
        };
        let mut after_: __NumberShownState = self.situation;
        'once: {
            match self.situation {
                __NumberShownState::INIT => {}
                __NumberShownState::S0
                | __NumberShownState::S3
                | __NumberShownState::S6
                | __NumberShownState::S9 => {
                    if !inputs_.a {
                        break 'once;
                    }
                }
                __NumberShownState::S1
                | __NumberShownState::S4
                | __NumberShownState::S7 => {
                    if !(inputs_.b & !inputs_.a) {
                        break 'once;
                    }
                }
                __NumberShownState::S2
                | __NumberShownState::S5
                | __NumberShownState::S8 => {
                    if inputs_.b {
                        break 'once;
                    }
                }
            }
            after_ = {
                const TABLE: [__NumberShownState; 11usize] = [
                    __NumberShownState::S1,
                    __NumberShownState::S2,
                    __NumberShownState::S3,
                    __NumberShownState::S4,
                    __NumberShownState::S5,
                    __NumberShownState::S6,
                    __NumberShownState::S7,
                    __NumberShownState::S8,
                    __NumberShownState::S9,
                    __NumberShownState::S0,
                    __NumberShownState::S0,
                ];
                match <[_]>::get(&TABLE, after_ as usize) {
                    Option::Some(found_) => *found_,
                    Option::None => after_,
                }
            };
            self.situation = after_;
        }
        outputs_.phase = {
            const NUMBERS: [core::primitive::u8; 11usize] = [
                0, 0, 1, 9, 2, 2, 3, 9, 4, 4, 0,
            ];
            match <[_]>::get(&NUMBERS, after_ as usize) {
                Option::Some(found_) => *found_,
                Option::None => NUMBERS[0],
            }
        };
        match after_ {
            __NumberShownState::S1 | __NumberShownState::S4 | __NumberShownState::S7 => {
                outputs_.p = true;
            }
            _ => {}
        }
        outputs_
    }
}
