use grafcet::grafcet;

grafcet! {
    sfc Mixer {
        input start, done: bool;
        output speed: u16;

        initial step Idle;
        step Stir { speed = 40; }
        step Heat { speed = 60; }

        Idle -[start]-> Stir -[done]-> Heat -[!done]-> Idle;
    }
}

// Conditions and steps that exclude each other, and equal values.
grafcet! {
    grafcet Twice {
        input a, b: bool;
        output speed: u16;
        output level: i16;
        output same: u8;

        partial Left {
            initial step One { speed = 1 if a; speed = 2 if b && !a; same = 7; }
        }
        partial Right {
            initial step Two { level = 3; }
            step Three { level = 5; }
            Two -[a]-> Three -[!a]-> Two;
        }
        partial Other {
            initial step Four { same = 7; }
            step Five { same = 7; }
            Four -[b]-> Five -[!b]-> Four;
        }
    }
}

fn main() {}
