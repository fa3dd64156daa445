// rustc's own errors point at the user's tokens: initial values, assigned values, arguments.
use grafcet::{Phase, grafcet};

grafcet! {
    sfc Initial {
        #![allow(grafcet::undriven_output)]
        output relay: bool = 1;
        initial step Off;
    }
}

grafcet! {
    sfc Stored {
        #![allow(grafcet::unused_variable)]
        var count: u16 = "none";
        initial step Off { P1 count = 0; }
    }
}

grafcet! {
    sfc Recipe {
        #![allow(grafcet::unused_param)]
        param limit: u16 = true;
        initial step Off;
    }
}

grafcet! {
    sfc Assigned {
        input on: bool;
        output level: u16;
        initial step Off { level = on; }
    }
}

grafcet! {
    sfc Written {
        output lamp: bool;
        initial step Off { P1 lamp = 5; }
    }
}

grafcet! {
    sfc Switched {
        output lamp: bool;
        initial step Off { N lamp if 1; }
    }
}

grafcet! {
    sfc Called {
        input on: bool;
        action heat(setpoint: i16);
        initial step Off { N heat(on); }
    }
}

struct Plant;

impl CalledActions for Plant {
    fn heat(&mut self, _: Phase, _: i16) {}
}

fn main() {
    Assigned::new().cycle(&AssignedInputs { on: 1 });
    Called::new().cycle(&CalledInputs { on: true }, &mut Plant);
}
