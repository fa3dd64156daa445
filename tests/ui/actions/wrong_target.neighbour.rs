use grafcet::grafcet;

grafcet! {
    sfc Drive {
        input start: bool;
        output speed: u16;
        output relay, horn: bool;
        output brake: bool = true;

        initial step Idle {
            S brake;
            R relay;
        }
        step Run {
            speed = 40;
            S relay;
            R brake;
            P horn;
        }

        Idle -[start]-> Run -[!start]-> Idle;
    }
}

fn main() {}
