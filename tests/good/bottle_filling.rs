use grafcet::grafcet;

grafcet! {
    /// Fills bottles by time, caps them and counts a crate of twelve.
    pub sfc BottleFilling {
        input start, stop, bottle, capped, crate_gone: bool;
        output belt, valve, cap, crate_full: bool;
        var bottles: u8 = 0;
        param fill_time: time = 2s;

        initial step Idle;
        step Feed { N belt; }
        step Fill { N valve; }
        step Drip;
        step Cap { N cap; P0 bottles = bottles + 1; }
        step Carry { N belt; }
        step Full { N crate_full; P0 bottles = 0; }

        Idle -[start && !stop]-> Feed;
        Feed -[bottle]-> Fill -[fill_time/Fill]-> Drip -[500ms/Drip]-> Cap -[capped]-> Carry;
        Feed -[stop]-> Idle;
        Carry -[!bottle && bottles >= 12]-> Full -[rising(crate_gone)]-> Feed;
        Carry -[!bottle && !stop]-> Feed;
        Carry -[!bottle]-> Idle;
    }
}
