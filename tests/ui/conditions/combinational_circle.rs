use grafcet::grafcet;

grafcet! {
    grafcet Belt {
        input start, jam: bool;
        var clear: bool;
        var moving: bool;

        initial step Idle { clear if !moving; }
        step Run { moving if clear; }

        Idle -[start && clear]-> Run -[jam || moving]-> Idle;
    }
}

fn main() {}
