use grafcet::grafcet;

// A variable that is asserted by steps tells another partial grafcet that this one is busy.
grafcet! {
    grafcet Combi {
        input a, b, c: bool; output q: bool; var busy: bool;
        partial G { initial step S1; step S2 { busy; } step S3 { busy if c; } S1 -[a]-> S2 -[b && !a]-> S3 -[!b && !a]-> S1; }
        partial H { initial step T1; step T2 { q; } T1 -[busy]-> T2 -[!busy]-> T1; }
    }
}
