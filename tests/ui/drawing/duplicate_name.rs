use grafcet::grafcet;

grafcet! {
    sfc Motor {
        input on, off: bool;
        input on: u8;
        output On: bool;

        initial step Off;
        step On;
        step Off;

        Off -[go: on]-> On -[go: off]-> Off;
    }
}

fn main() {}
