//! Errors of rustc about generated items: at the chart's keyword or at names, never at the whole chart.
use grafcet::grafcet;

grafcet! {
    sfc Motor {
        input on: bool;
        output relay: bool;
        param limit: u8 = 3;
        var count: u8 = 0;
        action report(value: u8);

        initial step Off { N report(limit); }
        step On { N relay; P1 count = 3; }

        Off -[on && count < limit]-> On -[!on]-> Off;
    }
}

// A name that is taken.
pub struct MotorOutputs;

#[derive(Clone, Copy, Default, PartialEq)]
pub struct Plain;

// A trait that a type of the user does not have.
grafcet! {
    #[derive(Debug)]
    sfc Derived {
        input plain: Plain;
        output shown: Plain;

        initial step One { shown = plain; }
        step Two;

        One -[plain == Plain]-> Two -[true]-> One;
    }
}

struct Silent;

impl MotorActions for Silent {}

struct Other;

impl MotorActions for Other {
    fn report(&mut self, value: u8) {
        _ = value;
    }
}

fn main() {
    let mut motor = Motor::with_params(3);
    motor.cycle(&MotorInputs { on: true });
    motor.cycle(3, &mut Silent);
    motor.next_deadline();
    _ = motor.is_active(MotorStep::Lost);
    _ = motor.vars().turns;
    _ = MotorInputs { off: false };
    let motor = motor;
    motor.init();
    match MotorStep::On {
        MotorStep::On => {}
    }
}
