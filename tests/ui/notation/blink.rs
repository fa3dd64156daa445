use grafcet::grafcet;

grafcet! {
    sfc Times {
        param t_on: time = 500ms;
        output lamp, horn: bool;

        initial step A { lamp if blink(0s); horn if blink(700ms/0ms); }
        step B { lamp if blink(500); horn if blink(t_on/300ms); }
        step C { lamp if blink(0.1ms); horn if blink(1194h); }
        step F { lamp if blink(597h); horn if blink(1000h/500h); }
        step E { lamp if blink(lamp); horn if blink(1.5x); }

        A -[1s/A]-> B -[1s/B]-> C -[1s/C]-> F -[1s/F]-> E -[1s/E]-> A;
    }
}

grafcet! {
    grafcet Steps {
        input a, b: bool;
        output lamp, horn: bool;

        initial step A { lamp if blink(500ms/A); horn if blink(700ms, 300ms); }
        step B { lamp if blink(500ms, A.X); horn if blink(500ms, Bb); }
        step C { lamp if blink(); horn if blink(500ms, a); }
        step F { lamp if blink(500ms, A, B); horn if blink(500ms, 3 + 4); }

        A -[a]-> (B, C);
        (B, C) -[b && blink(500ms)]-> F -[!a]-> A;
        () -[b && blink(500ms)]-> B;
        never lamp && blink(500ms);
        assume never a && blink(500ms, A);
    }
}

fn main() {}
