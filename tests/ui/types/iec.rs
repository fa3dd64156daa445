// Types of IEC 61131-3, and of C.
use grafcet::grafcet;
grafcet! {
    pub sfc Iec {
        input a: BOOL;
        input level: INT;
        input name: STRING[80];
        output speed: REAL;
        var count: UDINT := 5;
        var list: ARRAY[0..3] OF INT;
        param soak: TIME = 5s;
        var n: int = 0;
        action say(text: STRING, n: WORD);
        initial step A { speed = 3.0; }
        step B { P1 { count += 1; } say(name, 3); P1 n = 1; }
        A -[a && level > 3 && count < 3 && n == 0]-> B -[soak/B]-> A;
    }
}
// A path is a type of one's own.
type INT = i8;

grafcet! {
    sfc Own {
        input level: self::INT;
        initial step A;
        step B;
        A -[level > 100]-> B -[level < 2]-> A;
    }
}

fn main() { let _ = Iec::new(); }
