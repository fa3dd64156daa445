use grafcet::grafcet;

grafcet! {
    sfc Tank {
        input low: bool;
        output valve, lamp, horn: bool;
        output count: u16;

        initial Idle { N lamp; }
        state Filling {
            n valve;
            X lamp;
            N;
            L horn;
            count += 1;
            count := 1;
            if low { N horn; }
            { count = 1; }
            N S lamp;
            N 5s lamp;
            Idle -[low]-> Filling;
        }
        N lamp;

        Idle -[low]-> Filling -[!low]-> Idle;
    }
}

fn main() {}
