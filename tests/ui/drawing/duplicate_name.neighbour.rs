use grafcet::grafcet;

// `on` and `On` are two names; a transition may be called like a step.
grafcet! {
    sfc Motor {
        input on, off: bool;
        output relay: bool;

        initial step Off;
        step On { N relay; }

        Off -[On: on]-> On -[Off: off]-> Off;
    }
}

fn main() {}
