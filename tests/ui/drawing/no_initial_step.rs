use grafcet::grafcet;

grafcet! {
    sfc Motor {
        input on: bool;
        output relay: bool;

        step Off;
        step On { N relay; }

        Off -[on]-> On -[!on]-> Off;
    }
}

fn main() {}
