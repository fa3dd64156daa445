use grafcet::grafcet;

grafcet! {
    grafcet Drill {
        input start, deep: bool;
        output motor: bool;

        initial step Idle { R motor; }
        step Down { S motor; }
        step Up { motor; }

        Idle -[start]-> Down -[deep]-> Up -[!deep && !start]-> Idle;
    }
}

grafcet! {
    sfc Lamp {
        input start: bool;
        output light: bool;

        initial step Dark { P1 light = false; }
        step Lit { N light; }

        Dark -[start]-> Lit -[!start]-> Dark;
    }
}

fn main() {}
