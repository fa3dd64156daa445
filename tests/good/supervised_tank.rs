use grafcet::grafcet;

grafcet! {
    /// Filling may take 10 s, draining as long as the recipe says.
    pub sfc SupervisedTank {
        input start, full, empty: bool;
        param drain_time: time = 30s;
        output inlet, outlet, warning: bool;

        initial step Idle;
        step Fill within 10s { N inlet; }
        step Drain within drain_time { N outlet; N warning if Drain.late; }

        Idle -[start]-> Fill -[full]-> Drain -[empty]-> Idle;
        Fill -[Fill.late && !start]-> Drain;

        never inlet && outlet;
        home Idle;
    }
}
