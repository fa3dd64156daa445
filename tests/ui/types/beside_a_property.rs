//! What a property cannot decide hides no mistake of rustc's: the chart's code is there.

use grafcet::grafcet;

grafcet! {
    pub sfc Light {
        input on, off: bool;
        output lamp, bell: bool;

        initial step Dark;
        step Flash {
            N lamp if Flash.T.ticks() % 1000 < 500;
            N bell;
        }

        Dark -[on]-> Flash -[off]-> Dark;

        never lamp && off;
        never bell && Dark.X;
        home Dark;
    }
}

fn main() {}
