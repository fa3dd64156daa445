// A warning of the compiler at the user's tokens; here it stops the compilation, so that it can be seen.
#![deny(deprecated)]

use grafcet::grafcet;

grafcet! {
    sfc Pumps {
        #![warn(grafcet::several_initial_steps)]
        initial step Left;
        initial step Right;
    }
}

fn main() {}
