use grafcet::grafcet;

grafcet! {
    /// Every movement has its time; one that takes longer ends in a fault that must be acknowledged.
    pub sfc Watchdog {
        input start, extended, retracted, acknowledge: bool;
        output extend, retract, fault: bool;
        param limit: time = 4s;

        initial step Ready;
        step Extend { N extend; }
        step Retract { N retract; }
        step Stuck { N fault; }
        step Home { N retract; }

        Ready -[start && retracted]-> Extend;
        Extend -[extended]-> Retract;
        Extend -[limit/Extend]-> Stuck;
        Retract -[retracted]-> Ready;
        Retract -[limit/Retract]-> Stuck;
        Stuck -[rising(acknowledge)]-> Home;
        Home -[retracted]-> Ready;
        Home -[limit/Home]-> Stuck;
    }
}
