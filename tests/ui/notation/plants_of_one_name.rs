use grafcet::grafcet;

grafcet! {
    pub sfc Press {
        input a: bool;
        output q: bool;
        initial step A { q; }
        step B;
        A -[a]-> B -[!a]-> A;
    }

    plant Press {
        input q: bool;
        output a: bool;
        initial step T { a; }
        step U;
        T -[q]-> U -[!q]-> T;
    }
}

grafcet! {
    grafcet Twice {
        input top: bool;
        output lower: bool;
        initial step Rest { lower; }
        step Down;
        Rest -[top]-> Down -[!top]-> Rest;
        never Same::Top.X && Down.X;
    }

    plant Same {
        input lower: bool;
        output top: bool;
        initial step Top { top; }
        step Bottom;
        Top -[lower]-> Bottom -[!lower]-> Top;
    }

    plant Same {
        input lower: bool;
        initial step Off;
        step On;
        Off -[lower]-> On -[!lowr]-> Off;
    }
}

grafcet! {
    grafcet Line {
        input top: bool;
        output lower: bool;
        initial step Rest { lower; }
        enclosing step Down {
            partial Lift {
                linked step Up;
                step Low;
                Up -[top]-> Low -[!top]-> Up;
            }
        }
        Rest -[top]-> Down -[!top]-> Rest;
        never Lift::Up.X && Rest.X;
    }

    plant Lift {
        input lower: bool;
        output top: bool;
        initial step Up { top; }
        step Low;
        Up -[lower]-> Low -[!lower]-> Up;
    }
}

fn main() {
    let _ = (Press::new(), Twice::new(), Same::new(), Line::new(), Lift::new());
}
