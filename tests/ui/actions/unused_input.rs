use grafcet::grafcet;

grafcet! {
    sfc Oven {
        #![deny(grafcet::unused_input)]
        input start, door: bool;
        output heat: bool;

        initial step Idle;
        step Bake { N heat; }

        Idle -[start]-> Bake -[!start]-> Idle;
    }
}

fn main() {}
