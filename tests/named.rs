//! `let go = …;`: named conditions.
#![deny(warnings)]

use grafcet::{Phase, grafcet};

const LIMIT: u8 = 3;

fn both(a: bool, b: bool) -> bool {
    a && b
}

grafcet! {
    /// Names of generated code and of Rust mean nothing here.
    sfc Press {
        input auto, next, before: bool;
        input n: u8;
        output motor, lamp: bool;
        output count: u16;
        let go = auto || rising(next);
        let after = go && n < LIMIT;
        let value = !after;
        let elapsed = both(go, before);
        let only = before;
        let total = u16::from(n) + count;
        action heat(on: bool, sum: u16);
        initial step Idle { N lamp if go; N heat(go, total); }
        step Up {
            N motor if after;
            P1 {
                let rest = if go { 1 } else { 2 };
                count = total + rest;
                assert!(go || !go, "{}", go);
            }
        }
        step Down { P1 { count = (0..3_u8).filter(|i| go && *i > 0).map(u16::from).sum(); } }
        Idle -[elapsed]-> Up;
        Idle -[only && matches!(n, 7 if go)]-> Down;
        Idle -[(go)]-> Up;
        Up -[value]-> Idle;
        Up -[1s/go/1s]-> Down;
        Down -[only]-> Idle;
        Down -[go.then_some(n).is_some_and(|n| n > 9)]-> Idle;
    }
}

struct Heat(Vec<(bool, u16)>);

impl PressActions for Heat {
    fn heat(&mut self, phase: Phase, on: bool, sum: u16) {
        if phase != Phase::Final {
            self.0.push((on, sum));
        }
    }
}

#[test]
fn a_name_is_what_it_stands_for() {
    let (mut press, mut heat) = (Press::new(), Heat(Vec::new()));
    let rest = PressInputs { n: 2, ..PressInputs::default() };
    press.cycle(&rest, 0, &mut heat);
    // Nothing yet: no edge, no step.
    let q = press.cycle(&rest, 1, &mut heat);
    assert!(press.is_active(PressStep::Idle) && !q.lamp);
    // The edge is one of the cycle: the transition, the block and the action all see it.
    let q = press.cycle(&PressInputs { next: true, ..rest }, 2, &mut heat);
    assert!(press.is_active(PressStep::Up) && q.motor);
    assert_eq!(q.count, 3);
    let q = press.cycle(&PressInputs { next: true, ..rest }, 3, &mut heat);
    assert!(press.is_active(PressStep::Idle) && !q.motor && !q.lamp);
    press.cycle(&PressInputs { auto: true, before: true, n: 7, ..rest }, 4, &mut heat);
    assert!(press.is_active(PressStep::Up));
    press.cycle(&rest, 5, &mut heat);
    press.cycle(&PressInputs { before: true, n: 7, ..rest }, 6, &mut heat);
    assert!(press.is_active(PressStep::Idle));
    press.cycle(&PressInputs { next: true, before: true, n: 7, ..rest }, 7, &mut heat);
    assert!(press.is_active(PressStep::Up));
    assert_eq!(heat.0.first(), Some(&(false, 2)));
}

macro_rules! guarded {
    ($name:ident, $guard:expr) => {
        grafcet! {
            grafcet $name {
                input on, off: bool;
                output q: bool;
                let may = $guard && on;
                initial step Off;
                step On { q; }
                Off -[!off && may]-> On -[!may]-> Off;
            }
        }
    };
}

guarded!(Narrow, true);

#[test]
fn in_a_macro() {
    let mut narrow = Narrow::new();
    assert!(narrow.cycle(&NarrowInputs { on: true, off: false }).q);
    assert!(!narrow.cycle(&NarrowInputs { on: false, off: false }).q);
}
