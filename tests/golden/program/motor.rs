// Recorded by `cargo xtask bless`: state and cycle of the program, without the facade's path.

pub struct Motor {
    first: bool,
    situation: __MotorState,
    relay: bool,
    green: bool,
    red: bool,
}
impl Motor {
    pub const fn new() -> Self {
        Self {
            first: true,
            situation: __MotorState::Off,
            relay: false,
            green: false,
            red: false,
        }
    }
}
impl Motor {
    pub fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &MotorInputs,
        #[cfg(doc)]
        inputs: &MotorInputs,
    ) -> MotorOutputs {
        let mut outputs_ = const {
            MotorOutputs {
                relay: false,
                green: false,
                red: false,
            }
        };
        let was_state_: __MotorState = self.situation;
        let entered_off_: bool;
        if self.first {
            entered_off_ = true;
        } else {
            let clears_off_on_: bool = was_state_
                == __MotorState::Off && (inputs_.on && !inputs_.over_temp);
            let clears_on_off_: bool = was_state_
                == __MotorState::On && (inputs_.off || inputs_.over_temp);
            let left_off_: bool = clears_off_on_;
            let left_on_: bool = clears_on_off_;
            entered_off_ = clears_on_off_
                && !(was_state_ == __MotorState::Off && !left_off_);
            let entered_on_: bool = clears_off_on_
                && !(was_state_ == __MotorState::On && !left_on_);
            if left_off_ {
                self.situation = __MotorState::NONE;
            }
            if left_on_ {
                self.situation = __MotorState::NONE;
            }
            if entered_off_ {
                self.situation = __MotorState::Off;
            }
            if entered_on_ {
                self.situation = __MotorState::On;
            }
        }
        let on_off_0__: bool = self.situation == __MotorState::Off;
        let on_on_1__: bool = self.situation == __MotorState::On;
        let on_on_2__: bool = self.situation == __MotorState::On;
        let q_red_: bool = on_off_0__;
        let q_relay_: bool = on_on_1__;
        let q_green_: bool = on_on_2__;
        self.red = q_red_;
        self.relay = q_relay_;
        self.green = q_green_;
        self.first = false;
        outputs_.relay = self.relay;
        outputs_.green = self.green;
        outputs_.red = self.red;
        outputs_
    }
}
