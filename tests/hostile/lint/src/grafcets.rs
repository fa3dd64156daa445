//! Charts of IEC 60848.

use grafcet::{Phase, grafcet};

use crate::sfcs::Point;

grafcet! {
    /// The 24 V production line.
    pub grafcet Line24V {
        forceable;
        input b1, b2, b3, b4, b5: bool;
        output q1, q2, q3: bool;

        assume never b1 && b3;
        assume never (b2 && b4) || (!b1 && b2 && b5);
        assume never !(b1 || b2 || !b3);

        initial step S1 { q1; }
        step S2 { S q2; }
        step S3 { q3 if b5; }
        step S4 { R q2; }

        S1 -[b1]-> S2 -[b2]-> S3 -[b3]-> S4 -[b4]-> S1;
    }
}

grafcet! {
    /// A cell: forcing, an enclosing step, a macro-step, an action on clearing.
    pub grafcet Cell {
        forceable;
        input estop, start, part, full, clamped, auto: bool;
        output belt, clamp, lamp, bell: bool;
        var n: u16 = 0;

        partial Safety {
            initial step Ready;
            step Stopped { force Production {}; lamp; }
            Ready -[estop]-> Stopped -[!estop]-> Restart -[true]-> Ready;
            step Restart { force Production {INIT}; }
        }

        partial Production {
            initial step Idle;
            step Feed { belt; }
            macro step Clamp {
                entry step Close { S clamp; }
                exit step Open { R clamp; }
                Close -[clamped]-> Open;
            }
            enclosing step Auto {
                bell if Clamp.X;
                partial Counting {
                    linked step Count { on rising(part) n = n + 1; }
                }
            }
            Idle -[start]-> Feed -[full]-> Clamp -[!clamped]-> Idle;
            Idle -[auto && !start]-> Auto -[n >= 2 && !part => n = 0]-> Idle;
        }
    }
}

grafcet! {
    /// Times, a code action in every way, a block, a delay, an unstable search.
    pub grafcet Oven {
        forceable;
        input door, start: bool;
        output lamp, fan: bool;
        output burner: bool;
        output power: u8;
        #[allow(grafcet::unused_variable)]
        var runs: u16 = 0;
        var hot: bool;
        param bake: time = 10s;
        action beep(times: u8);
        clock 10ms;
        max_evolutions 8;

        initial step Off { P1 beep(1); lamp if door; }
        step Bake { S burner; hot; N beep(2); power = 80; L 2s fan; P0 { runs += 1; } }
        step Cool { R burner; D 1s fan; on falling(door) beep(3); N beep(5); }

        Off -[begin: rising(start) && !door => beep(4)]-> Bake -[bake/Bake || 1s/door/200ms]-> Cool;
        Cool -[Cool.T >= 3s && !hot]-> Off;
    }
}

grafcet! {
    /// Parallel branches, source and sink, forcing to a situation, macro-step times.
    pub grafcet Belts {
        input part, out, hold, a, b: bool;
        output item, left: bool;
        output count: u8;

        partial Master {
            initial step Free;
            step Held { force Belt {*}; force Ends {Wait}; }
            Free -[hold]-> Held -[!hold]-> Free;
        }
        partial Belt {
            step Item { item; }
            () -[rising(part)]-> Item -[out]-> ();
        }
        partial Ends {
            initial step Wait;
            macro step Both { entry step Go; step Left { left; } step Right; exit step Met; Go -[a]-> (Left, Right) -[b]-> Met; }
            Wait -[a && !b]-> Both -[Both.T >= 1s]-> Wait;
            step Never { P1 count = count.wrapping_add(1); }
            Wait -[a && b]-> Never -[!b]-> Wait;
        }
    }
}

grafcet! {
    /// A bit for each step: a step that is taken and given back at once, an enclosure, edges, times, an unstable search.
    pub grafcet Flags {
        encoding flags;
        forceable;
        input a, b, hold: bool;
        output on, off: bool;
        output count: u8;
        max_evolutions 3;

        partial Master {
            initial step Free;
            enclosing step Held { on; partial Inner { linked step First { on rising(a) count = count.wrapping_add(1); } } }
            Free -[hold]-> Held -[2s/Held && !hold]-> Free;
        }
        #[allow(grafcet::unsafe_step, grafcet::overlapping_branches)]
        partial Branches {
            initial step Left;
            step Right { off; }
            step Both { off if Both.T < 1s; }
            Left -[a]-> Both -[b]-> Left;
            Both -[rising(a)]-> Both;
            () -[rising(b) && hold]-> Right -[!b && First.X]-> ();
        }
    }
}

