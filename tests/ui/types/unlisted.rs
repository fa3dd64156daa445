//! Where the variants of an enum would keep two conditions apart, if they were listed.
use grafcet::grafcet;

#[derive(Clone, Copy, Default, PartialEq)]
pub enum Mode {
    #[default]
    Off,
    Auto,
    Manual,
}

grafcet! {
    sfc Mixer {
        input start, done: bool;
        input mode: Mode;
        output speed: u16;

        initial step Idle;
        step Stir { speed = 40 if mode == Mode::Auto; }
        step Heat { speed = 60 if mode == Mode::Manual; }
        step Cool { speed = 80 if mode != Mode::Manual && mode != Mode::Auto; }

        Idle -[start]-> (Stir, Heat, Cool);
        (Stir, Heat, Cool) -[done]-> Idle;
    }
}

grafcet! {
    grafcet Race {
        input start, done: bool;
        input mode: Mode;
        output speed: u16 = 0;

        initial step Idle;
        step Stir;
        step Heat;
        step Slow { P1 speed = 40; }
        step Fast { P1 speed = 80; }

        Idle -[start]-> (Stir, Heat);
        Stir -[mode == Mode::Auto]-> Slow;
        Heat -[mode == Mode::Manual]-> Fast;
        (Slow, Fast) -[done]-> Idle;
    }
}

grafcet! {
    grafcet Interlock {
        input mode: Mode;
        output left, right: bool;

        initial step Idle { left if mode == Mode::Auto; right if mode == Mode::Manual; }
        never left && right;
    }
}

// A list of the variants is no help here.
grafcet! {
    sfc Either {
        input start, done: bool;
        input mode: Mode;
        output speed: u16;

        initial step Idle;
        step Stir { speed = 40 if mode == Mode::Auto; }
        step Heat { speed = 60 if mode != Mode::Manual; }

        Idle -[start]-> (Stir, Heat);
        (Stir, Heat) -[done]-> Idle;
    }
}

fn main() {}
