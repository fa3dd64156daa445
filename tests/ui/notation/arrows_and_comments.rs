use grafcet::grafcet;

grafcet! {
    sfc Arrows {
        input a, b: bool; # an input; with "more" in 5 words
        output q: bool;
        initial step A { q; }
        step B { # what is done
            D 1.5.5s q;
        }
        A -[a <=> b]-> B -[a ==> b]-> A;
        A -[1.5.5s/A]-> B;
        always a --> b;
        always (a ==> b) && a;
        never a -> b;
    }
}

fn main() {}
