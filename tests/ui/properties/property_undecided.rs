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
        
        always full => Full.X;
        home Idle;
    }
}

grafcet! {
    sfc Lamps {
        input a, b, c, d, e, f: bool;
        output lit: bool;

        budget 1;

        initial step Start;
        step One { S lit; }
        step Two;
        step Three { R lit; }
        step Four;
        step Five;
        step Six;

        Start -[a]-> (One, Three, Five);
        One -[b || rising(c)]-> Two -[c || falling(e)]-> One;
        Three -[d || rising(e)]-> Four -[e || falling(a)]-> Three;
        Five -[f || rising(a)]-> Six -[a || falling(c)]-> Five;
        (Two, Four, Six) -[a && c && e]-> Start;

        never lit && One.X && Four.X && Six.X && a && b && !b;
        never lit && a && b && c && d && e && f && Start.X && Two.X;
        always lit || One.X || !Start.X || !lit;
        always lit => !Start.X || a || !a || lit;
    }
}

fn main() {}
