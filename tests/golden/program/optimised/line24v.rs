// Recorded by `cargo xtask bless`: state and cycle of the program, without the facade's path.

pub struct Line24V {
    situation: __Line24VState,
    q2_: bool,
    stable: bool,
}
impl Line24V {
    pub const fn new() -> Self {
        Self {
            situation: __Line24VState::S1,
            q2_: false,
            stable: true,
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
        let mut evolutions: u8 = 0;
        loop {
            match self.situation {
                __Line24VState::S1 => {
                    if inputs.b1 {
                        if evolutions == 10 {
                            self.stable = false;
                            break;
                        } else {
                            self.situation = __Line24VState::S2;
                            self.q2_ = true;
                        }
                    } else {
                        self.stable = true;
                        break;
                    }
                }
                __Line24VState::S2 => {
                    if inputs.b2 {
                        if evolutions == 10 {
                            self.stable = false;
                            break;
                        } else {
                            self.situation = __Line24VState::S3;
                        }
                    } else {
                        self.stable = true;
                        break;
                    }
                }
                __Line24VState::S3 => {
                    if inputs.b3 {
                        if evolutions == 10 {
                            self.stable = false;
                            break;
                        } else {
                            self.situation = __Line24VState::S4;
                            self.q2_ = false;
                        }
                    } else {
                        self.stable = true;
                        break;
                    }
                }
                __Line24VState::S4 => {
                    if inputs.b4 {
                        if evolutions == 10 {
                            self.stable = false;
                            break;
                        } else {
                            self.situation = __Line24VState::S1;
                        }
                    } else {
                        self.stable = true;
                        break;
                    }
                }
            }
            evolutions = evolutions.wrapping_add(1);
        }
        match self.situation {
            __Line24VState::S1 => {
                outputs.q1 = true;
            }
            __Line24VState::S3 => {
                outputs.q3 = inputs.b5;
            }
            _ => {}
        }
        outputs.q2 = self.q2_;
        outputs
    }
}
