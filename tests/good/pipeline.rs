use grafcet::grafcet;

grafcet! {
    /// Four stations with a hand-over between each two of them: full and empty places are tokens of parallel branches.
    pub sfc Pipeline {
        input come, cut, bent, painted, gone: bool;
        output saw, press, spray, pusher: bool;

        initial step Start;
        step SawIdle;
        step Saw { N saw; }
        step EmptyA;
        step FullA;
        step BendIdle;
        step Bend { N press; }
        step EmptyB;
        step FullB;
        step PaintIdle;
        step Paint { N spray; }
        step EmptyC;
        step FullC;
        step PushIdle;
        step Push { N pusher; }

        Start -[true]-> (SawIdle, EmptyA, BendIdle, EmptyB, PaintIdle, EmptyC, PushIdle);
        SawIdle -[come]-> Saw;
        (Saw, EmptyA) -[cut]-> (SawIdle, FullA);
        (BendIdle, FullA) -[true]-> (Bend, EmptyA);
        (Bend, EmptyB) -[bent]-> (BendIdle, FullB);
        (PaintIdle, FullB) -[true]-> (Paint, EmptyB);
        (Paint, EmptyC) -[painted]-> (PaintIdle, FullC);
        (PushIdle, FullC) -[true]-> (Push, EmptyC);
        Push -[gone]-> PushIdle;
    }
}
