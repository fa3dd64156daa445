use grafcet::grafcet;

grafcet! {
    sfc Oven {
        input door, hot: bool;
        output burner: bool;

        initial step Idle;
        step Heating { N burner; }

        Idle -[!door]-> Heatng -[hot]-> Idle;
        Heating -[door]-> Cooling;
        Idle -[hot]-> burner;
        Heating -[Preheat.X]-> Idle;
    }
}

// In a property a step may stand alone.
grafcet! {
    sfc Heater {
        input on: bool;
        output heat: bool;

        initial step Off;
        step On { heat; }

        Off -[on]-> On -[!on]-> Off;

        on leads_to Onn;
    }
}

fn main() {}
