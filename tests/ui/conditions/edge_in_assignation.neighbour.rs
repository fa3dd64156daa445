use grafcet::grafcet;

grafcet! {
    grafcet Press {
        input start, up: bool;
        output ram: bool;

        initial step Idle;
        step Down { ram if start; }

        Idle -[rising(start)]-> Down -[up]-> Idle;
    }
}

fn main() {}
