use grafcet::grafcet;

grafcet! {
    sfc Washer {
        input start, done: bool;
        action drum(rpm: u16);
        action rinse();

        initial step Idle;
        step Wash { N drum(45); P0 rinse(); }

        Idle -[start]-> Wash -[done]-> Idle;
    }
}

fn main() {}
