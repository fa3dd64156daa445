use grafcet::grafcet;

// A warning is one: the chart compiles and works. `expect` sees that the compiler has given it.
#[deny(unfulfilled_lint_expectations)]
#[expect(deprecated, reason = "the warning about `spare`")]
mod warned {
    grafcet::grafcet! {
        pub sfc Motor {
            input on, spare: bool;
            output relay: bool;

            initial step Off;
            step On { N relay; }

            Off -[on]-> On -[!on]-> Off;
        }
    }
}

// In a program that denies warnings a chart can allow its own: as a whole, on a declaration, on a step.
#[deny(warnings)]
mod allowed {
    grafcet::grafcet! {
        pub sfc Whole {
            #![allow(grafcet::unused_input)]
            input on, spare: bool;

            initial step Off;
            step On;

            Off -[on]-> On -[!on]-> Off;
        }
    }

    grafcet::grafcet! {
        pub sfc Single {
            input on: bool;
            #[allow(grafcet::unused_input)]
            input spare: bool;
            output lamp: bool;

            initial step Off;
            #[allow(grafcet::set_without_reset)]
            step On { S lamp; }

            Off -[on]-> On -[!on]-> Off;
        }
    }
}

// What is denied around may be allowed inside.
grafcet! {
    #[deny(grafcet::unused_input)]
    sfc Inner {
        input on: bool;
        #[allow(grafcet::unused_input)]
        input spare: bool;

        initial step Off;
        step On;

        Off -[on]-> On -[!on]-> Off;
    }
}

fn main() {
    use warned::{Motor, MotorInputs};
    let mut motor = Motor::new();
    assert!(!motor.cycle(&MotorInputs::default()).relay);
    assert!(motor.cycle(&MotorInputs { on: true, spare: true }).relay);
    _ = (allowed::Whole::new(), allowed::Single::new(), Inner::new());
}
