//! The two charts of the source documents.

use grafcet::grafcet;

grafcet! {
    /// A motor that can be switched on and off, guarded against over-temperature.
    pub sfc Motor {
        input on, off, over_temp: bool;
        output relay, green, red: bool;

        initial step Off { N red; }
        step On { N relay; N green; }

        Off -[on && !over_temp]-> On -[off || over_temp]-> Off;
    }
}

grafcet! {
    /// The 24 V production line.
    pub grafcet Line24V {
        input b1, b2, b3, b4, b5: bool;
        output q1, q2, q3: bool;

        initial step S1 { q1; }          // continuous action
        step S2 { S q2; }                // stored action: set
        step S3 { q3 if b5; }            // continuous action with an assignation condition
        step S4 { R q2; }                // stored action: reset

        S1 -[b1]-> S2 -[b2]-> S3 -[b3]-> S4 -[b4]-> S1;
    }
}

#[test]
fn motor() {
    let mut motor = Motor::new();
    assert!(motor.is_active(MotorStep::Off));
    let q = motor.cycle(&MotorInputs::default());
    assert!(q.red && !q.relay);
    let q = motor.cycle(&MotorInputs { on: true, ..Default::default() });
    assert!(q.relay && q.green && !q.red);
    assert!(motor.is_active(MotorStep::On));
    let q = motor.cycle(&MotorInputs { over_temp: true, ..Default::default() });
    assert!(!q.relay && !q.green && q.red);
    assert_eq!(motor.situation(), MotorStep::Off);
    assert_eq!(size_of::<Motor>(), 1);
}

#[test]
fn line() {
    let mut line = Line24V::new();
    let idle = Line24VInputs::default();
    let seen = |q: Line24VOutputs| (q.q1, q.q2, q.q3);
    assert_eq!(seen(line.cycle(&idle)), (true, false, false));
    assert_eq!(seen(line.cycle(&Line24VInputs { b1: true, ..idle })), (false, true, false));
    assert_eq!(seen(line.cycle(&Line24VInputs { b2: true, ..idle })), (false, true, false));
    assert_eq!(seen(line.cycle(&Line24VInputs { b5: true, ..idle })), (false, true, true));
    assert_eq!(seen(line.cycle(&Line24VInputs { b3: true, ..idle })), (false, false, false));
    assert_eq!(seen(line.cycle(&Line24VInputs { b4: true, ..idle })), (true, false, false));
    assert!(line.is_stable());
    line.cycle(&Line24VInputs { b1: true, b2: true, b3: true, b4: true, b5: true });
    assert!(!line.is_stable());
    assert_eq!(size_of::<Line24V>(), 1, "one byte for the situation, which tells q2");
}
