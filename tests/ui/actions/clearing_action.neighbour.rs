use grafcet::grafcet;

grafcet! {
    sfc Counter {
        input part: bool;
        output full: bool;
        output count: u16;

        initial step Wait;
        step Full { P1 count = count + 1; N full; }

        Wait -[part]-> Full -[!part]-> Wait;
    }
}

fn main() {}
