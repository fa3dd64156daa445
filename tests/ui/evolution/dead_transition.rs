use grafcet::grafcet;

grafcet! {
    sfc Press {
        input start, up: bool;

        initial step Idle;
        step Down;
        step Hold;

        Idle -[start]-> Down -[up && Hold.X]-> Hold -[!start]-> Idle;
    }
}

fn main() {}
