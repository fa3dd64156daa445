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
    pub fn cycle(&mut self, inputs: &MotorInputs) -> MotorOutputs {
        let mut outputs = const {
            MotorOutputs {
                relay: false,
                green: false,
                red: false,
            }
        };
        let was_state: __MotorState = self.situation;
        let entered_off: bool;
        if self.first {
            entered_off = true;
        } else {
            let clears_off_on: bool = was_state
                == __MotorState::Off && (inputs.on && !inputs.over_temp);
            let clears_on_off: bool = was_state == __MotorState::On
                && (inputs.off || inputs.over_temp);
            let left_off: bool = clears_off_on;
            let left_on: bool = clears_on_off;
            entered_off = clears_on_off
                && !(was_state == __MotorState::Off && !left_off);
            let entered_on: bool = clears_off_on
                && !(was_state == __MotorState::On && !left_on);
            if left_off {
                self.situation = __MotorState::NONE;
            }
            if left_on {
                self.situation = __MotorState::NONE;
            }
            if entered_off {
                self.situation = __MotorState::Off;
            }
            if entered_on {
                self.situation = __MotorState::On;
            }
        }
        let on_off_0_: bool = self.situation == __MotorState::Off;
        let on_on_1_: bool = self.situation == __MotorState::On;
        let on_on_2_: bool = self.situation == __MotorState::On;
        let q_red: bool = on_off_0_;
        let q_relay: bool = on_on_1_;
        let q_green: bool = on_on_2_;
        self.red = q_red;
        self.relay = q_relay;
        self.green = q_green;
        self.first = false;
        outputs.relay = self.relay;
        outputs.green = self.green;
        outputs.red = self.red;
        outputs
    }
}
