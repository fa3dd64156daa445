// A time as IEC 61131-3 writes it; Rust has its own word about the sign.
use grafcet::grafcet;

grafcet! {
    sfc Times {
        input on, off: bool;
        input n: u16;
        output q, lamp: bool;
        var c: u16 = 0;

        initial step A { q; L T#5s lamp; }
        step B { lamp; P1 c = c + n; }

        A -[T#5s/A]-> B -[off]-> A;
    }
}

fn main() {}
