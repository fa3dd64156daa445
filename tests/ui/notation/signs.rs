use grafcet::grafcet;

// Signs that Rust writes in another way, or reads in another way than it looks.
grafcet! {
    grafcet Tank {
        input mut level: u8;
        input low, high: u8;
        output inlet, outlet: bool;

        initial step Idle;
        step Fill { inlet; }
        step Drain { outlet; }

        Idle -[low =< 3]-> Fill -[high => 9]-> Idle;
        Idle -[low > 3 & high < 5]-> Drain -[!(low == 3 | high == 5)]-> Idle;
    }
}

fn main() {}
