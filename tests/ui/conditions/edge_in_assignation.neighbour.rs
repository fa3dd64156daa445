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

grafcet! {
    grafcet Drive {
        input start, fast: bool;
        output speed: u16;

        initial step Idle;
        step Run { speed = if fast { 80 } else { 40 }; }

        Idle -[start]-> Run -[!start]-> Idle;
    }
}

fn main() {}
