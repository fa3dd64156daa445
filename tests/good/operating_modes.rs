use grafcet::grafcet;

grafcet! {
    /// An emergency stop that works in every mode, above a press that is run by its operating modes.
    pub grafcet ModalPress {
        input estop, acknowledge, start, down, up: bool;
        output lower, lift, lamp: bool;

        partial Safety {
            initial step Ready;
            step Stopped { force Press {}; lamp; }
            step Restart { force Press {INIT}; }
            Ready -[estop]-> Stopped -[!estop && acknowledge]-> Restart -[true]-> Ready;
        }

        partial Press {
            modes;
            initial step Rest { lamp if paused; }
            step Lower { lower if !paused; }
            step Lift { lift if !paused; }
            Rest -[start && up]-> Lower -[down]-> Lift -[up]-> Rest;
            Lower -[5s/Lower && !down]-> Lift;
        }

        never lower && lift;
        never Stopped.X && lower;
    }
}
