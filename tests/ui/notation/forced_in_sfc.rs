use grafcet::grafcet;

// One message: an `sfc` could not declare the partial grafcet either.
grafcet! {
    sfc Press {
        input start, estop: bool;
        output ram: bool;

        initial step Rest;
        step Down { ram; }
        step Stopped { force Production {}; }

        Rest -[start]-> Down -[!start]-> Rest;
        any -[estop]-> Stopped -[!estop]-> Rest;
    }
}

fn main() {}
