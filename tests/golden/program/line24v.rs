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
        let mut was_state_: __Line24VState = __Line24VState::S1;
        let mut evolutions_: u32 = 0;
        loop {
            was_state_ = self.situation.state();
            let clears_s1_s2__: bool = was_state_
                == __Line24VState::S1 && inputs_.b1;
            let clears_s2_s3__: bool = was_state_
                == __Line24VState::S2 && inputs_.b2;
            let clears_s3_s4__: bool = was_state_
                == __Line24VState::S3 && inputs_.b3;
            let clears_s4_s1__: bool = was_state_
                == __Line24VState::S4 && inputs_.b4;
            if clears_s1_s2__ {
                self.situation = self.situation.with(__Line24VState::NONE);
            }
            if clears_s2_s3__ {
                self.situation = self.situation.with(__Line24VState::NONE);
            }
            if clears_s3_s4__ {
                self.situation = self.situation.with(__Line24VState::NONE);
            }
            if clears_s4_s1__ {
                self.situation = self.situation.with(__Line24VState::NONE);
            }
            if clears_s4_s1__ {
                self.situation = self.situation.with(__Line24VState::S1);
            }
            if clears_s1_s2__ {
                self.situation = self.situation.with(__Line24VState::S2);
            }
            if clears_s2_s3__ {
                self.situation = self.situation.with(__Line24VState::S3);
            }
            if clears_s3_s4__ {
                self.situation = self.situation.with(__Line24VState::S4);
            }
            let mut next_q2__: bool = self.q2_;
            if was_state_ != __Line24VState::S2
                && self.situation.state() == __Line24VState::S2
            {
                next_q2__ = true;
            }
            if was_state_ != __Line24VState::S4
                && self.situation.state() == __Line24VState::S4
            {
                next_q2__ = false;
            }
            if !(was_state_ != self.situation.state() || self.q2_ != next_q2__) {
                self.situation = self.situation.unmarked();
                break;
            }
            if evolutions_ == 10 {
                self.situation = self.situation.marked();
                self.situation = self.situation.with(was_state_);
                break;
            }
            self.q2_ = next_q2__;
            evolutions_ = evolutions_.wrapping_add(1);
        }
        let next_q1__: bool = was_state_ == __Line24VState::S1;
        let next_q3__: bool = was_state_ == __Line24VState::S3
            && inputs_.b5;
        self.q1_ = next_q1__;
        self.q3_ = next_q3__;
        self.first = false;
        outputs_.q1 = self.q1_;
        outputs_.q2 = self.q2_;
        outputs_.q3 = self.q3_;
        outputs_
    }
}
