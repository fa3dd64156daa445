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

fn main() {}
