//! A keyword, a name or an operand that is forgotten: one message, and nothing that follows from it.
use grafcet::grafcet;

grafcet! {
    sfc Keywords {
        start, stop: bool;
        input low, , high: bool;
        output , valve pump: bool;

        initial step Idle;
        Fill step { N valve; }
        step Empty { N pump; }

        Idle -[start && low]-> Fill -[stop || high]-> Empty -[low]-> Idle;
    }
}

grafcet! {
    sfc Operands {
        input a, b: bool;
        output q: bool;

        initial step A;
        step B { q if && a; }

        A -[&& a]-> B -[b && || a]-> A;
    }
}

fn main() {}
