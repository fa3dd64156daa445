use grafcet::grafcet;

grafcet! {
    grafcet Cell {
        input start, closed: bool;
        output close: bool;

        initial step Idle;
        macro step Clamp {
            entry step Close { close; }
            exit step Hold;
            Close -[closed]-> Hold;
        }

        Idle -[start]-> Clamp -[!start]-> Idle;
    }
}

grafcet! {
    grafcet Gate {
        input start, closed, jam: bool;
        output close, horn: bool;

        initial step Idle;
        macro step Clamp {
            entry step Close { close; }
            exit step Hold;
            Close -[closed]-> Hold;
            Close -[jam && !closed]-> Alarm -[!jam]-> Hold;
            step Alarm { horn; }
        }

        Idle -[start && !jam]-> Clamp -[!start]-> Idle;
    }
}

fn main() {}
