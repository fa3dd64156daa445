use grafcet::grafcet;

grafcet! {
    sfc Cell {
        input start, left, right, stop: bool;

        initial step Idle;
        step Left;
        step Right;
        step Done;

        Idle -[start]-> (Left, Right);
        Left -[stop]-> Idle;
        (Left, Right) -[left && right]-> Done -[!start]-> Idle;
    }
}

fn main() {}
