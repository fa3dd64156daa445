use grafcet::grafcet;

grafcet! {
    sfc Oven {
        input start, door: bool;
        output heat: bool;

        initial step Idle;
        step Bake { N heat; }

        Idle -[start && !door]-> Bake -[!start || door]-> Idle;
    }
}

grafcet! {
    sfc Spare {
        input start, _spare: bool;
        #[allow(grafcet::unused_input)]
        input reserve: bool;

        initial step Idle;
        step Run;

        Idle -[start]-> Run -[!start]-> Idle;
    }
}

fn main() {}
