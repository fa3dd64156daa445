use grafcet::grafcet;

grafcet! {
    sfc Sorter {
        input part: bool;
        input size: u16;
        output left, right: bool;

        initial step Wait;
        step Left { N left; }
        step Right { N right; }

        Wait -[part]-> Left -[!part]-> Wait;
        Wait -[part && size > 40]-> Right -[!part]-> Wait;
    }
}

// By several together, and a convergence by a branch that takes one of its steps away.
grafcet! {
    sfc Several {
        input level: u16;
        input a, b: bool;

        initial step Idle;
        step Low;
        step High;
        step Middle;
        step Left;
        step Right;
        step Joined;

        Idle -[level < 30]-> Low -[a]-> (Left, Right);
        Idle -[level > 20]-> High -[b]-> Idle;
        Idle -[a]-> Middle -[true]-> Idle;
        Left -[a]-> Low;
        (Left, Right) -[a && b]-> Joined -[!a]-> Idle;
    }
}

fn main() {}
