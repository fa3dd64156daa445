use grafcet::grafcet;

grafcet! {
    grafcet Press {
        input start, up: bool;
        output ram: bool;

        initial step Idle;
        step Down { ram; }
        step Watch;

        Idle -[start]-> Down -[up]-> Watch -[!Down.X && !start]-> Idle;
    }
}

fn main() {}
