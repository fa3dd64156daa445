use grafcet::grafcet;

grafcet! {
    sfc Press {
        #![deny(grafcet::set_without_reset)]
        input start, done: bool;
        output clamp: bool;

        initial step Idle;
        step Work { S clamp; }

        Idle -[start]-> Work -[done]-> Idle;
    }
}

fn main() {}
