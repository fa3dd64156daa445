use grafcet::grafcet;

grafcet! {
    grafcet Cell {
        input estop, door: bool;

        partial Safety {
            initial step Ready;
            step Stopped { force Production {}; }
            Ready -[estop]-> Stopped -[!estop]-> Ready;
        }

        partial Doors {
            initial step Closed;
            step Open { force Production {INIT}; }
            Closed -[door]-> Open -[!door]-> Closed;
        }

        partial Production {
            initial step Idle;
            step Feed;
            Idle -[true]-> Feed;
        }
    }
}

fn main() {}
