use grafcet::grafcet;

// The step that cannot be read may be the initial one: its own error is enough.
grafcet! {
    sfc Motor {
        input on: bool;
        output relay: bool;

        inital step Off (on);
        step On { N relay; }

        Off -[on]-> On -[!on]-> Off;
    }
}

fn main() {}
