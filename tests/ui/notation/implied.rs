use grafcet::grafcet;

grafcet! {
    sfc Gate {
        input call: bool;
        output up: bool;

        initial step Rest;
        step Rise { up; }

        Rest -[call]-> Rise -[!call]-> Rest;

        never Rest.X => up;
    }
}

fn main() {}
