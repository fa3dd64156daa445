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

fn main() {}
