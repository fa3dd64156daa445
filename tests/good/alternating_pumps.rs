use grafcet::grafcet;

grafcet! {
    /// Two pumps take turns; at high water both run, and a pump with a fault is passed over.
    pub sfc AlternatingPumps {
        input low, high, fault1, fault2: bool;
        output pump1, pump2, alarm: bool;

        initial step Next1;
        step Next2;
        step Run1 { N pump1; }
        step Run2 { N pump2; }
        step Both1 { N pump1; N pump2; }
        step Both2 { N pump1; N pump2; }
        step Alarm { N alarm; }

        Next1 -[low && !fault1]-> Run1;
        Next1 -[low && !fault2]-> Run2;
        Next1 -[low]-> Alarm;
        Next2 -[low && !fault2]-> Run2;
        Next2 -[low && !fault1]-> Run1;
        Next2 -[low]-> Alarm;
        Run1 -[!low]-> Next2;
        Run1 -[fault1]-> Next2;
        Run1 -[high && !fault2]-> Both1 -[!high || fault1 || fault2]-> Run1;
        Run2 -[!low]-> Next1;
        Run2 -[fault2]-> Next1;
        Run2 -[high && !fault1]-> Both2 -[!high || fault1 || fault2]-> Run2;
        Alarm -[!fault1 || !fault2]-> Next1;
    }
}
