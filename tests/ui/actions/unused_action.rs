use grafcet::grafcet;

grafcet! {
    sfc Washer {
        #![deny(grafcet::unused_action)]
        input start, done: bool;
        action drum(rpm: u16);
        action rinse();

        initial step Idle;
        step Wash { N drum(45); }

        Idle -[start]-> Wash -[done]-> Idle;
    }
}

fn main() {}
