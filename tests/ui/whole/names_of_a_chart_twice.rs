use grafcet::grafcet;

struct MotorStep;

grafcet! {
    sfc Motor {
        input on: bool;
        output relay: bool;
        initial step Off;
        step On { relay; }
        Off -[on]-> On -[!on]-> Off;
    }
}

fn main() {}
