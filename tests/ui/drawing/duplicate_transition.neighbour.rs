use grafcet::grafcet;

// The same arc may stand twice with different conditions.
grafcet! {
    sfc Motor {
        input on, off, over_temp: bool;
        output relay: bool;

        initial step Off;
        step On { N relay; }

        Off -[on && !over_temp]-> On -[off]-> Off;
        On -[over_temp]-> Off;
    }
}

fn main() {}
