use grafcet::grafcet;

grafcet! {
    sfc Drive {
        input start: bool;
        output speed: u16;
        output relay: bool;
        output brake: bool = true;

        initial step Idle {
            brake;
            N start;
            on rising(start) relay = true;
        }
        step Run {
            S speed if start;
            P1 relay;
            S relay = true;
            N Idle;
            start();
        }

        Idle -[start]-> Run -[!start]-> Idle;
    }
}

grafcet! {
    grafcet Lamps {
        input start: bool;
        output lamp, horn: bool;

        initial step Dark;
        step Lit { P lamp; SD 2s horn; }

        Dark -[start]-> Lit -[!start]-> Dark;
    }
}

fn main() {}
