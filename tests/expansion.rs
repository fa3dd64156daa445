//! The recorded expansions are ordinary Rust: they compile as modules and behave like the macro's charts.

#[allow(unreachable_pub, dead_code, unused_assignments, clippy::all, clippy::pedantic, reason = "generated code")]
#[rustfmt::skip]
#[path = "golden/motor.rs"]
mod motor;

#[allow(unreachable_pub, dead_code, unused_assignments, clippy::all, clippy::pedantic, reason = "generated code")]
#[rustfmt::skip]
#[path = "golden/line24v.rs"]
mod line24v;

use line24v::{Line24V, Line24VInputs};
use motor::{Motor, MotorInputs};

#[test]
fn motor_switches() {
    let mut motor = Motor::new();
    assert!(motor.cycle(&MotorInputs::default()).red);
    let q = motor.cycle(&MotorInputs { on: true, ..Default::default() });
    assert!(q.relay && q.green && !q.red);
    let q = motor.cycle(&MotorInputs { over_temp: true, ..Default::default() });
    assert!(!q.relay && !q.green && q.red);
}

#[test]
fn line_goes_round() {
    let mut line = Line24V::new();
    let none = Line24VInputs::default();
    let scripts = [
        (none, (true, false, false)),
        (Line24VInputs { b1: true, ..none }, (false, true, false)),
        (Line24VInputs { b2: true, ..none }, (false, true, false)),
        (Line24VInputs { b5: true, ..none }, (false, true, true)),
        (Line24VInputs { b3: true, ..none }, (false, false, false)),
        (Line24VInputs { b4: true, ..none }, (true, false, false)),
    ];
    for (inputs, expected) in scripts {
        let q = line.cycle(&inputs);
        assert_eq!((q.q1, q.q2, q.q3), expected, "{inputs:?}");
    }
}
