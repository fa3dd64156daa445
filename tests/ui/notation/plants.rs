use grafcet::grafcet;

grafcet! {
    sfc Wires {
        input start, top, bottom: bool;
        input level: u8;
        output lower, motor: bool;

        initial step Rest;
        step Down { lower; motor; }
        Rest -[start && top]-> Down -[bottom || level > 3]-> Rest;
    }

    plant Cylinder {
        input lowre: bool;
        input motor: u8;
        output tpo, bottom: bool;
        output level: bool;
        initial step Top { tpo; }
        step Bottom { bottom; level; }
        Top -[lowre && motor > 1]-> Bottom -[!lowre]-> Top;
    }

    plant Second {
        input lower: bool;
        output bottom: bool;
        initial step Up;
        step Low { bottom; }
        Up -[lower]-> Low -[!lower]-> Up;
    }
}

grafcet! {
    sfc Mentions {
        input start, top: bool;
        output lower: bool;

        initial step Rest;
        step Down { lower; }
        Rest -[start && top]-> Down -[!top]-> Rest;

        never Piston::Botom.X;
        never Piston::Going.T > 3s;
        never Piston::jamed && Down.X;
    }

    plant Piston {
        input lower: bool;
        output top: bool;
        fault jammed;
        initial step Top { top; }
        step Going;
        step Bottom;
        Top -[lower && !jammed]-> Going -[1s/Going]-> Bottom -[!lower]-> Top;
    }
}

grafcet! {
    sfc Looks {
        input start, top: bool;
        output lower: bool;

        initial step Rest;
        step Down { lower; }
        Rest -[start && top]-> Down -[Ram::Bottom.X]-> Rest;
    }

    plant Ram {
        input lower: bool;
        output top: bool;
        initial step Top { top; }
        step Bottom;
        Top -[lower]-> Bottom -[!lower]-> Top;
    }
}

grafcet! {
    sfc Forms {
        input start, top: bool;
        output lower: bool;

        initial step Rest;
        step Down { lower; }
        Rest -[start && top]-> Down -[!top]-> Rest;
    }

    plant Rod {
        clock 1ms;
        param reach: u8 = 1;
        input lower: bool;
        output top: bool;
        fault jammed: u8;
        choice 3;
        initial step Top { top; }
        step Going;
        step Bottom;
        either Top -[lower && reach > 0]-> Going;
        either Going -[3s..2s/Going]-> (Bottom or Top);
        Bottom -[1s..=2s/Bottom]-> Top;
        Top -[lower]-> Going;
        never Bottom.X;
        assume cycle within 10ms;
    }
}

grafcet! {
    sfc Twice {
        input start, top: bool;
        output lower: bool;

        initial step Rest;
        step Down { lower; }
        Rest -[start && top]-> Down -[!top]-> Rest;
    }

    plant Same {
        input lower: bool;
        output top: bool;
        initial step Top { top; }
        step Bottom;
        Top -[lower]-> Bottom -[!lower]-> Top;
    }

    #[cfg(all(test, not(test)))]
    plant Same {
        input lower: bool;
        initial step Off;
        step On;
        Off -[lower]-> On -[!lower]-> Off;
    }
}

grafcet! {
    plant Alone {
        input lower: bool;
        output top: bool;
        initial step Top { top; }
        step Bottom;
        Top -[lower]-> Bottom -[!lower]-> Top;
    }
}

fn main() {}
