use grafcet::grafcet;

grafcet! {
    #[derive(Debug)]
    #[cfg_attr(feature = "horn", inline)]
    #[repr(C)]
    sfc Lamp {
        #![derive(Hash)]
        #[derive(Hash)]
        input push: bool;
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
