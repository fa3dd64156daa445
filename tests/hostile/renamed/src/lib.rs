//! Charts where grafcet goes by another name.
#![deny(warnings)]

use plc::grafcet as chart;

chart! {
    /// Through an import under yet another name.
    pub sfc Blink {
        input tick: bool;
        output lamp: bool;
        initial step Dark;
        step Lit { N lamp; }
        Dark -[tick]-> Lit -[tick]-> Dark;
    }
}

plc::grafcet! {
    /// Through the path.
    pub grafcet Timed {
        input tick: bool;
        output lamp: bool;
        action beep(times: u8);
        initial step Dark;
        step Lit { lamp; P1 beep(2); }
        Dark -[tick]-> Lit -[2s/Lit]-> Dark;
    }
}

#[test]
fn runs() {
    struct Silent;
    impl TimedActions for Silent {
        fn beep(&mut self, _: plc::Phase, _: u8) {}
    }
    let mut blink = Blink::new();
    blink.cycle(&BlinkInputs { tick: true });
    assert!(blink.cycle(&BlinkInputs { tick: true }).lamp);
    assert!(Timed::new().cycle(&TimedInputs { tick: true }, 0, &mut Silent).lamp);
}
