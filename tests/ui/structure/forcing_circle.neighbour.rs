use grafcet::grafcet;

grafcet! {
    grafcet Cell {
        input estop, fault: bool;

        partial Safety {
            initial step Ready;
            step Stopped { force Production {INIT}; }
            Ready -[estop && Fault.X]-> Stopped -[!estop]-> Ready;
        }

        partial Production {
            initial step Idle;
            step Fault;
            Idle -[fault]-> Fault -[!fault]-> Idle;
        }
    }
}

fn main() {}
