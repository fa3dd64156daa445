use grafcet::grafcet;

grafcet! {
    /// Star-delta starter with thermal relay and two stations.
    pub sfc StarDelta {
        input on1, on2, off1, off2, thermal: bool;
        output line, star, delta, fault: bool;
        param run_up: time = 6s;

        initial step Off;
        step Star { N line; N star; }
        step Gap { N line; }
        step Delta { N line; N delta; }
        step Fault { N fault; }

        Off -[thermal]-> Fault;
        Off -[(on1 || on2) && !off1 && !off2]-> Star;
        Star -[thermal]-> Fault;
        Star -[off1 || off2]-> Off;
        Star -[run_up/Star]-> Gap -[50ms/Gap]-> Delta;
        Delta -[thermal]-> Fault -[!thermal && (off1 || off2)]-> Off;
        Delta -[off1 || off2]-> Off;
    }
}
