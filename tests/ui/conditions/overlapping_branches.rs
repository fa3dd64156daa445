use grafcet::grafcet;

grafcet! {
    grafcet Sorter {
        #![deny(grafcet::overlapping_branches)]
        input heavy, long: bool;
        output left, right: bool;

        initial step Wait;
        step Left { left; }
        step Right { right; }

        Wait -[heavy]-> Left -[!heavy]-> Wait;
        Wait -[long]-> Right -[!long]-> Wait;
    }
}

// Of three branches all pairs are named; the fourth excludes the others.
grafcet! {
    grafcet Gates {
        #![deny(grafcet::overlapping_branches)]
        #![allow(grafcet::unsafe_step)]
        input heavy, long, wet, stop: bool;

        initial step Wait;
        step Left;
        step Right;
        step Dryer;

        Wait -[heavy && !stop]-> Left -[!heavy]-> Wait;
        Wait -[long && !stop]-> Right -[!long]-> Wait;
        Wait -[wet && !stop]-> Dryer -[!wet]-> Wait;
        Wait -[stop]-> Left;
    }
}

// As a warning, each pair is named once.
grafcet! {
    grafcet Warned {
        #![allow(grafcet::unsafe_step)]
        input heavy, long, wet: bool;

        initial step Wait;
        step Left;
        step Right;
        step Dryer;

        Wait -[heavy]-> Left -[!heavy]-> Wait;
        Wait -[long]-> Right -[!long]-> Wait;
        Wait -[wet]-> Dryer -[!wet]-> Wait;
    }
}

fn main() {}
