use grafcet::grafcet;

grafcet! {
    grafcet Press {
        input start, up: bool;
        output ram: bool;

        initial step Idle;
        step Down { ram; }
        step Watch;

        Idle -[start]-> Down -[up]-> Watch -[!ram]-> Idle;
    }
}

// What is more than on or off.
grafcet! {
    grafcet Lift {
        input start, up: bool;
        output speed: u16;

        initial step Idle;
        step Up { speed = 40; }
        step Watch;

        Idle -[start]-> Up -[up]-> Watch -[speed == 0]-> Idle;
    }
}

fn main() {}
