use grafcet::grafcet;

grafcet! {
    grafcet Counter {
        input part, stop: bool;
        var count: u16 = 0;

        initial step Count { on part count = count + 1; }
        step Full;

        Count -[count > 9]-> Full -[stop]-> Count;
    }
}

// An edge in one of two alternatives.
grafcet! {
    grafcet Tally {
        input part, jog, stop: bool;
        var count: u16 = 0;

        initial step Count { on rising(part) || jog && !stop count = count + 1; }
        step Full;

        Count -[count > 9]-> Full -[stop]-> Count;
    }
}

fn main() {}
