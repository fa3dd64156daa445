use grafcet::grafcet;

grafcet! {
    sfc Counter {
        input part: bool;
        output full: bool;
        output count: u16;

        initial step Wait;
        step Full { N full; }

        Wait -[part => count = count + 1, full = true]-> Full -[!part]-> Wait;
    }
}

fn main() {}
