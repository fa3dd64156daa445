use grafcet::grafcet;

grafcet! {
    sfc Tank {
        input level: u16;
        output valve: bool;

        initial step Wait;
        step Fill { N valve; }

        Wait -[level < 10]-> Fill -[true]-> Wait;
    }
}

// That another step is not active may be said to be safe.
grafcet! {
    sfc Door {
        input open, shut: bool;
        output motor: bool;

        initial step Closed;
        step Opening { N motor; }
        step Open;

        Closed -[open]-> Opening -[shut && Opening.X]-> Open -[!Opening.X]-> Closed;
        Opening -[!open]-> Closed;
    }
}

fn main() {}
