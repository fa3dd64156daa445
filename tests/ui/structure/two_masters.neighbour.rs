use grafcet::grafcet;

grafcet! {
    grafcet Cell {
        input estop, door: bool;

        partial Safety {
            initial step Ready;
            step Stopped { force Production {}; }
            step Open { force Production {INIT}; }
            Ready -[estop]-> Stopped -[!estop]-> Ready;
            Ready -[door && !estop]-> Open -[!door]-> Ready;
        }

        partial Production {
            initial step Idle;
            step Feed;
            Idle -[true]-> Feed;
        }
    }
}

fn main() {}
