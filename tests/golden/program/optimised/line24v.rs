// Recorded by `cargo xtask bless`: state and cycle of the program, without the facade's path.

pub struct Line24V {
    situation: __Line24VStateMark,
}
impl Line24V {
    pub const fn new() -> Self {
        Self {
            situation: __Line24VStateMark::of(__Line24VState::S1),
        }
    }
}
impl Line24V {
    pub fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &Line24VInputs,
        #[cfg(doc)]
        inputs: &Line24VInputs,
    ) -> Line24VOutputs {
        let mut outputs_ = const {
            Line24VOutputs {
                q1: false,
                q2: false,
                q3: false,
            }
        };
        let mut now_state_: __Line24VState = self.situation.state();
        self.situation = __Line24VStateMark::of(now_state_);
        self.situation = self.situation.unmarked();
        let mut evolutions_: u32 = 0;
        loop {
            let inputs_ = core::hint::black_box(inputs_);
            fence_on_armv6m();
            match now_state_ {
                __Line24VState::S1 => {
                    if inputs_.b1 {
                        now_state_ = __Line24VState::S2;
                    } else {
                        break;
                    }
                }
                __Line24VState::S2 => {
                    if inputs_.b2 {
                        now_state_ = __Line24VState::S3;
                    } else {
                        break;
                    }
                }
                __Line24VState::S3 => {
                    if inputs_.b3 {
                        now_state_ = __Line24VState::S4;
                    } else {
                        break;
                    }
                }
                __Line24VState::S4 => {
                    if inputs_.b4 {
                        now_state_ = __Line24VState::S1;
                    } else {
                        break;
                    }
                }
            }
            self.situation = __Line24VStateMark::of(now_state_);
            self.situation = self.situation.unmarked();
            evolutions_ = evolutions_.wrapping_add(1);
            if evolutions_ == 10 {
                self.situation = self.situation.marked();
                break;
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.situation.state() {
            __Line24VState::S1 => {
                outputs_ = const {
                    Line24VOutputs {
                        q1: true,
                        q2: false,
                        q3: false,
                    }
                };
            }
            __Line24VState::S2 => {
                outputs_ = const {
                    Line24VOutputs {
                        q1: false,
                        q2: true,
                        q3: false,
                    }
                };
            }
            __Line24VState::S3 => {
                outputs_ = const {
                    Line24VOutputs {
                        q1: false,
                        q2: true,
                        q3: false,
                    }
                };
                outputs_.q3 = inputs_.b5;
            }
            _ => {
                outputs_ = const {
                    Line24VOutputs {
                        q1: false,
                        q2: false,
                        q3: false,
                    }
                };
            }
        }
        outputs_
    }
}
