use grafcet::grafcet;

// What a block writes is an output or a variable, as what an assignment writes; what is not declared is one message at each place.
grafcet! {
    sfc Counter {
        input part: bool;
        input list: [u8; 2];
        output full: bool;
        param most: u8 = 3;
        let go = part && most > 1;

        initial step Idle {
            P1 { part = false; }
            P1 { most += 1; list[0] = 3; }
            P1 { fill(&mut part); }
            P1 { go = true; }
        }
        step Run {
            full;
            P1 { strokes += 1; }
            P1 { let mut part = 1; part += 1; take(part); }
            P0 parts = parts + 1;
        }

        Idle -[go]-> Run -[!part && strokes > 3 && parts > 2]-> Idle;
    }
}

fn main() {}
