use grafcet::grafcet;

grafcet! {
    sfc Press {
        input start, up: bool;

        initial step Idle;
        step Down;
        step Hold;

        Idle -[start]-> Down -[up && Down.X]-> Hold -[!start]-> Idle;
    }
}

fn main() {}
