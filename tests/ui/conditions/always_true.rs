use grafcet::grafcet;

grafcet! {
    sfc Tank {
        input level: u16;
        output valve: bool;

        initial step Wait;
        step Fill { N valve; }

        Wait -[level < 10 || level > 5]-> Fill -[level > 90]-> Wait;
    }
}

// Whoever waits for its own step waits for nothing, and a branch after it is not reported beside it.
grafcet! {
    sfc Door {
        input open, shut: bool;
        output motor: bool;

        initial step Closed;
        step Opening { N motor; }
        step Open;

        Closed -[open]-> Opening -[shut || Opening.X]-> Open -[!open]-> Closed;
        Opening -[!open]-> Closed;
    }
}

fn main() {}
