use grafcet::grafcet;

grafcet! {
    grafcet Counter {
        input part: bool;
        output count: u16 = 0;

        initial step Left;
        step LeftDone { P1 count = count + 1; }
        initial step Right;
        step RightDone { P1 count = 0; }

        Left -[part]-> LeftDone -[!part]-> Left;
        Right -[!part && count > 9]-> RightDone -[part]-> Right;
    }
}

// Allowed where the plant excludes it.
grafcet! {
    grafcet Plant {
        #![allow(grafcet::write_race)]
        input a, b: bool;
        output mode: u8 = 0;

        initial step One;
        step Two { P1 mode = 1; }
        initial step Three;
        step Four { P1 mode = 2; }

        One -[a]-> Two -[!a]-> One;
        Three -[b]-> Four -[!b]-> Three;
    }
}

// One after the other, and what the action control combines.
grafcet! {
    sfc Parallel {
        #![deny(grafcet::write_race)]
        input start, done: bool;
        output count: u16 = 0;
        output lamp: bool;

        initial step Idle { P0 count = 0; }
        step Left { P1 count = 1; S lamp; }
        step Right { R lamp; }
        step Last { N { count += 2; } }

        Idle -[start]-> (Left, Right);
        (Left, Right) -[done]-> Last -[!done]-> Idle;
    }
}

// The lower partial grafcet writes what the upper one does not, or the same.
grafcet! {
    grafcet Orders {
        input stop, go: bool;
        output mode: u8 = 0;
        output state: u8 = 0;

        partial Upper {
            initial step Ready { P1 mode = 1; }
            step Stopped { force Lower {Safe}; P1 state = 1; }
            Ready -[stop]-> Stopped -[!stop]-> Ready;
        }
        partial Lower {
            initial step Work { P1 mode = 1; }
            step Safe { P1 state = 1; }
            Work -[go]-> Safe -[!go]-> Work;
        }
    }
}

fn main() {}
