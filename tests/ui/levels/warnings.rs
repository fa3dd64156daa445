// A warning by default, in a program that denies warnings, and one that the chart denies itself.
#![deny(warnings)]

use grafcet::grafcet;

grafcet! {
    sfc Motor {
        input on, spare: bool;

        initial step Off;
        step On;

        Off -[on]-> On -[!on]-> Off;
    }
}

grafcet! {
    sfc Lamp {
        input on: bool;
        #[deny(grafcet::undriven_output)]
        output lamp: bool;

        initial step Off;
        step On;

        Off -[on]-> On -[!on]-> Off;
    }
}

fn main() {}
