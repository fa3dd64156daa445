use grafcet::grafcet;

grafcet! {
    sfc Oven {
        input door: bool;
        output burner: bool;
        action heat(setpoint: i16);

        initial step Idle;
        step Heat { N heat; N heat(); }

        Idle -[Heat]-> Heat -[heat(80) || !5s/Heat]-> Idle;
        Heat -[rising(door, burner)]-> Idle;
        Heat -[5s/door/burner]-> Idle;
        Heat -[door.X]-> Idle;
    }
}

fn main() {}
