use grafcet::grafcet;

// A rule that is an error by default, and one that comes later.
grafcet! {
    sfc Pumps {
        #![allow(grafcet::several_initial_steps, grafcet::unreachable_step)]
        input a, b: bool;
        output left, right: bool;

        initial step WaitLeft;
        step Left { N left; }
        initial step WaitRight;
        step Right { N right; }

        WaitLeft -[a]-> Left -[!a]-> WaitLeft;
        WaitRight -[b]-> Right -[!b]-> WaitRight;
    }
}

// In front of the chart, and on the step that is one too many.
grafcet! {
    #[allow(grafcet::several_initial_steps)]
    sfc Fans {
        initial step Left;
        initial step Right;
    }
}

grafcet! {
    sfc Lamps {
        initial step Left;
        #[allow(grafcet::several_initial_steps)]
        initial step Right;
    }
}

fn main() {}
