use grafcet::grafcet;

grafcet! {
    /// Requests are stored in variables, served in turn and cleared; a combinational variable says that there are any.
    pub grafcet LatchedRequests {
        input call_a, call_b, at_a, at_b: bool;
        output to_a, to_b, waiting: bool;
        var want_a, want_b, moving: bool;

        partial Listen {
            initial step Ears {
                on rising(call_a) && !rising(AtA.X) want_a = true;
                on rising(AtA.X) want_a = false;
                on rising(call_b) && !rising(AtB.X) want_b = true;
                on rising(AtB.X) want_b = false;
                waiting if (want_a || want_b) && !moving;
            }
        }
        partial Drive {
            initial step Rest;
            step GoA { to_a; moving; }
            step AtA;
            step GoB { to_b; moving; }
            step AtB;
            Rest -[want_a]-> GoA -[at_a]-> AtA -[2s/AtA]-> Rest;
            Rest -[want_b && !want_a]-> GoB -[at_b]-> AtB -[2s/AtB]-> Rest;
        }
    }
}
