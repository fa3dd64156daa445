use grafcet::grafcet;

grafcet! {
    /// The emergency stop empties the production, which starts anew after it was acknowledged.
    pub grafcet EmergencyStop {
        input estop, acknowledge, start, full, empty: bool;
        output valve, drain, horn: bool;

        partial Safety {
            initial step Watch;
            step Stopped { force Production {}; horn; }
            step Acknowledged { force Production {}; }
            step Restart { force Production {INIT}; }

            Watch -[estop]-> Stopped -[!estop && rising(acknowledge)]-> Acknowledged;
            Acknowledged -[estop]-> Stopped;
            Acknowledged -[!estop && 1s/Acknowledged]-> Restart -[true]-> Watch;
        }

        partial Production {
            initial step Idle;
            step Fill { valve; }
            step Drain { drain; }
            Idle -[start && !full]-> Fill -[full]-> Drain -[empty && !full]-> Idle;
        }
    }
}
