use grafcet::grafcet;

grafcet! {
    sfc Filler {
        input start, full: bool;
        output valve: bool;
        var bottles: u16 = 0;

        initial step Idle;
        step Fill { N valve; P0 bottles = bottles + 1; }

        Idle -[start && bottles < 12]-> Fill -[full]-> Idle;
    }
}

fn main() {}
