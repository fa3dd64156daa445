use grafcet::grafcet;

grafcet! {
    grafcet Chart {
        input top: bool;
        output lower: bool;
        partial One {
            initial step Rest { lower; }
            step Down;
            Rest -[top]-> Down -[!top]-> Rest;
        }
        home Ram::Top;
        home One::Rest;
    }

    plant Ram {
        input lower: bool;
        output top: bool;
        fault jammed;
        choice slow, r#fast;
        partial Inner { initial step Idle; }
        initial step Top { top; force Inner {}; }
        enclosing step Bottom { partial Deep { initial step Deepest; } }
        macro step Going { entry step E; exit step F; E -[lower]-> F; }
        Top -[lower]-> Going -[lower]-> Bottom -[!lower]-> Top;
    }
}

grafcet! {
    sfc Idle {
        input top: bool;
        output lower: bool;
        initial step Rest { lower; }
        step Down;
        Rest -[top]-> Down -[!top]-> Rest;
    }

    #[deny(grafcet::unused_input)]
    plant Rod {
        input lower: bool;
        output top: bool;
        fault jammed;
        choice slow, r#fast;
        initial step Top { top; }
        step Bottom;
        Top -[lower]-> Bottom -[!lower]-> Top;
    }
}

fn main() {}
