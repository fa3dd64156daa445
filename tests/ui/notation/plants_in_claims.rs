use grafcet::grafcet;

grafcet! {
    sfc Press {
        input start, top: bool;
        output lower: bool;
        let _stuck = lower && Cylinder::jammed;

        initial step Rest;
        step Down { lower; }
        Rest -[start && top]-> Down -[!top]-> Rest;

        never _stuck && start;
        never Cylinder::Up.late;
        never Cylinder::Up.T > 3s && start;
        never blink(300ms, Cylinder::Up) && start;
        never Cylinder::top.X && start;
        never Cylinder::jammed && Cylinder::jammed.X;
        never 3s/Cylinder::Up && rising(Cylinder::Up.X);
    }

    plant Cylinder {
        input lower: bool;
        output top: bool;
        fault jammed;
        initial step Up { top; }
        step Low;
        Up -[lower && !jammed]-> Low -[!lower]-> Up;
    }
}

fn main() {
    let _ = (Press::new(), Cylinder::new());
}
