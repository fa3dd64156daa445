use grafcet::grafcet;

grafcet! {
    sfc Tank {
        inputs level: u16;
        input low = bool;
        input high: bool = true;
        valve: bool;
        output lamp, : bool;
        output horn: ;
        let count: u16 = 0;
        action fill(amount);
        fn empty() {}
        clock 5;
        transition go;

        initial step Idle { N lamp; }
    }
}

fn main() {}
