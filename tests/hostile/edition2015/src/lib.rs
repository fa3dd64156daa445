//! Charts in a crate of the first edition of Rust, where paths begin elsewhere.
#![forbid(unsafe_code)]
#![deny(warnings, missing_docs)]

extern crate grafcet;

/// In a module, from where paths lead elsewhere, too.
pub mod charts {
    use grafcet::grafcet;

    grafcet! {
        /// A sequence with times, edges and Rust.
        pub sfc Sequence {
            input on, off: bool;
            output motor: bool;
            output level: u8 = 0;
            param soak: time = 5s;
            initial step A;
            step B { L 2s motor; P1 level = ::std::cmp::min(level, 3) + 1; }
            A -[on && !off]-> B -[rising(off) || soak/B]-> A;
            never motor && A.X;
        }
    }

    grafcet! {
        /// Partial grafcets.
        pub grafcet Forced {
            input on, off: bool;
            output motor: bool;
            partial Main {
                initial step Ready;
                step Stop { force Rest {}; }
                Ready -[off && !on]-> Stop -[on]-> Ready;
            }
            partial Rest { initial step Wait; step Turn { motor if on; } Wait -[rising(on)]-> Turn -[5s/Turn]-> Wait; }
        }
    }

    #[cfg(feature = "mistakes")]
    grafcet! {
        sfc Mistaken {
            input on: bool;
            initial step A;
            A -[onn]-> B;
        }
    }
}

#[test]
fn runs() {
    use charts::{Sequence, SequenceInputs};
    let mut chart = Sequence::new();
    assert!(!chart.cycle(&SequenceInputs::default(), 0).motor);
    assert!(chart.cycle(&SequenceInputs { on: true, ..Default::default() }, 0).motor);
}
