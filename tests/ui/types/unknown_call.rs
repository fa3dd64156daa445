// Nobody can know what a method of a foreign type, or a macro, does with what it is given.
use grafcet::grafcet;

#[derive(Clone, Copy, Default)]
pub struct Totals(u16);

impl Totals {
    fn all(&self) -> u16 {
        self.0
    }
}

macro_rules! twice {
    ($n:expr) => {
        $n * 2
    };
}

grafcet! {
    sfc Counter {
        input go: bool;
        output totals: Totals = Totals(0);
        output n: u16;
        var sum: u16 = 0;

        initial step Idle { totals = Totals(1); n = 5; }
        step Busy { P1 { sum += totals.all(); } P0 { sum += twice!(n); } }

        Idle -[go && sum < 9]-> Busy -[!go]-> Idle;
    }
}

// An edge and a delay look at declared names only.
grafcet! {
    sfc Edges {
        input go: bool;
        input list: [bool; 3];

        initial step Idle;
        step Busy;

        Idle -[list.iter().any(|x| rising(x) || 5s/x)]-> Busy -[go]-> Idle;
    }
}

fn main() {}
