use grafcet::grafcet;

grafcet! {
    /// A furnace with every qualifier that IEC 61131-3 has.
    pub sfc Qualifiers {
        input start, hot, cold, stop: bool;
        output fan, burner, horn, lamp, pump, flap, spark: bool;
        var runs: u16 = 0;
        action log(run: u16);

        initial step Off { R fan; R pump; R flap; R lamp; }
        step Purge { S fan; L 2s horn; P1 runs = runs + 1; }
        step Ignite { P spark; D 1s burner; SL 10s lamp; }
        step Burn { N burner; SD 5s pump; DS 3s flap; }
        step Cool { N horn if hot; P0 log(runs); }

        Off -[start]-> Purge -[10s/Purge]-> Ignite -[hot]-> Burn -[stop]-> Cool -[cold && !hot]-> Off;
        Ignite -[8s/Ignite]-> Cool;
    }
}
