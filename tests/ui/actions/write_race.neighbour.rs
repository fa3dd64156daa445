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
        Right -[!part && count > 9]-> RightDone -[part]-> Right;
    }
}

// Allowed where the plant excludes it.
grafcet! {
    grafcet Plant {
        #![allow(grafcet::write_race)]
        input a, b: bool;
        output mode: u8 = 0;

        initial step One;
        step Two { P1 mode = 1; }
        initial step Three;
        step Four { P1 mode = 2; }

        One -[a]-> Two -[!a]-> One;
        Three -[b]-> Four -[!b]-> Three;
    }
}

fn main() {}
