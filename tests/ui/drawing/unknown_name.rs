use grafcet::grafcet;

grafcet! {
    sfc Oven {
        input door, hot: bool;
        output burner, ready: bool;

        initial step Idle { N redy; }
        step Heating { N burner if !dor; N fan; }

        Idle -[!door && start]-> Heating -[hott]-> Idle;
    }
}

fn main() {}
