//! The two charts of the source documents, and one in a `static`.

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

        initial step S1 { q1; }
        step S2 { S q2; }
        step S3 { q3 if b5; }
        step S4 { R q2; }

        S1 -[b1]-> S2 -[b2]-> S3 -[b3]-> S4 -[b4]-> S1;
    }
}

/// A chart that starts without any code.
pub static LINE: Line24V = Line24V::new();

#[test]
fn runs() {
    let mut motor = Motor::new();
    assert!(motor.cycle(&MotorInputs::default()).red);
    assert!(motor.cycle(&MotorInputs { on: true, ..Default::default() }).relay);
    let mut line = LINE;
    line.cycle(&Line24VInputs::default());
    assert!(line.cycle(&Line24VInputs { b1: true, ..Default::default() }).q2);
}
