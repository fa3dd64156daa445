//! Charts in functions and modules, of every visibility, and the smallest ones.

use grafcet::grafcet;

grafcet! {
    sfc Private {
        input on: bool;
        output lamp: bool;
        initial step Off;
        step On { lamp; }
        Off -[on]-> On -[!on]-> Off;
    }
}

grafcet! {
    /// For this crate.
    pub(crate) grafcet Crate {
        input on: bool;
        output lamp: bool;
        param wait: time = 1s;
        action beep();
        initial step Off;
        step On { lamp; P1 beep(); }
        Off -[on]-> On -[wait/On]-> Off;
    }
}

mod inner {
    grafcet::grafcet! {
        /// For the module around.
        pub(super) sfc Above {
            initial step Off;
            step On;
            Off -[true]-> On -[true]-> Off;
        }
    }
    grafcet::grafcet! {
        /// For one module.
        pub(in crate::places) grafcet Within {
            output lamp: bool;
            initial step Only { lamp; }
        }
    }
}

grafcet! {
    /// One step and nothing else.
    pub sfc Single {
        initial step Only;
    }
}

grafcet! {
    /// One step and nothing else.
    pub grafcet Alone {
        initial step Only;
    }
}

grafcet! {
    /// One step with an action.
    pub sfc Counting {
        output count: u8;
        var n: u8;
        initial step Only { N n = n.wrapping_add(1); count = n; }
    }
}

grafcet! {
    /// No inputs, but time.
    pub grafcet Blinking {
        output lamp: bool;
        initial step Dark;
        step Lit { lamp; }
        Dark -[1s/Dark]-> Lit -[500ms/Lit]-> Dark;
    }
}

/// Charts in a function, one of them in a block, under one name.
#[must_use]
pub fn local(on: bool) -> bool {
    grafcet! {
        sfc Local {
            input on: bool;
            output lamp: bool;
            initial step Off;
            step On { lamp; }
            Off -[on]-> On -[!on]-> Off;
        }
    }
    let nested = {
        grafcet! {
            grafcet Local {
                input on: bool;
                output lamp: bool;
                initial step Off;
                step On { lamp; }
                Off -[on]-> On -[!on]-> Off;
            }
        }
        Local::new().cycle(&LocalInputs { on }).lamp
    };
    let mut chart = Local::new();
    chart.cycle(&LocalInputs { on });
    nested && chart.cycle(&LocalInputs { on }).lamp
}

/// The charts that are not public are used.
#[must_use]
pub fn all() -> bool {
    struct Silent;
    impl CrateActions for Silent {
        fn beep(&mut self, _: grafcet::Phase) {}
    }
    let private = Private::new().cycle(&PrivateInputs { on: true }).lamp;
    let within = inner::Within::new().cycle(&inner::WithinInputs {}).lamp;
    let _ = inner::Above::new().cycle(&inner::AboveInputs {});
    within && !private && Crate::new().cycle(&CrateInputs { on: true }, 0, &mut Silent).lamp
}

#[test]
fn runs() {
    assert!(local(true) && all());
    let (mut counting, mut blinking) = (Counting::new(), Blinking::new());
    assert_eq!(counting.cycle(&CountingInputs::default()).count, 1);
    assert_eq!(counting.cycle(&CountingInputs::default()).count, 2);
    assert!(!blinking.cycle(&BlinkingInputs::default(), 0).lamp);
    assert!(blinking.cycle(&BlinkingInputs::default(), 1000).lamp);
    Single::new().cycle(&SingleInputs::default());
    Alone::new().cycle(&AloneInputs::default());
    assert_eq!(Alone::new().situation(), AloneStep::Only);
}
