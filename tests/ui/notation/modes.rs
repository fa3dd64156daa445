use grafcet::grafcet;

grafcet! {
    sfc Twice {
        input go: bool;
        modes;
        modes;
        initial step A;
        step B;
        A -[go]-> B -[!go]-> A;
    }
}

grafcet! {
    sfc Taken {
        input go, manual: bool;
        modes;
        output push: bool;
        initial step A;
        step B { push; }
        A -[go && !manual]-> B -[!go]-> A;
    }
}

grafcet! {
    grafcet Around {
        modes;
        input go: bool;
        initial step A;
        macro step M {
            modes;
            entry step In;
            exit step Out;
            In -[go]-> Out;
        }
        A -[go]-> M -[!go]-> A;
        partial Side {
            modes;
            initial step X;
            step Y;
            X -[go]-> Y -[!go]-> X;
        }
    }
}

grafcet! {
    grafcet Idle {
        input go, stop: bool;
        output lamp: bool;
        initial step A { lamp if go; }
        partial Side {
            modes;
            initial step X;
            step Y;
            any -[rising(stop)]-> X;
            () -[rising(go)]-> Y;
        }
    }
}

grafcet! {
    sfc Asked {
        modes now;
        initial step A;
    }
}

fn valid() -> bool {
    true
}

grafcet! {
    sfc Calls {
        modes;
        input go: bool;
        initial step A;
        step B;
        step C;
        A -[valid()]-> B -[go]-> A;
        A -[else]-> C -[go]-> A;
    }
}

fn main() {}
