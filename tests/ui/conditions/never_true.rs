use grafcet::grafcet;

grafcet! {
    sfc Tank {
        input level: u16;
        output valve: bool;

        initial step Wait;
        step Fill { N valve; }

        Wait -[level < 10 && level > 90]-> Fill -[level > 90]-> Wait;
    }
}

// The range of a type, steps that exclude each other, an edge and its level, a time and its step; also in actions.
grafcet! {
    grafcet Kinds {
        input a, b: bool;
        input level: u16;
        output lamp, horn: bool;

        initial step Idle { lamp if level > 65_535; }
        step Run { horn if b && !b; }
        step Stop;

        Idle -[a && level < 0]-> Run;
        Idle -[!a && Run.X && Stop.X]-> Run;
        Idle -[rising(a) && !a]-> Run;
        Run -[5s/Run && Run.T < 2s]-> Stop -[b]-> Idle;
    }
}

fn main() {}
