use grafcet::grafcet;

grafcet! {
    grafcet Cell {
        input auto, estop, part: bool;

        partial Safety {
            initial step Ready;
            step Stopped { force Production {INIT}; }
            Ready -[estop]-> Stopped -[!estop]-> Ready;
        }

        partial Production {
            initial step Manual;
            enclosing step Auto {
                partial Counting {
                    linked step Wait;
                    step Count;
                    Wait -[part]-> Count -[!part]-> Wait;
                }
            }
            Manual -[auto]-> Auto -[!auto]-> Manual;
        }
    }
}

fn main() {}
