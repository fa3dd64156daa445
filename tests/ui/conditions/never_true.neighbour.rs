use grafcet::grafcet;

grafcet! {
    sfc Tank {
        input level: u16;
        output valve: bool;

        initial step Wait;
        step Fill { N valve; }

        Wait -[level < 10]-> Fill -[level > 90]-> Wait;
    }
}

// What looks alike and may hold.
grafcet! {
    grafcet Kinds {
        input a, b: bool;
        input level, other: u16;
        output lamp, horn: bool;
        param low, high: u16 = 5;

        initial step Idle { lamp if level < low && level > high; }
        step Run { horn if b && !a; }
        step Stop;

        Idle -[a && level > 90 && other < 10]-> Run;
        Idle -[!a && falling(a)]-> Run;
        Run -[2s/Run && Run.T < 5s]-> Stop -[b]-> Idle;
    }
}

fn main() {}
