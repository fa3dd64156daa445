use grafcet::grafcet;

grafcet! {
    /// Selections in parallel branches in selections, three levels deep.
    pub sfc Nested {
        input start, big, x, y, z, done: bool;
        output q1, q2, q3, q4, q5, q6: bool;

        initial step Idle;
        step Small { N q1; }
        step Big;
        step L1 { N q2; }
        step L2 { N q3; }
        step LeftEnd;
        step R0;
        step Ra { N q4; }
        step Rb { N q5; }
        step RaEnd;
        step RbEnd;
        step Rc;
        step Rd { N q6; }
        step RightEnd;
        step Joined;

        Idle -[start && big]-> Big -[true]-> (L1, R0);
        Idle -[start]-> Small -[done]-> Idle;
        L1 -[x]-> LeftEnd;
        L1 -[y]-> L2 -[x]-> LeftEnd;
        R0 -[x && y]-> (Ra, Rb);
        R0 -[z]-> Rc -[x]-> Rd -[y]-> RightEnd;
        Ra -[y]-> RaEnd;
        Rb -[z]-> RbEnd;
        (RaEnd, RbEnd) -[true]-> RightEnd;
        (LeftEnd, RightEnd) -[done]-> Joined -[!done && !start]-> Idle;
    }
}
