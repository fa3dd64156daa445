use grafcet::grafcet;

grafcet! {
    sfc Motor {
        input on, off, hot: bool;
        output relay: bool;

        initial step Off;
        step On { N relay; }
        step Tripped;

        Off -[on]-> On -[off]-> Off;
        On -[hot]-> Tripped -[off && !hot]-> Off;
    }
}

fn main() {}
