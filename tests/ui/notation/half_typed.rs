//! Words that are begun: each says which one it becomes, and what it declares is known.
use grafcet::grafcet;

grafcet! {
    sfc Tank {
        inp start, full: bool;
        outp valve: bool;
        para soak: time = 5s;
        act heat(setpoint: i16);

        ini step Idle;
        ste Fill { N valve; }
        ste Ini { N heat(80); }

        Idle -[start]-> Fill -[full]-> Ini -[soak/Ini]-> Idle;
    }
}

fn main() {}
