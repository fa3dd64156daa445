use grafcet::grafcet;

grafcet! {
    /// Three sequences of different length meet twice in one cycle.
    pub sfc Rendezvous {
        input go, a1, a2, b1, c1, c2, c3, met, a3, b2: bool;
        output pa, pb, pc, mix: bool;

        initial step Start;
        step A1 { N pa; }
        step A2;
        step A3;
        step B1 { N pb; }
        step B2;
        step C1 { N pc; }
        step C2;
        step C3 { N pc; }
        step C4;
        step A4 { N pa; }
        step A5;
        step B3 { N mix; }
        step B4;
        step C5;

        Start -[go]-> (A1, B1, C1);
        A1 -[a1]-> A2 -[a2]-> A3;
        B1 -[b1]-> B2;
        C1 -[c1]-> C2 -[c2]-> C3 -[c3]-> C4;
        (A3, B2, C4) -[met]-> (A4, B3, C5);
        A4 -[a3]-> A5;
        B3 -[b2]-> B4;
        (A5, B4, C5) -[!go]-> Start;
    }
}
