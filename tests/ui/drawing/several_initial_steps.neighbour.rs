use grafcet::grafcet;

// IEC 60848 has as many initial steps as the plant needs.
grafcet! {
    grafcet Pumps {
        input a, b: bool;
        output left, right: bool;

        initial step WaitLeft;
        step Left { left; }
        initial step WaitRight;
        step Right { right; }

        WaitLeft -[a]-> Left -[!a]-> WaitLeft;
        WaitRight -[b]-> Right -[!b]-> WaitRight;
    }
}

fn main() {}
