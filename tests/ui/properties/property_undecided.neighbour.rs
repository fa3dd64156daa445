use grafcet::grafcet;

grafcet! {
    sfc Batch {
        input go, part: bool;
        output full: bool;
        var count: u8;

        initial step Idle { P1 count = 0; }
        step Wait;
        step Part { P1 count = count + 1; }
        step Full { N full; }

        Idle -[go]-> Wait;
        Wait -[count >= 12]-> Full;
        Wait -[part]-> Part -[!part]-> Wait;
        Full -[!go]-> Idle;
        Wait -[!go]-> Idle;
        always full => Full.X;
        home Idle;
    }
}

fn main() {}
