// What a step does, as it is written elsewhere.
use grafcet::grafcet;

grafcet! {
    sfc Comma {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; N q, N lamp; }
        step B { lamp; P1 c = c + n; }

        A -[on]-> B -[off]-> A;
    }
}

grafcet! {
    sfc After {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; lamp L 5s; }
        step B { lamp; q N; }

        A -[on]-> B -[off]-> A;
    }
}

grafcet! {
    sfc Called {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; N(lamp); }
        step B { lamp; q(N); }

        A -[on]-> B -[off]-> A;
    }
}

grafcet! {
    sfc Colon {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; N: lamp; }
        step B { lamp; S:q; }

        A -[on]-> B -[off]-> A;
    }
}

grafcet! {
    sfc Words {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; entry { c = 1; } }
        step B { lamp; exit { c = 2; } }

        A -[on]-> B -[off]-> A;
    }
}

grafcet! {
    sfc Loops {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; while on { c = 1; } }
        step B { lamp; P1 c = c + n; }

        A -[on]-> B -[off]-> A;
    }
}

grafcet! {
    sfc Assigned {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; P1 { c := 3; } }
        step B { lamp; P1 { if on { c := 3; } } }

        A -[on]-> B -[off]-> A;
    }
}

grafcet! {
    sfc Counted {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; P1 c++; }
        step B { lamp; P1 c--; }

        A -[on]-> B -[off]-> A;
    }
}

fn main() {}
