use grafcet::grafcet;

grafcet! {
    #[derive(Debug)]
    sfc Lamp {
        #[cfg(feature = "horn")]
        output horn: bool;
        output light: bool;

        initial step Dark;
        /// This reaches nobody.
        clock 1ms;
        #![allow(grafcet::isolated_step)]
    }
}

fn main() {}
