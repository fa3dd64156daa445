use grafcet::grafcet;

grafcet! {
    grafcet Counter {
        input part: bool;
        var count: u16 = 0;

        initial step Left;
        step LeftDone { P1 count = count + 1; }
        initial step Right;
        step RightDone { P1 count = 0; }

        Left -[part]-> LeftDone -[!part]-> Left;
        Right -[part && count > 9]-> RightDone -[!part]-> Right;
    }
}

fn main() {}
