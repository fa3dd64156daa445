use grafcet::grafcet;

grafcet! {
    /// Continuous, limited, delayed and stored actions, actions on activation, deactivation, event and clearing.
    pub grafcet QualifiersGrafcet {
        input go, pulse, done, reset: bool;
        output lamp, horn, valve, motor, many: bool;
        output speed: u16 = 0;
        var count, rounds: u16 = 0;
        action report(rounds: u16);

        initial step Idle { R motor; }
        step Count { lamp; L 1s horn; D 2s valve if pulse; on rising(pulse) count = count + 1; speed = 20 + count; }
        step Run { S motor; speed = 500; P0 report(rounds); }
        step Many { many if rounds > 9; }

        Idle -[rising(go)]-> Count -[count >= 5 => rounds = rounds + 1]-> Run -[done]-> Many;
        Many -[rising(reset) => count = 0]-> Idle;
    }
}
