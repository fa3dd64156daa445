use grafcet::grafcet;

// The first is said once.
grafcet! {
    sfc Motor {
        input on, on, on: bool;
        output relay: bool;

        initial step Off;
        step On { N relay; }

        Off -[on]-> On -[!on]-> Off;
    }
}

fn main() {
    let _ = MotorInputs { on: true };
}
