use grafcet::grafcet;

grafcet! {
    sfc Filler {
        input start, done: bool;
        output left, right: bool;

        initial step Idle;
        step Left { N left; }
        step Right { N right; }

        Idle -[start]-> (Left, Right, Left);
        (Left, Right) -[done]-> Idle;
    }
}

fn main() {}
