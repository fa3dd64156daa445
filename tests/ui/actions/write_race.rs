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
        Right -[part && count > 9]-> RightDone -[!part]-> Right;
    }
}

// Of an `sfc` in parallel branches; at the start; by one forcing order.
grafcet! {
    sfc Parallel {
        #![deny(grafcet::write_race)]
        input start, done: bool;
        output count: u16 = 0;

        initial step Idle;
        step Left { P1 count = 1; }
        step Right { N { count += 2; } }

        Idle -[start]-> (Left, Right);
        (Left, Right) -[done]-> Idle;
    }
}

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
            initial step Work { P1 mode = 2; }
            step Safe { P1 state = 2; }
            Work -[go]-> Safe -[!go]-> Work;
        }
    }
}

// Three writers, one of them at both ends of its step; as an error and as a warning.
grafcet! {
    grafcet Stations {
        input start, done: bool;
        var part: u8 = 0;
        output shown: bool;

        initial step Idle { shown if part > 3; }
        step Feed { P1 part = 1; P0 part = 4; }
        step Drill { P1 part = 2; P0 part = 5; }
        step Eject { P0 part = 6; }

        Idle -[start]-> (Feed, Drill, Eject);
        (Feed, Drill, Eject) -[done]-> Idle;
    }
}

grafcet! {
    sfc Cells {
        input start, done: bool;
        var part: u8 = 0;
        output shown: bool;

        initial step Idle { shown if part > 3; }
        step Feed { P1 part = 1; P0 part = 4; }
        step Drill { P1 part = 2; P0 part = 5; }
        step Eject { P0 part = 6; }

        Idle -[start]-> (Feed, Drill, Eject);
        (Feed, Drill, Eject) -[done]-> Idle;
    }
}

fn main() {}
