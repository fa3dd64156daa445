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
}
struct __LongStateMark(u8);
impl __LongStateMark {
    const fn of(state_: __LongState) -> Self {
        Self(state_ as u8)
    }
    const fn state(self) -> __LongState {
        let number_ = self.0 & 31u8;
        if number_ >= 23u8 {
            __LongState::S23
        } else {
            match number_ {
                0u8 => __LongState::S0,
                1u8 => __LongState::S1,
                2u8 => __LongState::S2,
                3u8 => __LongState::S3,
                4u8 => __LongState::S4,
                5u8 => __LongState::S5,
                6u8 => __LongState::S6,
                7u8 => __LongState::S7,
                8u8 => __LongState::S8,
                9u8 => __LongState::S9,
                10u8 => __LongState::S10,
                11u8 => __LongState::S11,
                12u8 => __LongState::S12,
                13u8 => __LongState::S13,
                14u8 => __LongState::S14,
                15u8 => __LongState::S15,
                16u8 => __LongState::S16,
                17u8 => __LongState::S17,
                18u8 => __LongState::S18,
                19u8 => __LongState::S19,
                20u8 => __LongState::S20,
                21u8 => __LongState::S21,
                _ => __LongState::S22,
            }
        }
    }
    /// Another state, and the mark as it is.
    const fn with(self, state_: __LongState) -> Self {
        Self(self.0 & 32u8 | state_ as u8)
    }
    const fn unmarked(self) -> Self {
        Self(self.0 & 31u8)
    }
    const fn marked(self) -> Self {
        Self(self.0 | 32u8)
    }
    const fn is_marked(self) -> bool {
        self.0 & 32u8 != 0
    }
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
        let mut now_state_: __LongState = self.situation.state();
        self.situation = __LongStateMark::of(now_state_);
        self.situation = self.situation.unmarked();
        let inputs_ = core::hint::black_box(inputs_);
        let mut evolutions_: u32 = 0;
        loop {
            match now_state_ {
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
                        break;
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
                        break;
                    }
                }
            }
            now_state_ = {
                const TABLE: [__LongState; 24usize] = [
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
                ];
                match <[_]>::get(&TABLE, now_state_ as usize) {
                    Option::Some(found_) => *found_,
                    Option::None => now_state_,
                }
            };
            self.situation = __LongStateMark::of(now_state_);
            self.situation = self.situation.unmarked();
            evolutions_ = evolutions_.wrapping_add(1);
            if evolutions_ == 50 {
                self.situation = self.situation.marked();
                break;
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match now_state_ {
            __LongState::S5 => {
                outputs_.lamp = true;
            }
            _ => {}
        }
        outputs_
    }
}
