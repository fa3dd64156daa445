use grafcet::grafcet;

grafcet! {
    grafcet Sorter {
        input heavy, long: bool;
        output left, right: bool;

        initial step Wait;
        step Left { left; }
        step Right { right; }

        Wait -[heavy]-> Left -[!heavy]-> Wait;
        Wait -[long && !heavy]-> Right -[!long]-> Wait;
    }
}

// Exclusive by a number, by a step, by a time; and Rust that nobody looks into.
grafcet! {
    grafcet Kinds {
        // The exploration takes the comparisons of `cold` for unrelated.
        #![allow(grafcet::unsafe_step)]
        input a, b: bool;
        input level: u16;
        input cold: f32;
        input mode: u8;
        param limit: u16 = 40;

        partial Main {
            initial step Idle;
            step Low;
            step High;
            step Late;
            step Cold;

            Idle -[level < limit && !b]-> Low -[a]-> Idle;
            Idle -[level >= limit && !b]-> High -[5s/High]-> Late -[rising(a)]-> Idle;
            High -[High.T < 5s && a]-> Idle;
            Idle -[b && Other::Off.X && cold < 3.5]-> Cold -[!b]-> Idle;
            Idle -[b && Other::Off.X && cold >= 3.5]-> Low;
            Idle -[b && Other::On.X && i32::from(mode) == 3]-> High;
            Idle -[b && Other::On.X && u32::from(mode) == 4]-> Late;
        }
        partial Other {
            initial step Off;
            step On;
            Off -[rising(a)]-> On -[rising(a)]-> Off;
        }
    }
}

// Of three branches each excludes the two others, as the fourth excludes all.
grafcet! {
    grafcet Gates {
        input heavy, long, wet, stop: bool;

        initial step Wait;
        step Left;
        step Right;
        step Dryer;

        Wait -[heavy && !stop]-> Left -[!heavy]-> Wait;
        Wait -[long && !heavy && !stop]-> Right -[!long]-> Wait;
        Wait -[wet && !heavy && !long && !stop]-> Dryer -[!wet]-> Wait;
        Wait -[stop]-> Left;
    }
}

grafcet! {
    grafcet Warned {
        input heavy, long, wet: bool;

        initial step Wait;
        step Left;
        step Right;
        step Dryer;

        Wait -[heavy]-> Left -[!heavy]-> Wait;
        Wait -[long && !heavy]-> Right -[!long]-> Wait;
        Wait -[wet && !heavy && !long]-> Dryer -[!wet]-> Wait;
    }
}

fn main() {}
