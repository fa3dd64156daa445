use grafcet::grafcet;

grafcet! {
    /// Stamps a part: lowers the stamp, holds it for half a second, lifts it again.
    pub sfc Press {
        input start, at_top, at_bottom: bool;
        output lower, lift, lamp: bool;

        initial step Ready { N lamp; }
        step Lower { N lower; }
        step Hold { N lower; }
        step Lift { N lift; }

        Ready -[start && at_top]-> Lower -[at_bottom]-> Hold -[500ms/Hold]-> Lift -[at_top]-> Ready;

        never lower && lift;
        home Ready;
    }
}
