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

fn main() {}
