use grafcet::grafcet;

grafcet! {
    sfc Motor {
        input on, cold: bool;
        output relay, fan: bool;

        initial step Off;
        step On { N relay; }
        step CoolDown { N fan; }

        Off -[on]-> On -[!on]-> CoolDown -[cold]-> Off;
    }
}

// A chart of one step has nothing to draw.
grafcet! {
    sfc Lamp {
        output light: bool;
        initial step On { N light; }
    }
}

fn main() {}
