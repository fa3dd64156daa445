use grafcet::grafcet;

grafcet! {
    sfc Oven {
        #![deny(grafcet::unused_param)]
        input start: bool;
        output heat: bool;
        param bake: time = 10s;

        initial step Idle;
        step Bake { N heat; }

        Idle -[start]-> Bake -[10s/Bake]-> Idle;
    }
}

fn main() {}
