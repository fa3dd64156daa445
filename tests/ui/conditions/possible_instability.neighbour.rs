use grafcet::grafcet;

grafcet! {
    grafcet Line {
        #![warn(grafcet::possible_instability)]
        input b1, b2, b3: bool;
        output left, right: bool;

        initial step Wait;
        step Left { left; }
        step Right { right; }

        Wait -[rising(b1)]-> Left -[b2]-> Right -[b3]-> Wait;
    }
}

fn main() {}
