use grafcet::grafcet;

grafcet! {
    /// Two lines share a crane: a step without actions is the semaphore, the first line has priority.
    pub sfc SharedCrane {
        input full1, full2, lifted, there, back: bool;
        output lift, go1, go2: bool;

        initial step Start;
        step CraneFree;
        step Idle1;
        step Lift1 { N lift; }
        step Carry1 { N lift; N go1; }
        step Back1;
        step Idle2;
        step Lift2 { N lift; }
        step Carry2 { N lift; N go2; }
        step Back2;

        Start -[true]-> (CraneFree, Idle1, Idle2);
        (CraneFree, Idle1) -[full1]-> Lift1 -[lifted]-> Carry1 -[there]-> Back1 -[back]-> (CraneFree, Idle1);
        (CraneFree, Idle2) -[full2]-> Lift2 -[lifted]-> Carry2 -[there]-> Back2 -[back]-> (CraneFree, Idle2);
    }
}
