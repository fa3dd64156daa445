use grafcet::grafcet;

// The innermost attribute counts, and of two in one place the last.
grafcet! {
    #[allow(grafcet::several_initial_steps)]
    sfc Pumps {
        #![deny(grafcet::several_initial_steps)]
        initial step Left;
        initial step Right;
    }
}

fn main() {}
