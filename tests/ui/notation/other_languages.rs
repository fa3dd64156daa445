//! What people write who come from other tools, and what the chart says in their place: one message for one mistake.
use grafcet::grafcet;

// Structured text and the boxes of an editor.
grafcet! {
    sfc Boxes {
        VAR_INPUT start: bool;
        var_output valve, motor, lamp: bool;
        param soak: time = 5s;
        var count: u16 = 0;

        initial step Idle: step Rest;
        step Fill {
            reset count;
            set valve;
            N valve WHEN start;
            N motor after 5s;
            L soak;
            SL lamp;
            T1(IN := start, PT := 5s);
        }
        step Heat {
            entry { valve = true; }
            exit: valve = false;
            do motor;
        }

        Idle -[start]-> Fill --[start]--> Heat -[!start]-> Rest -[start]-> Idle;
        always valve implies motor;
    }
}

// German words.
grafcet! {
    Ablaufsprache Worte {
        eingang start: bool;
        ausgang ventil: bool;

        Initialschritt Ruhe;
        schritt Fuellen { setze ventil; N ventil wenn start; }

        Ruhe -[start]-> Fuellen -[!start]-> Ruhe;
    }
}

// The standard's forcing orders.
grafcet! {
    grafcet Forced {
        input stop: bool;
        output lamp: bool;

        partial Guard {
            initial step Ready;
            step Stopped { F/Work{INIT}; lamp; }
            Ready -[stop]-> Stopped -[!stop]-> Ready;
        }
        partial Work {
            initial step One;
            step Two;
            One -[!stop]-> Two -[stop]-> One;
        }
    }
}

fn main() {}
