//! A chart that runs here and sends frames.
#![allow(dead_code, reason = "each test needs a part of it")]

use grafcet::grafcet;
use grafcet::record::Recorder;
use grafcet::record::wire::{Wire, wire_len};

/// The same as below, as a user's file.
pub(crate) const SOURCE: &str = "grafcet! { pub(crate) sfc Motor { input on, off: bool; output relay: bool; initial step Off; step On { N relay; } \
                                 Off -[on]-> On -[off || 10s/On]-> Off; } }\n";
/// Another version of it.
pub(crate) const OTHER: &str = "grafcet! { pub(crate) sfc Motor { input on, off: bool; output relay: bool; initial step Off; step On { N relay; } \
                                Off -[on]-> On -[off || 11s/On]-> Off; } }\n";

grafcet! {
    pub(crate) sfc Motor {
        input on, off: bool;
        output relay: bool;
        initial step Off;
        step On { N relay; }
        Off -[on]-> On -[off || 10s/On]-> Off;
    }
}

/// A motor over a line that keeps what was sent.
pub(crate) type Running = Recorder<Motor, Wire<Vec<u8>, [u8; wire_len::<Motor>()]>>;

/// It tells its state after this many cycles that it sends.
pub(crate) fn motor(states: u16) -> Running {
    let wire = Wire::new(Vec::new(), [0; wire_len::<Motor>()]).every(8, states);
    Recorder::over(Motor::new(), wire).expect("as many bytes as it takes")
}

/// What a motor sends that is turned on and off in turn in each of so many cycles, 10 ms apart: on in those with an even number.
pub(crate) fn frames(cycles: u32, states: u16) -> Vec<u8> {
    let mut motor = motor(states);
    for number in 0..cycles {
        let on = number % 2 == 0;
        motor.cycle(&MotorInputs { on, off: !on }, number * 10, &mut ());
    }
    motor.keep().writer().clone()
}
