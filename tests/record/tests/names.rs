//! What a recorder needs of a chart is written down beside items of the program that are called like its own, and without the prelude.

use grafcet::record::{Recorder, Records, replay};

mod hostile {
    #![no_implicit_prelude]
    #![allow(dead_code, non_camel_case_types, non_upper_case_globals)]

    extern crate std;

    struct bool;
    struct u32;
    struct usize;
    struct Option;
    mod core {}

    /// Names that the macros of the recorder might bind.
    macro_rules! statics {
        ($($name:ident)*) => { $(static $name: () = ();)* };
    }

    statics! { to from value one other params new before variant index state number inputs now word at }
    statics! { _to _from _other _word _at _params _state _now }

    /// Recorded by the list of its variants.
    #[derive(
        ::std::clone::Clone, ::std::marker::Copy, ::std::cmp::PartialEq, ::std::default::Default, ::std::fmt::Debug,
    )]
    pub(super) enum Mode {
        #[default]
        Off,
        On,
    }

    ::grafcet::recordable! { Mode { Off, On } }

    ::grafcet::grafcet! {
        pub(super) sfc Oven {
            input on: bool;
            input mode, earlier: Mode;
            input listed: Mode in {Off, On};
            output heat: bool;
            var kept: Mode = Mode::Off;
            var count: u32;
            param limit: u8 in 1..=9 = 3;
            initial step Cold;
            step Hot { L 2s heat; P1 kept = mode; P1 count = count + 1; }
            Cold -[on && count < 5 && limit > 2 && listed == Mode::On]-> Hot -[5s/Hot && kept == earlier]-> Cold;
        }
    }
}

#[test]
fn a_record_beside_items_of_its_names() {
    use hostile::{Mode, Oven, OvenInputs};
    let mut recorder = Recorder::new(Oven::new(), vec![0; 1024]).expect("enough memory");
    let on = OvenInputs { on: true, mode: Mode::On, listed: Mode::On, ..OvenInputs::default() };
    assert!(!recorder.cycle(&OvenInputs::default(), 1, &mut ()).heat);
    assert!(recorder.cycle(&on, 2, &mut ()).heat);
    recorder.flush();
    let records = Records::of(recorder.record()).expect("a record");
    let mut last = None;
    let replayed = replay::<Oven>(&records, &mut (), |moment| last = Some(moment.outputs.heat));
    assert_eq!((replayed, last), (Ok(()), Some(true)));
}
