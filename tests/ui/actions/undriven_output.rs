use grafcet::grafcet;

grafcet! {
    grafcet Tank {
        #![deny(grafcet::undriven_output)]
        input low, high: bool;
        output valve, alarm: bool;

        initial step Wait;
        step Fill { valve; }

        Wait -[low]-> Fill -[high]-> Wait;
    }
}

fn main() {}
