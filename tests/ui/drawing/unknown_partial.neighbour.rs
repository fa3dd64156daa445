use grafcet::grafcet;

grafcet! {
    grafcet Cell {
        input estop, part: bool;
        output belt: bool;

        partial Safety {
            initial step Ready;
            step Stopped { force Production {INIT}; }
            Ready -[estop]-> Stopped -[!estop && Production::Idle.X]-> Ready;
        }

        partial Production {
            initial step Idle;
            step Feed { belt; }
            Idle -[part]-> Feed -[!part]-> Idle;
        }
    }
}

fn main() {}
