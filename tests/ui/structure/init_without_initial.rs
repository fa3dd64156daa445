use grafcet::grafcet;

grafcet! {
    grafcet Cell {
        input start, stop: bool;

        partial Control {
            initial step Off { force Production {INIT}; }
            step On { force Production {Feed}; }
            Off -[start]-> On -[stop]-> Off;
        }

        partial Production {
            step Feed;
            step Press;
            Feed -[start]-> Press -[!start]-> Feed;
        }
    }
}

fn main() {}
