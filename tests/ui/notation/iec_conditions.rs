// Conditions as IEC 61131-3, IEC 60848 and ladder diagrams write them: each with what is written here.
use grafcet::grafcet;

grafcet! {
    sfc Words {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; }
        step B { lamp; P1 c = c + n; }

        A -[on AND NOT off]-> B;
        B -[n MOD 2 = 0 OR on <> off]-> A;
    }
}

grafcet! {
    sfc Arrows {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; }
        step B { lamp; P1 c = c + n; }

        A -[^on]-> B -[falling(on) || ^off]-> A;
    }
}

grafcet! {
    sfc Space {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; }
        step B { lamp; P1 c = c + n; }

        A -[5 s/A]-> B -[off]-> A;
    }
}

grafcet! {
    sfc TimeAlone {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;
        param t: time = 2s;

        initial step A { q; }
        step B { lamp; N lamp if 1s; }

        A -[5s]-> B -[t && off]-> A;
    }
}

grafcet! {
    sfc StepVariables {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; }
        step B { lamp; P1 c = c + n; }
        step S2;

        A -[on && !XB]-> B -[5s/X2]-> S2 -[X2]-> A;
        B -[5s/X7]-> A;
    }
}

grafcet! {
    sfc Sum {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;
        param t: time = 2s;

        initial step A { q; }
        step B { lamp; P1 c = c + n; }

        A -[(t + 1s)/A]-> B -[off]-> A;
    }
}

grafcet! {
    sfc Address {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; }
        step B { lamp; P1 c = c + n; }

        A -[%IX0.0 && on]-> B -[off]-> A;
    }
}

grafcet! {
    sfc Constants {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; }
        step B { lamp; P1 c = c + n; }

        A -[TRUE]-> B -[1]-> A;
        B -[!0 && c == 3 && FALSE]-> A;
    }
}

grafcet! {
    sfc Blocks {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; }
        step B { lamp; P1 c = c + n; }

        A -[R_TRIG(on)]-> B -[TON(on, 5s)]-> A;
        B -[off.falling()]-> A;
    }
}

grafcet! {
    sfc Algebra {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; }
        step B { lamp; P1 c = c + n; }

        A -[on + off]-> B -[(on * !off) + off]-> A;
        B -[on.off]-> A;
    }
}

grafcet! {
    sfc Nothing {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; }
        step B { lamp; N lamp if || on; }

        A -[|| on]-> B -[off && || on]-> A;
        never || A.X;
    }
}

grafcet! {
    sfc Asked {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; }
        step B { lamp; P1 c = c + n; }

        A -[if on]-> B -[after 5s]-> A;
    }
}

fn main() {}
