use grafcet::grafcet;

grafcet! {
    /// Two clamps close together, the drill waits for both, and both open before the part goes on.
    pub sfc DrillStation {
        input part, closed1, closed2, opened1, opened2, drill_up, drill_down: bool;
        output close1, close2, drill, feed, retract, eject: bool;

        initial step Wait;
        step Close1 { S close1; }
        step Held1;
        step Close2 { S close2; }
        step Held2;
        step Down { N drill; N feed; }
        step Dwell { N drill; }
        step Up { N drill; N retract; }
        step Open1 { R close1; }
        step Free1;
        step Open2 { R close2; }
        step Free2;
        step Eject { N eject; }

        Wait -[part && drill_up]-> (Close1, Close2);
        Close1 -[closed1]-> Held1;
        Close2 -[closed2]-> Held2;
        (Held1, Held2) -[true]-> Down -[drill_down]-> Dwell -[500ms/Dwell]-> Up -[drill_up]-> (Open1, Open2);
        Open1 -[opened1]-> Free1;
        Open2 -[opened2]-> Free2;
        (Free1, Free2) -[true]-> Eject -[!part]-> Wait;
    }
}
