use grafcet::grafcet;

grafcet! {
    sfc Tank {
        input level: u16;
        output valve: bool;

        initial step Wait;
        step Fill { N valve; }

        Wait -[level < 10 || level > 5]-> Fill -[level > 90]-> Wait;
    }
}

fn main() {}
