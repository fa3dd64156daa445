use grafcet::grafcet;

grafcet! {
    /// One button opens, stops and closes; the light barrier and the current limit reverse the gate.
    pub sfc GarageGate {
        input button, barrier, opened, closed, current: bool;
        output raise, lower, lamp: bool;

        initial step Closed;
        step Opening { N raise; SL 3m lamp; }
        step Open { R lamp; }
        step Closing { N lower; N lamp; }
        step StoppedUp;
        step StoppedDown;
        step Reverse { N lamp; }

        Closed -[rising(button)]-> Opening -[opened]-> Open;
        Opening -[rising(button) || current]-> StoppedUp;
        Open -[rising(button) && !barrier || 5m/Open && !barrier]-> Closing;
        Closing -[barrier || current]-> Reverse -[500ms/Reverse]-> Opening;
        Closing -[rising(button)]-> StoppedDown;
        Closing -[closed]-> Closed;
        StoppedUp -[rising(button)]-> Closing;
        StoppedDown -[rising(button)]-> Opening;
    }
}
