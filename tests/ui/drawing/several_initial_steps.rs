use grafcet::grafcet;

grafcet! {
    sfc Pumps {
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

fn main() {}
