use grafcet::grafcet;

grafcet! {
    grafcet Cell {
        input start, closed: bool;
        output close: bool;

        initial step Idle;
        macro step Clamp {
            entry step Close { close; }
            step Hold;
            Close -[closed]-> Hold;
        }
        macro step Release {
            entry step Open;
            entry step Away;
            exit step Done;
            Open -[!closed]-> Done;
            Away -[closed]-> Done;
        }

        Idle -[start]-> Clamp -[true]-> Release -[!start]-> Idle;
    }
}

// The border of an expansion is crossed through the macro-step alone.
grafcet! {
    grafcet Gate {
        input start, closed, jam: bool;
        output close, horn: bool;

        initial step Idle;
        macro step Clamp {
            entry step Close { close; }
            exit step Hold;
            Close -[closed]-> Hold;
        }
        step Alarm { horn; }

        Idle -[start && !jam]-> Clamp -[!start]-> Idle;
        Close -[jam && !closed]-> Alarm -[!jam]-> Hold;
    }
}

fn main() {}
