use grafcet::grafcet;

grafcet! {
    sfc Cell {
        input start, part, reject: bool;

        initial step Idle;
        step Feed;
        step Clamp;
        step Fed;
        step Drill;
        step Rejected;

        Idle -[start]-> (Feed, Clamp);
        Feed -[part]-> Fed;
        Feed -[reject]-> Rejected -[part]-> Rejected;
        (Fed, Clamp) -[true]-> Drill -[!start]-> Idle;
    }
}

fn main() {}
