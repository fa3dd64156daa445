use grafcet::grafcet;

#[derive(Clone, Copy, Default, PartialEq)]
enum Mode {
    #[default]
    Off,
    Auto,
}
#[allow(unused_imports)]
use Mode::*;

grafcet! {
    sfc Modes {
        input mode: Mode;
        output q: bool;
        initial step Off;
        step Auto { q if Off != mode; }
        Off -[mode == Auto]-> Auto -[mode == Mode::Off]-> Off;
    }
}

fn main() {}
