use grafcet::grafcet;

grafcet! {
    grafcet Tank {
        input low, high: bool;
        output valve, alarm: bool;

        initial step Wait { alarm if low && high; }
        step Fill { valve; }

        Wait -[low && !high]-> Fill -[high]-> Wait;
    }
}

fn main() {}
