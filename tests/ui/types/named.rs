use grafcet::grafcet;

// A mistake in a named condition is shown there, and once, however often the name is used.
grafcet! {
    pub sfc Motor {
        input level: u16;
        input on: bool;
        output relay, lamp: bool;
        let high = level || on;
        let sum = level + 1;

        initial step Off { N lamp if high; }
        step On { N relay if !high; }

        Off -[high]-> On -[!high]-> Off;
        On -[on && sum]-> Off;
        On -[sum]-> Off;
    }
}

fn main() {}
