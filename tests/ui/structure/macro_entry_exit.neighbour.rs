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

fn main() {}
