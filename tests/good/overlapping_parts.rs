use grafcet::grafcet;

grafcet! {
    /// A belt with three places and up to three parts on it: each is a token, a free place is one too.
    pub grafcet OverlappingParts {
        input new, done1, done2, taken: bool;
        output stop1, stop2, stop3, work1, work2: bool;

        initial step Free1;
        initial step Free2;
        initial step Free3;
        step Work1 { stop1; work1; }
        step Done1 { stop1; }
        step Work2 { stop2; work2; }
        step Done2 { stop2; }
        step Last { stop3; }

        Free1 -[rising(new)]-> Work1 -[done1]-> Done1;
        (Done1, Free2) -[!new]-> (Free1, Work2);
        Work2 -[done2]-> Done2;
        (Done2, Free3) -[true]-> (Free2, Last);
        Last -[rising(taken)]-> Free3;
    }
}
