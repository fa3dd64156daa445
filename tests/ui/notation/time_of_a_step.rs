use grafcet::grafcet;

grafcet! {
    sfc Alone {
        input a: bool;
        output q: bool;
        let t = B.T;
        let long = t > 3s && B.T < 5s;
        let c = a && !B.T;
        initial step A;
        step B { q if B.T; }
        A -[a]-> B -[B.T]-> A;
        B -[a && (B.T)]-> A;
        B -[3s/B.T]-> A;
        B -[rising(B.T) || 2s/(B.T)/1s]-> A;
        B -[long || c]-> A;
        B -[!t || a]-> A;
        never a || B.T;
    }
}

grafcet! {
    grafcet Elsewhere {
        input a: bool;
        output q: bool;
        partial One {
            initial step A;
            step B;
            A -[a]-> B -[Two::C.T || 2s/a]-> A;
        }
        partial Two {
            initial step C { q if !C.T; }
            C -[a && M.T]-> M -[rising(a)]-> C;
            macro step M {
                entry step E;
                exit step F;
                E -[a]-> F;
            }
        }
    }
}

fn main() {
    let _ = (Alone::new(), Elsewhere::new());
}
