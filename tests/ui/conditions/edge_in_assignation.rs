use grafcet::grafcet;

grafcet! {
    grafcet Press {
        input start, up: bool;
        output ram: bool;

        initial step Idle;
        step Down { ram if rising(start); }

        Idle -[start]-> Down -[up]-> Idle;
    }
}

grafcet! {
    grafcet Drive {
        input start, fast: bool;
        output speed: u16;

        initial step Idle;
        step Run { speed = if rising(fast) { 80 } else { 40 }; }

        Idle -[start]-> Run -[!start]-> Idle;
    }
}

fn main() {}
