//! What a program asks of a chart beside its cycle: the variables, names as text, inputs in constants, and whether exactly
//! these steps are active.
#![deny(warnings)]

use grafcet::{Chart, Ticks, grafcet};

/// Seen by nobody outside.
mod press {
    use grafcet::grafcet;

    #[derive(Clone, Copy, PartialEq, Eq, Debug)]
    enum Mode {
        Cold,
        Warm,
    }

    grafcet! {
        /// Stores variables, one of them of a type that is not seen outside.
        pub(super) grafcet Press {
            #![allow(grafcet::unused_variable)]
            input go, back: bool;
            input level: u16;
            input heat: f32;
            input wait: time;
            output lower: bool;
            /// How often it has come down.
            var strokes: u16 = 3;
            var pause: time = 2s;
            var ratio: f32 = 0.5;
            var mode: Mode = Mode::Cold;
            var above: bool;

            initial step r#in { above; }
            step Hold { lower if level > 3 && heat > 1.0; P1 strokes = strokes + 1; P1 mode = Mode::Warm; P1 pause = wait; }

            r#in -[go]-> Hold -[back_home: back && !above]-> r#in;
        }
    }

    pub(super) fn warm(press: &Press) -> bool {
        press.vars().mode == Mode::Warm
    }
}

use press::{Press, PressInputs, PressStep, PressTransition};

static INPUTS: PressInputs = PressInputs { go: true, ..PressInputs::DEFAULT };

#[test]
fn variables_are_read_from_outside() {
    let mut press = Press::new();
    let vars = press.vars();
    assert_eq!((vars.strokes, vars.pause, vars.ratio), (3, Ticks::new(2000), 0.5));
    press.cycle(&PressInputs::DEFAULT);
    press.cycle(&PressInputs { wait: Ticks::new(7), ..INPUTS });
    assert_eq!((press.vars().strokes, press.vars().pause), (4, Ticks::new(7)));
    assert!(press::warm(&press));
    press.init();
    assert_eq!(press.vars().strokes, 3);
}

