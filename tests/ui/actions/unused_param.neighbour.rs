use grafcet::grafcet;

grafcet! {
    sfc Oven {
        input start: bool;
        output heat: bool;
        param bake: time = 10s;

        initial step Idle;
        step Bake { N heat; }

        Idle -[start]-> Bake -[bake/Bake]-> Idle;
    }
}

fn main() {}
