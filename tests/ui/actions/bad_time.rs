use grafcet::grafcet;

grafcet! {
    sfc Oven {
        clock 10ms;
        input start: bool;
        input level: u16;
        output burner, lamp, horn: bool;

        initial step Idle { L 5 lamp; D level horn; }
        step Heat { L 0s burner; D 3sec horn; }

        Idle -[5/Heat || Idle.T > 300]-> Heat -[15ms/Heat]-> Idle;
        Heat -[12000h/Heat]-> Idle;
        Heat -[30m1h/Heat]-> Idle;
    }
}

grafcet! {
    sfc Kiln {
        input start: bool;
        param soak, rest: time = 5;
        param late: time = -3s;

        initial step Idle;
        step Heat;

        Idle -[start && rest/Idle]-> Heat -[soak/Heat && !start || late/Heat && start]-> Idle;
    }
}

fn main() {}
