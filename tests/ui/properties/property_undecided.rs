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
        input a, b, c, d, stop: bool;
        output lit: bool;

        budget 5;

        initial step Start;
        step Dark { R lit; }
        step Lit { S lit; }
        step Low;
        step High;
        step Left;
        step Right;
        step In;
        step Out;

        Start -[true]-> (Dark, Low, Left, In);
        Dark -[a]-> Lit -[!a]-> Dark;
        Low -[b && !stop]-> High -[!b]-> Low;
        Left -[c && !stop]-> Right -[!c]-> Left;
        In -[d && !stop]-> Out -[!d]-> In;
        (Dark, Low, Left, In) -[stop && !a]-> Start;

        never lit && Dark.X;
    }
}

fn main() {}
