use grafcet::grafcet;

grafcet! {
    sfc Mixer {
        input start, done: bool;
        output speed: u16;

        initial step Idle;
        step Stir { speed = 40; }
        step Heat { speed = 60; }

        Idle -[start]-> (Stir, Heat);
        (Stir, Heat) -[done]-> Idle;
    }
}

// In one step, and in partial grafcets that run side by side.
grafcet! {
    grafcet Twice {
        input a, b: bool;
        output speed: u16;
        output level: i16;

        partial Left {
            initial step One { speed = 1 if a; speed = 2 if b; }
        }
        partial Right {
            initial step Two { level = 3; }
            step Three;
            Two -[a]-> Three -[!a]-> Two;
        }
        partial Other {
            initial step Four;
            step Five { level = 4; }
            Four -[b]-> Five -[!b]-> Four;
        }
    }
}

// Three steps that are active together.
grafcet! {
    sfc Kettle {
        input start, done: bool;
        output speed: u16;

        initial step Idle;
        step Stir { speed = 40; }
        step Heat { speed = 60; }
        step Cool { speed = 80; }

        Idle -[start]-> (Stir, Heat, Cool);
        (Stir, Heat, Cool) -[done]-> Idle;
    }
}

fn main() {}
