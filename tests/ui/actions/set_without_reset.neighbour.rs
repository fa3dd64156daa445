use grafcet::grafcet;

grafcet! {
    sfc Press {
        input start, done: bool;
        output clamp: bool;

        initial step Idle { R clamp; }
        step Work { S clamp; }

        Idle -[start]-> Work -[done]-> Idle;
    }
}

// A lamp that stays on once there was a fault, and a variable that marks that something has happened.
grafcet! {
    grafcet Monitor {
        input fault, ready: bool;
        #[allow(grafcet::set_without_reset)]
        output lamp: bool;
        output run: bool;
        var homed: bool;

        initial step Watch { run if homed; }
        step Home { S homed; }
        step Failed { S lamp; }

        Watch -[ready && !homed && !fault]-> Home -[!ready]-> Watch -[fault]-> Failed -[!fault]-> Watch;
    }
}

fn main() {}
