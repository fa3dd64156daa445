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

grafcet! {
    grafcet Stations {
        input part: bool;
        output push: bool;

        partial Feeder {
            initial step Rest;
            step Push { push; }
            Rest -[part && Drill::Wait]-> Push -[!(Drill::Wait.X || Drill::Work)]-> Rest;
        }
        partial Drill {
            initial step Wait;
            step Work { push if Feeder::Rest; }
            Wait -[Feeder::Push.X]-> Work -[Feeder::Rest]-> Wait;
        }
    }
}

fn main() {}
