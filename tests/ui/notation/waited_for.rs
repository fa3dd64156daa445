use grafcet::grafcet;

// What stands in front of `/Step` that is no time, and times on the wrong side of it.
grafcet! {
    sfc Oven {
        input start, hot: bool;
        input wait: time;
        output burner, lamp: bool;
        output shown: time;
        param count: u16 = 5;

        initial step Idle;
        step Heat within wait { burner; D wait lamp; shown = wait; }

        Idle -[start && wait/Idle]-> Heat;
        Heat -[hot && shown/(Heat)]-> Idle;
        Heat -[hot && count/Heat]-> Idle;
        Heat -[hot && Heat/5s]-> Idle;
        Heat -[-5s/Heat]-> Idle;
    }
}

fn main() {}