#[test]
fn names_are_text() {
    const HOLD: &str = PressStep::Hold.name();
    assert_eq!((HOLD, PressStep::r#in.name()), ("Hold", "in"));
    assert_eq!(format!("{}|{:>6}|", PressStep::r#in, PressStep::Hold), "in|  Hold|");
    assert_eq!(format!("{} {}", PressTransition::InToHold, PressTransition::BackHome), "InToHold BackHome");
    assert_eq!(PressTransition::BackHome.name(), "BackHome");
}

/// In generic code, too: one step where only one can be active, else all that are, in the order of declaration.
fn shown<C: Chart>(chart: &C) -> String {
    format!("{}", chart.situation())
}

#[test]
fn situations_are_text() {
    let mut alone = alone::Drill::new();
    let (mut branch, mut flags) = (branch::Drill::new(), branch_flags::Drill::new());
    assert_eq!([shown(&alone), shown(&branch), shown(&flags)], ["Rest"; 3]);
    for go in [false, true] {
        alone.cycle(&alone::DrillInputs { go, back: false });
        branch.cycle(&branch::DrillInputs { go, back: false });
        flags.cycle(&branch_flags::DrillInputs { go, back: false });
    }
    assert_eq!(shown(&alone), "Work");
    assert_eq!([shown(&branch), shown(&flags)], ["Work, Beside"; 2]);
    let situation = branch.situation();
    assert_eq!(
        format!("{situation:<14}|{situation:^15}|{situation:>14}"),
        "Work, Beside  | Work, Beside  |  Work, Beside"
    );
    assert_eq!(format!("{situation:3}{situation:.>13}"), "Work, Beside.Work, Beside");
    assert_eq!(format!("{situation:?}"), "{Work, Beside}");
}

#[test]
fn default_inputs_are_constants() {
    assert_eq!(PressInputs::DEFAULT, PressInputs::default());
    assert!(INPUTS.go && !INPUTS.back);
}

/// The same sequence alone, beside a branch, and each with a bit for every step.
macro_rules! machines {
    ($($module:ident: $dialect:ident { $($more:tt)* })*) => {
        $(mod $module {
            #![allow(dead_code, reason = "a macro of this crate is no foreign one")]
            grafcet::grafcet! {
                pub(super) $dialect Drill {
                    input go, back: bool;
                    output down: bool;
                    initial step Rest;
                    step Work { N down; }
                    $($more)*
                }
            }
        })*
    };
}

machines! {
    alone: sfc { Rest -[go]-> Work -[back]-> Rest; }
    flags: sfc { encoding flags; Rest -[go]-> Work -[back]-> Rest; }
    branch: sfc { step Beside; Rest -[go]-> (Work, Beside); (Work, Beside) -[back]-> Rest; }
    branch_flags: grafcet { encoding flags; step Beside; Rest -[go]-> (Work, Beside); (Work, Beside) -[back && !go]-> Rest; }
}

#[test]
fn a_comparison_does_not_care_how_many_steps_are_active() {
    macro_rules! check {
        ($($module:ident: $beside:expr;)*) => { $({
            use $module::{Drill, DrillInputs, DrillStep as Step};
            let mut drill = Drill::new();
            assert!(drill.is_exactly(&[Step::Rest]), "before the first cycle");
            drill.cycle(&DrillInputs::DEFAULT);
            assert!(drill.is_exactly(&[Step::Rest]) && !drill.is_exactly(&[]) && !drill.is_exactly(&[Step::Work]));
            drill.cycle(&DrillInputs { go: true, back: false });
            let beside: &[Step] = $beside;
            let steps: Vec<Step> = beside.iter().copied().chain([Step::Work]).collect();
            assert!(drill.is_exactly(&steps), "in any order");
            assert!(Chart::is_exactly(&drill, &steps), "in generic code");
            assert_eq!(drill.is_exactly(&[Step::Work]), beside.is_empty());
            assert!(!drill.is_exactly(&[Step::Work, Step::Rest]));
        })* };
    }
    check! {
        alone: &[];
        flags: &[];
        branch: &[Step::Beside];
        branch_flags: &[Step::Beside];
    }
}

/// The names of active steps, in code for any chart.
fn names<C: Chart>(chart: &C) -> String {
    let active = C::STEPS.iter().filter(|step| chart.is_active(**step));
    active.map(ToString::to_string).collect::<Vec<_>>().join(" ")
}

#[test]
fn generic_code_shows_names() {
    assert_eq!(names(&Press::new()), "in");
}

// Nobody asks this chart for anything beside its cycle, and no lint says so.
grafcet! {
    sfc Quiet {
        input on: bool;
        output run: bool;
        var count: u8;
        initial step Off;
        step On { N run if count > 1; P1 count = count + 1; }
        Off -[on]-> On -[!on]-> Off;
    }
}

#[test]
fn what_is_not_used_is_no_warning() {
    assert!(!Quiet::new().cycle(&QuietInputs { on: false }).run);
}

mod described {
    grafcet::grafcet! {
        pub(super) sfc Feed {
            input auto, next, stop: bool;
            output belt: bool;
            /// Somebody wants
            /// the next part.
            let go = auto || rising(next);
            let idle = !go;

            initial step Wait;
            step Run { N belt; }
            step r#loop { N belt; }
            step Stopped;
            Wait -[go]-> Run -[idle]-> r#loop -[go]-> Wait;
            any except (Wait, r#loop) -[halt: stop]-> Stopped -[!stop]-> Wait;
        }
    }
}

/// What stands for others is data of its own: no text has to be taken apart.
#[test]
fn names_and_any_are_described() {
    use grafcet::description::{Any, Let};
    let chart = described::Feed::CHART;
    let go = Let::new("go", "auto || rising(next)").documented("Somebody wants the next part.");
    assert_eq!(chart.lets, [go, Let::new("idle", "!go")]);
    let halt = chart.transitions.iter().find(|transition| transition.name == "halt").expect("the transition");
    assert_eq!((halt.condition, halt.sources, halt.targets), ("stop", &[][..], &[3][..]));
    assert_eq!(halt.any, Some(Any { steps: &[1], except: &["Wait", "loop"] }));
    assert_eq!(chart.transitions.iter().filter(|transition| transition.any.is_some()).count(), 1);
}
