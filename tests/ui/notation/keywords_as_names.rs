//! A keyword of Rust that is declared as a name is refused there, and nowhere it is read.
use grafcet::grafcet;

grafcet! {
    sfc Crane {
        input box, go: bool;
        input match: u8;
        output abstract: bool;
        var final: u8 = 0;
        let try = (box && go) || match > 3;

        initial step Idle;
        step Lift { N abstract if !box; P1 { final = match + 1; } }
        step do;

        Idle -[box && (match == 2 || go)]-> Lift -[rising(box) && 2s/Lift]-> do;
        do -[try && do.X && final > 1]-> Idle;

        never box && Lift.X && match > 8;
    }
}

fn main() {
    let mut crane = Crane::new();
    let _ = crane.cycle(&CraneInputs { r#box: true, ..CraneInputs::default() }, grafcet::Ticks::ZERO);
}