grafcet! {
    /// A search has one evolution; times that begin where a step is entered.
    pub grafcet Crossing {
        input request: bool;
        output red, green, wait: bool;

        initial step Green { green; }
        step Asked { green; S wait; }
        step Red { red; R wait; L 2s green; }

        Green -[request && 10s/Green]-> Asked -[5s/Asked]-> Red -[8s/Red]-> Green;
    }
}

grafcet! {
    /// Parallel branches whose search may have no end: the last evolution is taken back.
    pub grafcet Fork {
        input start, a, b, out: bool;
        output left, right: bool;

        initial step Idle;
        step Left { left; }
        step Gone;
        step Right { right; }
        step Waits;

        Idle -[start]-> (Left, Right);
        Left -[a]-> Gone;
        Right -[b || 2s/Right]-> Waits;
        (Gone, Waits) -[out]-> Idle;
    }
}

grafcet! {
    /// Partial grafcets that wait for each other's steps.
    pub grafcet Feeder {
        input part, front, back, shut: bool;
        output push, pull: bool;
        output strokes: u8;

        partial Ram {
            initial step Open;
            step Shut { P1 strokes = strokes.wrapping_add(1); }
            Open -[Slide::Placed.X && shut]-> Shut -[Slide::Rest.X]-> Open;
        }
        partial Slide {
            initial step Rest;
            step Forward { push; }
            step Placed;
            step Backward { pull; }
            Rest -[part && Ram::Open.X]-> Forward -[front]-> Placed -[Ram::Shut.X]-> Backward -[back && !front]-> Rest;
        }
    }
}

/// Carries out no action.
#[derive(Clone, Copy, Debug)]
pub struct Silent;

impl OvenActions for Silent {
    fn beep(&mut self, _: Phase, _: u8) {}
}

#[test]
fn runs() {
    let mut line = Line24V::new();
    assert!(line.cycle(&Line24VInputs::default()).q1);
    assert_eq!(Oven::new().cycle(&OvenInputs::default(), 0, &mut Silent).power, 0);
}

/// What a selector says.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Mode {
    /// Nothing moves.
    #[default]
    Off,
    /// By itself.
    Auto,
    /// By hand, so fast.
    Manual(u8),
}

/// It has one.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Single {
    /// This.
    #[default]
    One,
}

grafcet! {
    /// A press with a selector whose variants are listed.
    pub grafcet Selected {
        input mode, other: Mode in {Off, Auto, Manual(..)};
        input single: Single in {One};
        output ram, lamp: bool;
        initial step Rest;
        step Run { ram; }
        step Jog { lamp if mode != Mode::Off; }
        Rest -[mode == Mode::Auto && single == Single::One]-> Run -[mode != Mode::Auto]-> Rest;
        Rest -[matches!(mode, Mode::Manual(_)) && other == mode]-> Jog -[!matches!(mode, Mode::Manual(..))]-> Rest;
        never ram && lamp;
        never ram && mode == Mode::Off;
    }
}

grafcet! {
    /// Structs whose fields have the names of values, wherever Rust may stand.
    pub grafcet Fields {
        input x, y: u8;
        output q: bool;
        output at: Point = Point { x: 0, y: 0 };
        var other: Point = Point { x: 0, y: 0 };
        initial step A { q if Point { x, y }.is_far(); at = Point { x, y }; }
        step B { P1 other = Point { x, y: 1 }; P0 { let y = 3; other = Point { x, y }; } }
        A -[Point { x, y }.is_far() && other == Point { x: 1, y }]-> B -[x < 3 || x > 200]-> A;
    }
}

grafcet! {
    /// An action of many arguments, and one that Clippy would take for an iterator's.
    pub grafcet Called {
        input go: bool;
        action set(red: u8, green: u8, blue: u8, white: u8, from: u8, to: u8);
        action iter();
        initial step Rest;
        step Run { set(1, 2, 3, 4, 5, 6); iter(); }
        Rest -[go]-> Run -[!go]-> Rest;
    }
}
