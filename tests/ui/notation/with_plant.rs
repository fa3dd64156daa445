use grafcet::grafcet;

grafcet! {
    sfc Press {
        input start, top, bottom: bool;
        output lower: bool;

        initial step Rest;
        step Down { lower; }
        step Up;
        Rest -[start && top]-> Down -[bottom]-> Up -[top]-> Rest;

        never Up.X && Cylinder::Top.X && !top;
        home Rest;
    }

    #[cfg(test)]
    plant Cylinder {
        input lower: bool;
        output top, bottom: bool;
        initial step Top { top; }
        step Bottom { bottom; }
        Top -[lower]-> Bottom -[!lower]-> Top;
    }
}

fn main() {}
