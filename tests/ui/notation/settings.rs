use grafcet::grafcet;

grafcet! {
    sfc Lamp {
        clock 1ms;
        max_evolutions 20;
        clock 10ms;
        encoding flags;
        optimize size;
        encoding flags;
        forceable;
        forceable;
        forceable now;

        initial step Dark;
    }
}

grafcet! {
    grafcet Cell {
        max_evolutions 0;
        clock 0s;

        partial Feeding {
            input part: bool;
            clock 1ms;
            encoding flags;
            forceable;
            initial step Idle;
            partial Inner { initial step Deep; }
        }
    }
}

fn main() {}
