use grafcet::grafcet;

grafcet! {
    grafcet Counter {
        input part, stop: bool;
        var count: u16 = 0;

        initial step Count { on rising(part) && !stop count = count + 1; }
        step Full;

        Count -[count > 9]-> Full -[stop]-> Count;
    }
}

grafcet! {
    grafcet Tally {
        input part, jog, stop: bool;
        var count: u16 = 0;

        initial step Count { on rising(part) || rising(jog) && !stop count = count + 1; }
        step Full;

        Count -[count > 9]-> Full -[stop]-> Count;
    }
}

fn main() {}
