use grafcet::grafcet;

grafcet! {
    /// The same by the rules of GRAFCET: who may take the crane when both want it is said in the condition.
    pub grafcet SharedCraneGrafcet {
        input full1, full2, there1, there2: bool;
        output go1, go2: bool;

        initial step CraneFree;
        initial step Idle1;
        initial step Idle2;
        step Carry1 { go1; }
        step Carry2 { go2; }

        (CraneFree, Idle1) -[full1]-> Carry1 -[there1 && !full1]-> (CraneFree, Idle1);
        (CraneFree, Idle2) -[full2 && !(Idle1.X && full1)]-> Carry2 -[there2 && !full2]-> (CraneFree, Idle2);
    }
}
