use grafcet::grafcet;

grafcet! {
    /// The rinse is a macro-step that the programme goes through twice; a counter says when to spin.
    pub grafcet WashingMachine {
        input start, door, full, empty, warm: bool;
        output fill, drain, heat, turn, spin, locked: bool;
        var rinses: u8 = 0;

        initial step Idle;
        step Fill { fill; locked; }
        step Warm { heat; turn; locked; }
        step Wash { turn; locked; }
        step Drain { drain; locked; }
        macro step Rinse {
            entry step RinseFill { fill; locked; }
            step RinseTurn { turn; locked; }
            exit step RinseDrain { drain; locked; }
            RinseFill -[full]-> RinseTurn -[3m/RinseTurn]-> RinseDrain;
        }
        step Again { P1 rinses = rinses + 1; locked; }
        step Spin { spin; drain; locked; }
        step Done { P1 rinses = 0; }

        Idle -[start && door && empty]-> Fill -[full]-> Warm -[warm]-> Wash -[20m/Wash]-> Drain -[empty]-> Rinse;
        Rinse -[empty]-> Again;
        Again -[rinses < 2 && 1s/Again]-> Rinse;
        Again -[rinses >= 2 && 1s/Again]-> Spin -[5m/Spin]-> Done -[!door]-> Idle;
    }
}
