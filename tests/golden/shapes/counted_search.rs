// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

#[repr(u32)]
enum __CountedSearchState {
    Wait,
    Lower,
    Raise,
    Blow,
    INIT,
}
struct __CountedSearchStateMark(u8);
impl __CountedSearchStateMark {
    const fn of(state_: __CountedSearchState) -> Self {
        Self(state_ as u8)
    }
    const fn state(self) -> __CountedSearchState {
        let number_ = self.0 & 7u8;
        if number_ >= 4u8 {
            __CountedSearchState::INIT
        } else {
            match number_ {
                0u8 => __CountedSearchState::Wait,
                1u8 => __CountedSearchState::Lower,
                2u8 => __CountedSearchState::Raise,
                _ => __CountedSearchState::Blow,
            }
        }
    }
    /// Another state, and the mark as it is.
    const fn with(self, state_: __CountedSearchState) -> Self {
        Self(self.0 & 8u8 | state_ as u8)
    }
    const fn unmarked(self) -> Self {
        Self(self.0 & 7u8)
    }
    const fn marked(self) -> Self {
        Self(self.0 | 8u8)
    }
    const fn is_marked(self) -> bool {
        self.0 & 8u8 != 0
    }
}
impl CountedSearch {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &CountedSearchInputs,
        #[cfg(doc)]
        inputs: &CountedSearchInputs,
    ) -> CountedSearchOutputs {
        let mut outputs_ = const {
            CountedSearchOutputs {
                ready: false,
                lift: false,
                lower: false,
                blow: false,
            }
        };
        let first_: bool = self.situation.state()
            == __CountedSearchState::INIT;
        if first_ {
            self.situation = self.situation.with(__CountedSearchState::Wait);
        }
        let mut next_count_: core::primitive::u8 = 0;
        if first_ {
            next_count_ = 0;
            self.count = next_count_;
        }
        let mut now_state_: __CountedSearchState = self.situation.state();
        self.situation = __CountedSearchStateMark::of(now_state_);
        self.situation = self.situation.unmarked();
        let mut evolutions_: u32 = 0;
        loop {
            let inputs_ = core::hint::black_box(inputs_);
            fence_on_armv6m();
            match now_state_ {
                __CountedSearchState::Wait => {
                    if inputs_.part {
                        if evolutions_ == 10 {
                            self.situation = self.situation.marked();
                            break;
                        } else {
                            now_state_ = __CountedSearchState::Lower;
                        }
                    } else {
                        break;
                    }
                }
                __CountedSearchState::Lower => {
                    if inputs_.down {
                        next_count_ = {
                            #[allow(unused_variables)]
                            let count = self.count;
                            count.wrapping_add(1)
                        };
                        if evolutions_ == 10 {
                            self.situation = self.situation.marked();
                            break;
                        } else {
                            now_state_ = __CountedSearchState::Raise;
                            self.count = next_count_;
                        }
                    } else {
                        break;
                    }
                }
                __CountedSearchState::Raise => {
                    if inputs_.up
                        && ({
                            let count = self.count;
                            count < 3
                        })
                    {
                        if evolutions_ == 10 {
                            self.situation = self.situation.marked();
                            break;
                        } else {
                            now_state_ = __CountedSearchState::Lower;
                        }
                    } else {
                        if inputs_.up
                            && ({
                                let count = self.count;
                                count >= 3
                            })
                        {
                            if evolutions_ == 10 {
                                self.situation = self.situation.marked();
                                break;
                            } else {
                                now_state_ = __CountedSearchState::Blow;
                            }
                        } else {
                            break;
                        }
                    }
                }
                __CountedSearchState::Blow => {
                    if !inputs_.full {
                        next_count_ = 0;
                        if evolutions_ == 10 {
                            self.situation = self.situation.marked();
                            break;
                        } else {
                            now_state_ = __CountedSearchState::Wait;
                            self.count = next_count_;
                        }
                    } else {
                        break;
                    }
                }
                _ => {
                    break;
                }
            }
            self.situation = __CountedSearchStateMark::of(now_state_);
            self.situation = self.situation.unmarked();
            evolutions_ = evolutions_.wrapping_add(1);
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.situation.state() {
            __CountedSearchState::Wait => {
                outputs_ = const {
                    CountedSearchOutputs {
                        ready: true,
                        lift: false,
                        lower: false,
                        blow: false,
                    }
                };
            }
            __CountedSearchState::Lower => {
                outputs_ = const {
                    CountedSearchOutputs {
                        ready: false,
                        lift: false,
                        lower: true,
                        blow: false,
                    }
                };
            }
            __CountedSearchState::Raise => {
                outputs_ = const {
                    CountedSearchOutputs {
                        ready: false,
                        lift: true,
                        lower: false,
                        blow: false,
                    }
                };
            }
            __CountedSearchState::Blow => {
                outputs_ = const {
                    CountedSearchOutputs {
                        ready: false,
                        lift: false,
                        lower: false,
                        blow: true,
                    }
                };
            }
            _ => {
                outputs_ = const {
                    CountedSearchOutputs {
                        ready: false,
                        lift: false,
                        lower: false,
                        blow: false,
                    }
                };
            }
        }
        outputs_
    }
}
