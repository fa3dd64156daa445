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
    pub fn cycle(&mut self, inputs: &Line24VInputs) -> Line24VOutputs {
        let mut outputs = const {
            Line24VOutputs {
                q1: false,
                q2: false,
                q3: false,
            }
        };
        let mut now_state: __Line24VState = self.situation.state();
        self.situation = __Line24VStateMark::of(now_state);
        self.situation = self.situation.unmarked();
        let mut evolutions: u32 = 0;
        loop {
            let inputs = core::hint::black_box(inputs);
            fence_on_armv6m();
            match now_state {
                __Line24VState::S1 => {
                    if inputs.b1 {
                        now_state = __Line24VState::S2;
                    } else {
                        break;
                    }
                }
                __Line24VState::S2 => {
                    if inputs.b2 {
                        now_state = __Line24VState::S3;
                    } else {
                        break;
                    }
                }
                __Line24VState::S3 => {
                    if inputs.b3 {
                        now_state = __Line24VState::S4;
                    } else {
                        break;
                    }
                }
                __Line24VState::S4 => {
                    if inputs.b4 {
                        now_state = __Line24VState::S1;
                    } else {
                        break;
                    }
                }
            }
            self.situation = __Line24VStateMark::of(now_state);
            self.situation = self.situation.unmarked();
            evolutions = evolutions.wrapping_add(1);
            if evolutions == 10 {
                self.situation = self.situation.marked();
                break;
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.situation.state() {
            __Line24VState::S1 => {
                outputs = const {
                    Line24VOutputs {
                        q1: true,
                        q2: false,
                        q3: false,
                    }
                };
            }
            __Line24VState::S2 => {
                outputs = const {
                    Line24VOutputs {
                        q1: false,
                        q2: true,
                        q3: false,
                    }
                };
            }
            __Line24VState::S3 => {
                outputs = const {
                    Line24VOutputs {
                        q1: false,
                        q2: true,
                        q3: false,
                    }
                };
                outputs.q3 = inputs.b5;
            }
            _ => {
                outputs = const {
                    Line24VOutputs {
                        q1: false,
                        q2: false,
                        q3: false,
                    }
                };
            }
        }
        outputs
    }
}
