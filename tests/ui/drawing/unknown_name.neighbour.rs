use grafcet::grafcet;

// Constants and functions of the surrounding Rust are Rust's.
const COLD: bool = false;

fn plausible(door: bool, hot: bool) -> bool {
    !(door && hot)
}

grafcet! {
    sfc Oven {
        input door, hot: bool;
        output burner, ready: bool;

        initial step Idle { N ready; }
        step Heating { N burner if !door; }

        Idle -[!door && plausible(door, hot)]-> Heating -[hot || COLD]-> Idle;
    }
}

fn main() {
    let _ = Oven::new().cycle(&OvenInputs::default());
}
