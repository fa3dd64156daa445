use grafcet::grafcet;

// What only IEC 60848 has.
grafcet! {
    sfc Cell {
        input part: bool;
        output belt: bool;

        partial Safety {
            initial step Ready { force Production {INIT}; }
        }
        partial Production {
            initial step Idle;
        }
        initial step Start;
        macro step Clamp {
            entry step Close;
            exit step Open;
            Close -[part]-> Open;
        }
        enclosing step Auto {
            partial Counting { linked step Count; }
        }
        Start -[part]-> Clamp -[!part]-> Auto -[part]-> Start;
    }
}

// Words in front of a step that mean nothing there.
grafcet! {
    grafcet Belt {
        input part: bool;

        linked initial step Idle;
        entry step Moving;
        exit step Stopped;
        Idle -[part]-> Moving -[!part]-> Stopped -[true]-> Idle;
    }
}

fn main() {}
