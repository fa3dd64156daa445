use grafcet::grafcet;

grafcet! {
    sfc Lamp {
        #![deny(grafcet::reset_without_set)]
        input start: bool;
        output light: bool;

        initial step Dark { R light; }
        step Lit { N light; }

        Dark -[start]-> Lit -[!start]-> Dark;
    }
}

fn main() {}
