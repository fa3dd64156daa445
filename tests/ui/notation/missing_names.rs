use grafcet::grafcet;

grafcet! {
    sfc Nameless {
        input a: bool;
        output q: bool;
        initial step;
        step B { q; }
        A -[a]-> B -[!a]-> A;
        never A.X && B.X;
    }
}

grafcet! {
    sfc Forgotten {
        input a, b: bool;
        output q: bool;
        initial step A { q; }
        step B;
        A -[a]-> ;
        -[b]-> A;
    }
}

grafcet! {
    sfc TwoAndOne {
        input a: bool;
        output q: bool;
        initial step;
        step B { q; }
        A -[a]-> B -[!a]-> C -[a]-> A;
    }
}

fn main() {}
