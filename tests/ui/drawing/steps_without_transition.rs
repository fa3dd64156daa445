use grafcet::grafcet;

grafcet! {
    sfc Motor {
        input on: bool;
        output relay: bool;

        initial step Off;
        step On { N relay; }

        Off -[on]-> On -> Off;
    }
}

fn main() {}
