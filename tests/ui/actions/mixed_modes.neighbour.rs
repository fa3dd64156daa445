use grafcet::grafcet;

grafcet! {
    grafcet Drill {
        input start, deep: bool;
        output motor: bool;

        initial step Idle { R motor; }
        step Down { S motor; }
        step Up;

        Idle -[start]-> Down -[deep]-> Up -[!deep && !start]-> Idle;
    }
}

grafcet! {
    sfc Lamp {
        input start: bool;
        output light: bool;

        initial step Dark { R light; }
        step Lit { S light; }

        Dark -[start]-> Lit -[!start]-> Dark;
    }
}

fn main() {}
