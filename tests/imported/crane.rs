// Imported from crane.xml by cargo grafcet.
//
// Renamed in Crane:
//   Start is start
//   CraneDown is crane_down
//   CraneUp is crane_up
//   Sucked is sucked
//   CraneLower is crane_lower
//   Vacuum is vacuum
//   Mode is mode
//   Lifts is lifts
//   SFCInit is sfc_init
//   Crane_Lower is CraneLower
//   Crane_Lift is CraneLift
//   E_Mode is EMode
//
// To be looked at in Crane:
//   `SuckTimer` is called in some steps alone: here its time begins with them
//   nothing that is translated writes `SFCInit`: it is an input
//   left out: the action `Forgotten`, which belongs to no step
//   left out: that the step `Suck` takes T#1S at least: say so in what leaves it

use grafcet::grafcet;

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum EMode {
    #[default]
    Off,
    Auto,
}

grafcet! {
    pub sfc Crane {
        input start, crane_down, crane_up, sucked, sfc_init: bool;
        output crane_lower, vacuum: bool;
        var mode: EMode in {Off, Auto} = EMode::Auto;
        var lifts: i16;

        initial step Init;
        /// down to the part
        step CraneLower within 5s {
            P1 lifts = lifts + 1;
            // the gripper is open
            N {
                crane_lower = true;
                vacuum = false;
            }
            P0 mode = EMode::Off;
        }
        step Suck {
            N { vacuum = true; }
        }
        step CraneLift {
            N {
                match lifts {
                    1..=2 => crane_lower = false,
                    _ => {
                        crane_lower = false;
                        lifts = 0;
                    }
                }
            }
        }

        Init -[start && mode == EMode::Auto]-> CraneLower -[crane_down]-> Suck
            -[500ms/Suck && 500ms/sucked]-> CraneLift -[crane_up]-> Init;
    }
}
