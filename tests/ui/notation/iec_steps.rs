// Steps and transitions as they are written elsewhere.
use grafcet::grafcet;

grafcet! {
    sfc Numbers {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; }
        step B { lamp; P1 c = c + n; }
        step 10;
        step 20;

        A -[on]-> 10 -[off]-> 20 -[on]-> (A);
        (20) -[off]-> B -[on]-> A;
    }
}

grafcet! {
    sfc Bare {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; }
        step B { lamp; P1 c = c + n; }

        A -> on -> B -[off]-> A;
    }
}

grafcet! {
    sfc Label {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; }
        step B { lamp; P1 c = c + n; }

        t1: A -[on]-> B;
        t2: B -[off]-> A;
    }
}

grafcet! {
    sfc After {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; }
        step B { lamp; P1 c = c + n; }

        A -> B: on;
        B -[off]-> A;
    }
}

grafcet! {
    sfc Fat {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; }
        step B { lamp; P1 c = c + n; }

        A => B;
        B ==> A;
    }
}

grafcet! {
    sfc FatAfter {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; }
        step B { lamp; P1 c = c + n; }

        A -[on]-> B => A;
        B -[off]-> A;
    }
}

grafcet! {
    sfc Inside {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; }
        step B { lamp; P1 c = c + n; }
        step C;
        step D1;

        A -[on]-> (B, C);
        (B -[n > 3]-> D1, C) -[off]-> A;
    }
}

grafcet! {
    sfc Braces {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; }
        step B { lamp; P1 c = c + n; }
        step C;

        A -[on]-> {B, C};
        [B, C] -[off]-> A;
    }
}

grafcet! {
    sfc And {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; }
        step B { lamp; P1 c = c + n; }
        step C;

        A -[on]-> B & C;
        (B, C) -[off]-> A;
    }
}

grafcet! {
    sfc Ends {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        INITIAL_STEP A { q; }
        step B { lamp; P1 c = c + n; }
        STEP D1: N q; END_STEP

        TRANSITION FROM A TO B := on; END_TRANSITION
        B -[off]-> A;
    }
}

grafcet! {
    sfc List {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; }
        step B { lamp; P1 c = c + n; }
        step C, D1;

        A -[on]-> B -[off]-> A;
    }
}

grafcet! {
    sfc Slip {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; }
        step B { lamp; P1 c = c + n; }
        step Heat;

        A -[on]-> b -[off]-> Hat -[on]-> A;
    }
}

fn main() {}
