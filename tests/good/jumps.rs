use grafcet::grafcet;

grafcet! {
    /// Jumps into and out of loops, forward and backward: no nesting describes this chart.
    pub sfc Jumps {
        input a, b, c, d, quick: bool;
        output p, q, r, s: bool;

        initial step S1 { N p; }
        step S2 { N q; }
        step S3 { N r; }
        step S4 { N s; }
        step S5 { N p; N s; }
        step S6;

        S1 -[quick && a]-> S4;
        S1 -[a]-> S2 -[b]-> S3 -[c]-> S4 -[d]-> S5 -[a && b]-> S6 -[!a]-> S1;
        S3 -[!b && !c]-> S2;
        S4 -[quick && !d]-> S2;
        S5 -[!b && c]-> S3;
        S6 -[b && c]-> S4;
    }
}
