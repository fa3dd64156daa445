use grafcet::grafcet;

grafcet! {
    sfc Oven {
        clock 10ms;
        input start: bool;
        param soak: time = 1h30m;
        output burner, lamp, horn: bool;

        initial step Idle { L 5s lamp; D soak horn; }
        step Heat { L 500ms burner; }

        Idle -[5s/Idle || Idle.T > 3s]-> Heat -[11000h/Heat]-> Idle;
        Heat -[1.5h/Heat]-> Idle;
        Heat -[soak/Heat && start]-> Idle;
        Heat -[20ms/Heat]-> Idle;
    }
}

grafcet! {
    sfc Kiln {
        input start: bool;
        param soak, rest: time = 5s;
        param late: time = 3s;

        initial step Idle;
        step Heat;

        Idle -[start && rest/Idle]-> Heat -[soak/Heat && !start || late/Heat && start]-> Idle;
    }
}

fn main() {}
