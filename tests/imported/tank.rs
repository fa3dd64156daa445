// Imported from tank.st by cargo grafcet.
//
// Renamed in Tank:
//   TANK is Tank
//   START is start
//   xFull is x_full
//   Temperature is temperature
//   SoakTime is soak_time
//   Inlet is inlet
//   Heater is heater
//   Batches is batches
//   WAIT_START is WaitStart
//   FILL is Fill
//   HEAT is Heat
//
// To be looked at in Tank:
//   `fill_to_wait_start` is a function to be written in Rust: the function `SQRT` is not in this file

use grafcet::grafcet;

grafcet! {
    /// Fills a tank and heats it.
    pub sfc Tank {
        input start: bool;
        /// the float switch
        input x_full: bool;
        input temperature: i16;
        param soak_time: time = 1m30s;
        output inlet, heater: bool;
        var batches: u16;

        initial step WaitStart;
        step Fill { inlet; }
        step Heat { heater; P1 batches = batches + 1; }

        WaitStart -[rising(start)]-> Fill -[x_full]-> Heat;
        Fill -[fill_to_wait_start()]-> WaitStart;
        // long enough, and hot
        Heat -[soak_time/Heat && temperature > 80]-> WaitStart;
    }
}

/// To be written: the condition from FILL to WAIT_START, which was
///     SQRT(Temperature) > 12;
fn fill_to_wait_start() -> bool {
    todo!("the condition from FILL to WAIT_START")
}
