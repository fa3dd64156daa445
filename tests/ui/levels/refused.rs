use grafcet::grafcet;

grafcet! {
    #[allow(grafcet::several_initial_step)]
    sfc Motor {
        #![allow(grafcet::no_initial_step, grafcet::unknown_stepp, grafcet::colour)]
        #![deny(grafcet::unreachable_step)]
        #![expect(grafcet::several_initial_steps)]
        #![allow(dead_code)]
        #![warn(grafcet)]

        input on: bool;

        step Off;
        #[warn(grafcet::isolated_step)]
        step On;

        #[allow(somebody::elses)]
        Off -[on]-> On -[!on]-> Off;
    }
}

fn main() {}
