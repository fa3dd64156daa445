use grafcet::grafcet;

grafcet! {
    grafcet Cell {
        input estop, part: bool;
        output belt: bool;

        partial Safety {
            initial step Ready;
            step Stopped { force Production {Idle}; }
            Ready -[estop && Production::Feed.X]-> Stopped -[!estop]-> Ready;
        }

        partial Production {
            initial step Idle;
            step Feed { belt; }
            Idle -[part]-> Feed -[!part]-> Idle;
        }
    }
}

fn main() {}
