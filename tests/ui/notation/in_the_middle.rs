//! Attributes, keywords of Rust, types without a size and edges without parentheses, each where it stands.
use grafcet::grafcet;

grafcet! {
    sfc Attributes {
        input #[allow(unused)] a, b: bool;
        output q: bool #[allow(unused)];

        initial #[doc(hidden)] step A { q; }
        step #[doc(hidden)] B;
        step C #[doc(hidden)] { q; }

        A -[a]-> #[doc(hidden)] B -[b]-> C;
        C -[a && b]-> A #[doc(hidden)];
    }
}

grafcet! {
    sfc Keywords {
        input type, go: bool;
        output q: bool;

        initial step A;
        step B { q; }

        A -[type && go]-> B -[rising go]-> A;
        B -[go && falling q]-> A;
    }
}

grafcet! {
    sfc Types {
        input name: &str;
        input raw: [u8];
        input text: str;
        output last: &u8 = &0;
        action show(text: &str);

        initial step A;
        step B { P1 show("b"); P0 last = &1; }

        A -[name == "x" && raw.is_empty()]-> B -[text == "y" && *last == 1]-> A;
    }
}

grafcet! {
    sfc Twice {
        input a: bool;
        action show();
        action show(text: &str);

        initial step A { show(); }
        A -[a]-> A;
    }
}

fn main() {}
