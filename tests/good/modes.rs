use grafcet::grafcet;

grafcet! {
    /// Automatic and manual operation are enclosures of the step of the mode.
    pub grafcet Modes {
        input auto, up_button, down_button, part, top, bottom: bool;
        output up, down: bool;

        initial step Off;
        enclosing step Automatic {
            partial Cycle {
                linked step Ready;
                step Raise { up; }
                step Lower { down; }
                Ready -[part && bottom]-> Raise -[top]-> Lower -[bottom && !top]-> Ready;
            }
        }
        enclosing step Manual {
            partial Jog {
                linked step Still;
                step JogUp { up if !top; }
                step JogDown { down if !bottom; }
                Still -[up_button && !down_button]-> JogUp -[!up_button]-> Still;
                Still -[down_button && !up_button]-> JogDown -[!down_button]-> Still;
            }
        }

        Off -[auto]-> Automatic -[!auto]-> Manual;
        Off -[!auto && (up_button || down_button)]-> Manual;
        Manual -[auto]-> Automatic;
    }
}
