//! Charts through a crate that passes the macro on.
#![deny(warnings)]

use hostile_facade::{chart, grafcet, light};

chart! {
    /// Through the other name.
    pub sfc One {
        input tick: bool;
        output lamp: bool;
        initial step Dark;
        step Lit { N lamp; }
        Dark -[tick]-> Lit -[tick]-> Dark;
    }
}

grafcet! {
    /// Through the name of grafcet itself, with time, so that `Ticks` is found.
    pub grafcet Two {
        input tick: bool;
        output lamp: bool;
        initial step Dark;
        step Lit { lamp; }
        Dark -[tick]-> Lit -[2s/Lit]-> Dark;
    }
}

light!(pub Three: bright, dark);

#[test]
fn runs() {
    let mut three = Three::new();
    three.cycle(&ThreeInputs::default());
    assert!(three.cycle(&ThreeInputs { bright: true, dark: false }).lamp);
    let mut one = One::new();
    one.cycle(&OneInputs { tick: true });
    assert!(one.cycle(&OneInputs { tick: true }).lamp);
    assert!(Two::new().cycle(&TwoInputs { tick: true }, 0_u32).lamp);
}
