use grafcet::grafcet;

grafcet! {
    sfc Motor {
        #![deny(grafcet::unused_let)]
        input on, over_temp: bool;
        output relay: bool;
        let go = on && !over_temp;

        initial step Off;
        step On { N relay; }

        Off -[on && !over_temp]-> On -[!on]-> Off;
    }
}

fn main() {}
