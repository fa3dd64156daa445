use grafcet::grafcet;

grafcet! {
    sfc Oven {
        input door, hot: bool;
        output burner: bool;

        initial step Idle;
        step Heating { N burner; }
        step Cooling;

        Idle -[!door]-> Heating -[hot]-> Cooling;
        Heating -[door]-> Cooling;
        Cooling -[!Heating.X]-> Idle;
    }
}

fn main() {}
