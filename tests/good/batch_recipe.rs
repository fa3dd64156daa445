use grafcet::grafcet;

grafcet! {
    /// Dose two components together, heat while stirring, soak, and drain; the recipe is in the parameters.
    pub sfc BatchRecipe {
        input start, drained: bool;
        input weight_a, weight_b: u16;
        input temperature: i16;
        output dose_a, dose_b, stirrer, drain, ready: bool;
        output heater: u8 = 0;
        param amount_a: u16 = 250;
        param amount_b: u16 = 80;
        param hot: i16 = 78;
        param soak: time = 20s;

        initial step Empty { N ready; }
        step DoseA { N dose_a; }
        step DosedA;
        step DoseB { N dose_b; }
        step DosedB;
        step Heat { N stirrer; N heater = 100; }
        step Soak { N stirrer; N heater = 30; }
        step Drain { N drain; }

        Empty -[rising(start)]-> (DoseA, DoseB);
        DoseA -[weight_a >= amount_a]-> DosedA;
        DoseB -[weight_b >= amount_b]-> DosedB;
        (DosedA, DosedB) -[true]-> Heat -[temperature >= hot]-> Soak;
        Soak -[temperature < hot - 10]-> Heat;
        Soak -[soak/Soak]-> Drain -[drained]-> Empty;
    }
}
