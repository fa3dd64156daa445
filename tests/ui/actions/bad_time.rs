use grafcet::grafcet;

grafcet! {
    sfc Oven {
        clock 10ms;
        input start: bool;
        input level: u16;
        output burner, lamp: bool;

        initial step Idle { L 5 lamp; D level lamp; }
        step Heat { L 0s burner; D 3sec lamp; }

        Idle -[5/Heat || Idle.T > 300]-> Heat -[15ms/Heat]-> Idle;
        Heat -[12000h/Heat]-> Idle;
        Heat -[30m1h/Heat]-> Idle;
    }
}

fn main() {}
