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

fn main() {}
