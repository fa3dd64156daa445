use grafcet::grafcet;

grafcet! {
    sfc Motor {
        input on, off, over_temp: bool;
        output relay: bool;

        initial step Off;
        step On { N relay; }

        Off -[on && !over_temp]-> On -[off]-> Off;
        On -[over_temp]-> Off;
        Off -[on&&!over_temp]-> On;
    }
}

// The same condition in other words.
grafcet! {
    grafcet Lamp {
        input level: u16;
        input on: bool;
        output lamp: bool;

        initial step Dark;
        step Lit { lamp; }

        Dark -[on && level > 4]-> Lit -[!on]-> Dark;
        Dark -[level >= 5 && on]-> Lit;
    }
}

fn main() {}
