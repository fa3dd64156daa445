//! What a param may be, and what of its range is wrong.

use grafcet::grafcet;

const MOST: u8 = 9;

grafcet! {
    pub sfc Outside {
        param parts: u8 in 1..=8 = 9;
        param soak: time in 1s..10s = 10s;
        param count: u8 in 1..=8;
        initial step A;
        step B;
        A -[parts > 3 && A.T > soak]-> B -[count > 3]-> A;
    }
}

grafcet! {
    pub sfc Constant {
        param parts: u8 in 1..=8 = MOST;
        initial step A;
        step B;
        A -[parts > 3]-> B -[parts < 3]-> A;
    }
}

grafcet! {
    pub sfc Ends {
        param none: u8 in 8..8 = 8;
        param large: u8 in 1..=256 = 8;
        param soak: time in 1..=10 = 5s;
        initial step A;
        step B;
        A -[none > 3 && A.T > soak]-> B -[large > 3]-> A;
    }
}

grafcet! {
    pub sfc Elsewhere {
        input level: u8 in 1..=8;
        var count: u8 in 1..=8 = 1;
        initial step A { P1 count = 3; }
        step B;
        A -[level > 3]-> B -[count > 3]-> A;
    }
}

grafcet! {
    pub sfc Taken {
        param parts: u8 in 1..=8 = 8;
        initial step A;
        step B;
        A -[parts > 3]-> B -[parts < 3]-> A;
    }
}

fn main() {
    let one: Taken = Taken::with_params(TakenParams { parts: 9 });
}
