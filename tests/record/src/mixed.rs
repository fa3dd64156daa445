//! Charts with what the examples do not have beside each other.

use grafcet::grafcet;

grafcet! {
    /// Branches, delays, times, a variable.
    pub grafcet Press {
        input go, done: bool;
        input level: u8;
        output close, heat: bool;
        var n: u8 = 3;
        param limit: time = 3s;
        initial step Idle;
        step Close { close; } step Closed;
        step Heat { heat if 1s/go/2s; D 500ms close; P1 n = n % 50 + level % 3; } step Heated;
        Idle -[go]-> (Close, Heat);
        Close -[done || limit/Close]-> Closed;
        Heat -[5s/Heat && n > 2]-> Heated;
        (Closed, Heated) -[!go]-> Idle;
    }
}

grafcet! {
    /// The same with flags, and other times.
    pub sfc Flags {
        encoding flags;
        input go, done: bool;
        output close, heat: bool;
        initial step Idle;
        step Close { SD 2s close; } step Closed { R close; }
        step Heat { L 1s heat; } step Heated;
        Idle -[go]-> (Close, Heat);
        Close -[done]-> Closed;
        Heat -[3s/Heat]-> Heated;
        (Closed, Heated) -[!go]-> Idle;
    }
}
