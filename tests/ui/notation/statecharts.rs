//! Transitions as statecharts, textual languages and Rust have them.
use grafcet::grafcet;

grafcet! {
    grafcet Drawn {
        input a, b: bool;
        output q: bool;

        initial step A { q; }
        step B;

        A -> B [a];
        B -> A [b] / q;
        A -> B if a;
        B -> A when b;
        A + Event [a] / action = B;
        if a { A -> B } else if b { B -> A } else { A }
        match a { true => A, false => B }
        A -[a]-> B -[b]-> A;
    }
}

grafcet! {
    grafcet Written {
        input a, b: bool;
        output q: bool;
        var n: u8 = 0;

        initial step A {
            q;
            goto B if a;
            transition B: a;
            when a goto B;
            on a => B;
        }
        step B {
            q unless a;
            N q when b;
            self.n = 3;
        }

        A -[self.a]-> B;
        A -[otherwise]-> A;
        B -[b && n > 2]-> A;
        always q -> a;
        A leads_to B in 5s;
    }
}

grafcet! {
    sfc Itemised {
        use core::time::Duration;
        struct Data { level: u8 }
        enum Mode { Off }
        fn empty() {}
        initial step A;
    }
}

// A language of lists of transitions, and claims as tests have them.
grafcet! {
    sfc Listed {
        input a, b: bool;
        output q: bool;

        *A { q; }
        initial step A { q; }
        step B;

        *A + E [a] = B;
        * -[a]-> B;
        all -[a]-> B;
        any but A -[b]-> A;
        A -[a]-> B -[b]-> A;

        assert !q || A.X;
        Never (q && B.X);
        eventually q;
        q implies a;
    }
}

fn main() {}
