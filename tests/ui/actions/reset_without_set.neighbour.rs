use grafcet::grafcet;

grafcet! {
    sfc Lamp {
        input start: bool;
        output light: bool;

        initial step Dark { R light; }
        step Lit { S light; }

        Dark -[start]-> Lit -[!start]-> Dark;
    }
}

// R dominates beside an N that is active at the same time.
grafcet! {
    sfc Drive {
        input start, jam, clear: bool;
        output motor: bool;

        initial step Idle;
        step Run { N motor; }
        step Watch;
        step Block { R motor; }
        step Ready;

        Idle -[start]-> (Run, Watch);
        Watch -[jam]-> Block -[clear]-> Ready;
        (Run, Ready) -[!start]-> Idle;
    }
}

fn main() {}
