use grafcet::grafcet;

grafcet! {
    sfc Motor {
        input on, off: bool;
        input on: u8;
        output On: bool;

        initial step Off;
        step On;
        step Off;

        Off -[go: on]-> On -[go: off]-> Off;
    }
}

// Which of the two a chain means is no matter any more.
grafcet! {
    grafcet Stations {
        input start, done: bool;

        partial First {
            initial step Rest;
            step Run;
            Rest -[start]-> Run -[done]-> Rest;
        }
        partial Second {
            initial step Rest;
            step Wait;
            Rest -[start]-> Wait -[done]-> Rest;
        }
    }
}

fn main() {}
