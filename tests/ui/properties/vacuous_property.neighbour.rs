use grafcet::grafcet;

grafcet! {
    sfc Press {
        #![deny(grafcet::vacuous_property)]
        input start, down, key: bool;
        output lower: bool;

        initial step Rest;
        step Press { lower; }

        Rest -[start]-> Press -[down]-> Rest;

        always Rest.X && start => !lower;
        always Press.X && key => lower;
    }
}

grafcet! {
    grafcet Gate {
        #![deny(grafcet::vacuous_property)]
        input open, close: bool;
        output up, down: bool;

        assume never open && close;

        initial step Rest;
        step Raise { up; }
        step Lower { down; }

        Rest -[open]-> Raise -[!open]-> Rest;
        Rest -[close]-> Lower -[!close]-> Rest;

        always open => !down || !up;
        #[allow(grafcet::property_undecided)]
        up || close before down;
    }
}

fn main() {}
