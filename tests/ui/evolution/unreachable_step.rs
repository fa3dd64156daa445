use grafcet::grafcet;

grafcet! {
    sfc Filler {
        input start, full, empty: bool;

        initial step Idle;
        step Fill;
        step Drain;
        step Rinse;

        Idle -[start]-> Fill -[full]-> Drain -[empty]-> Idle;
        Rinse -[empty]-> Idle;
    }
}

fn main() {}
