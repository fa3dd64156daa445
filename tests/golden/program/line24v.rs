// Recorded by `cargo xtask bless`: state and cycle of the program, without the facade's path.

pub struct Line24V {
    first: bool,
    situation: __Line24VStateMark,
    q1_: bool,
    q2_: bool,
    q3_: bool,
}
impl Line24V {
    pub const fn new() -> Self {
        Self {
            first: true,
            situation: __Line24VStateMark::of(__Line24VState::S1),
            q1_: false,
            q2_: false,
            q3_: false,
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
        let mut was_state: __Line24VState = __Line24VState::S1;
        let mut evolutions: u32 = 0;
        loop {
            was_state = self.situation.state();
            let clears_s1_s2_: bool = was_state
                == __Line24VState::S1 && inputs.b1;
            let clears_s2_s3_: bool = was_state
                == __Line24VState::S2 && inputs.b2;
            let clears_s3_s4_: bool = was_state
                == __Line24VState::S3 && inputs.b3;
            let clears_s4_s1_: bool = was_state
                == __Line24VState::S4 && inputs.b4;
            if clears_s1_s2_ {
                self.situation = self.situation.with(__Line24VState::NONE);
            }
            if clears_s2_s3_ {
                self.situation = self.situation.with(__Line24VState::NONE);
            }
            if clears_s3_s4_ {
                self.situation = self.situation.with(__Line24VState::NONE);
            }
            if clears_s4_s1_ {
                self.situation = self.situation.with(__Line24VState::NONE);
            }
            if clears_s4_s1_ {
                self.situation = self.situation.with(__Line24VState::S1);
            }
            if clears_s1_s2_ {
                self.situation = self.situation.with(__Line24VState::S2);
            }
            if clears_s2_s3_ {
                self.situation = self.situation.with(__Line24VState::S3);
            }
            if clears_s3_s4_ {
                self.situation = self.situation.with(__Line24VState::S4);
            }
            let mut next_q2_: bool = self.q2_;
            if was_state != __Line24VState::S2
                && self.situation.state() == __Line24VState::S2
            {
                next_q2_ = true;
            }
            if was_state != __Line24VState::S4
                && self.situation.state() == __Line24VState::S4
            {
                next_q2_ = false;
            }
            if !(was_state != self.situation.state() || self.q2_ != next_q2_) {
                self.situation = self.situation.unmarked();
                break;
            }
            if evolutions == 10 {
                self.situation = self.situation.marked();
                self.situation = self.situation.with(was_state);
                break;
            }
            self.q2_ = next_q2_;
            evolutions = evolutions.wrapping_add(1);
        }
        let next_q1_: bool = was_state == __Line24VState::S1;
        let next_q3_: bool = was_state == __Line24VState::S3
            && inputs.b5;
        self.q1_ = next_q1_;
        self.q3_ = next_q3_;
        self.first = false;
        outputs.q1 = self.q1_;
        outputs.q2 = self.q2_;
        outputs.q3 = self.q3_;
        outputs
    }
}
