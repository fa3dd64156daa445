use grafcet::grafcet;

grafcet! {
    sfc Filler {
        #![deny(grafcet::unused_variable)]
        input start, full: bool;
        output valve: bool;
        var bottles: u16 = 0;

        initial step Idle;
        step Fill { N valve; P0 bottles = bottles + 1; }

        Idle -[start]-> Fill -[full]-> Idle;
    }
}

fn main() {}
