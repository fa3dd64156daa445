use grafcet::grafcet;

grafcet! {
    /// A telegram is sent up to three times; then somebody has to look.
    pub sfc Retry {
        input request, answer, quit: bool;
        output send, fault: bool;
        var tries: u8 = 0;
        param patience: time = 800ms;

        initial step Idle { P1 tries = 0; }
        step Send { L 100ms send; P1 tries = tries + 1; }
        step Pause;
        step Good { P1 tries = 0; }
        step Fault { N fault; }

        Idle -[request]-> Send;
        Send -[answer]-> Good -[!request]-> Idle;
        Send -[patience/Send && tries < 3]-> Pause -[200ms/Pause]-> Send;
        Send -[patience/Send]-> Fault -[rising(quit)]-> Idle;
    }
}
