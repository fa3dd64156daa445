use grafcet::grafcet;

grafcet! {
    /// Programmes of different length use parts of one sequence; brushes and water run beside each other.
    pub grafcet CarWash {
        input coin, short, wax, front, back, dry_end: bool;
        output forward, backward, brush, foam, water, waxing, blower, go: bool;

        initial step Free { go; }
        step Foam { foam; forward; }
        step BrushDown { brush; backward; }
        step Rinse { water; }
        step RinseBack { forward; }
        step RinseDone;
        step WaterDone;
        step Wax { waxing; backward; }
        step Dry { blower; }

        Free -[rising(coin)]-> Foam;
        Foam -[front && short]-> Dry;
        Foam -[front && !short]-> BrushDown -[back]-> (Rinse, RinseBack);
        Rinse -[20s/Rinse]-> WaterDone;
        RinseBack -[front && !back]-> RinseDone;
        (WaterDone, RinseDone) -[wax]-> Wax -[back && !front]-> Dry;
        (WaterDone, RinseDone) -[!wax]-> Dry;
        Dry -[dry_end]-> Free;
    }
}
