use grafcet::grafcet;

grafcet! {
    /// Runs once: a chart that is meant to end, well or with a fault.
    pub sfc Commissioning {
        input start, oil, pressure, ok: bool;
        output pump, valve, passed, failed: bool;

        initial step Idle;
        step Pump { N pump; }
        step Pressure { N pump; N valve; }
        step Inspect { N valve; }
        final step Passed { N passed; }
        final step Failed { N failed; }

        Idle -[start]-> Pump -[oil]-> Pressure -[pressure]-> Inspect -[ok]-> Passed;
        Pump -[30s/Pump]-> Failed;
        Pressure -[10s/Pressure]-> Failed;
        Inspect -[!pressure]-> Failed;
    }
}
