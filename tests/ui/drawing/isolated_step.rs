use grafcet::grafcet;

grafcet! {
    sfc Motor {
        input on: bool;
        output relay, fan: bool;

        initial step Off;
        step On { N relay; }
        step CoolDown { N fan; }

        Off -[on]-> On -[!on]-> Off;
    }
}

fn main() {}
