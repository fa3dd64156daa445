use grafcet::grafcet;

fn pressed() -> bool {
    false
}

// The condition of an `any` is asked for each branch.
grafcet! {
    sfc Branches {
        input go: bool;
        output left, right: bool;

        initial step Idle;
        step Left { left; }
        step Right { right; }

        Idle -[go]-> (Left, Right);
        (Left, Right) -[!go]-> Idle;
        any -[pressed()]-> Idle;
    }
}

// It is asked once more for what the `any` stops, and so is a branch beside `else`.
grafcet! {
    grafcet Search {
        input go, stop: bool;
        output run: bool;

        initial step Idle;
        step Run { run; }
        step Slow;

        Idle -[go]-> Run -[!go && pressed()]-> Idle;
        Run -[else]-> Slow -[go]-> Idle;
        any -[stop && pressed()]-> Idle;
    }
}

// In a sequence of an `sfc` the active step alone asks; an edge is sampled once; what is pure has one value.
grafcet! {
    sfc Sequence {
        input go: bool;
        output run: bool;

        initial step Idle;
        step Run { run; }

        Idle -[go]-> Run -[!go]-> Idle;
        any -[pressed()]-> Idle;
    }
}

grafcet! {
    grafcet Edge {
        assume pure pressed;
        input go: bool;
        output run: bool;

        initial step Idle;
        step Run { run; }

        Idle -[go]-> Run -[!go]-> Idle;
        any -[rising(pressed()) || pressed()]-> Idle;
    }
}

fn main() {}
