use grafcet::grafcet;

grafcet! {
    sfc Motor {
        input on, over_temp: bool;
        output relay: bool;
        let go = on && !over_temp;

        initial step Off;
        step On { N relay; }

        Off -[go]-> On -[!on]-> Off;
    }
}

fn main() {}
