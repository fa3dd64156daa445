use grafcet::grafcet;

grafcet! {
    sfc Values {
        input a: bool;
        output q: bool;
        initial step A { N S; q if self; D SL q; P1 INIT(); }
        step B { N mod; R = 3; }
        A -[rising && a]-> B -[falling || N || S == 3]-> A;
        A -[3s/SD || self.ready && a]-> B;
        A -[a]-> P1;
        A -[a]-> r#mod -[r#fn]-> A;
        home INIT;
    }
}

grafcet! {
    grafcet Partials {
        input a: bool;
        initial step A { force INIT {}; force self {}; }
        step B;
        A -[a]-> B -[P0::B.X || DS.X]-> A;
    }
}

fn main() {}
