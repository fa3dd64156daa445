use grafcet::grafcet;

grafcet! {
    /// The smallest useful charts: one button, and a staircase light that goes out by itself.
    pub grafcet LightSwitch {
        input button: bool;
        output lamp: bool;
        initial step Dark;
        step Bright { lamp; }
        Dark -[rising(button)]-> Bright -[rising(button)]-> Dark;
    }
}

grafcet! {
    pub sfc StaircaseLight {
        input button: bool;
        output lamp: bool;
        initial step Dark;
        step Bright { N lamp; }
        Dark -[button]-> Bright -[rising(button)]-> Longer -[2m/Longer]-> Dark;
        Bright -[2m/Bright]-> Dark;
        step Longer { N lamp; }
    }
}

grafcet! {
    /// One step alone has its use: it counts.
    pub grafcet Counter {
        input pulse, clear: bool;
        output many: bool;
        var count: u16 = 0;
        initial step Always {
            many if count > 100;
            on rising(pulse) && !rising(clear) count = (count + 1) % 1000;
            on rising(clear) count = 0;
        }
    }
}
