//! Charts of IEC 61131-3.

use grafcet::{Phase, grafcet};

grafcet! {
    /// A motor that can be switched on and off, guarded against over-temperature.
    pub sfc Motor {
        input on, off, over_temp: bool;
        output relay, green, red: bool;

        initial step Off { N red; }
        step On { N relay; N green; }

        Off -[on && !over_temp]-> On -[off || over_temp]-> Off;
    }
}

grafcet! {
    /// A batch: parallel branches, times, edges, a recipe, a code action.
    pub sfc Batch {
        forceable;
        input start, full, empty: bool;
        input level: u16;
        output valve, pump, lamp: bool;
        output speed: u16 = 0;
        var count: u16 = 0;
        param soak: time = 5s;
        param hot: i16 = 80;
        action heat(setpoint: i16);

        initial step Idle { lamp; }
        step Fill { N valve; P1 count = count + 1; }
        step Heat { N heat(hot); L 3s lamp; D 1s pump; speed = 10; }
        step Stir { N heat(40); SD 2s pump; P0 { if count > 3 { count = 0; } } }
        step Drain { R pump; N pump if level > 3; }

        Idle -[rising(start)]-> (Fill, Heat);
        (Fill, Heat) -[full && soak/Heat]-> Stir -[Stir.T >= 2s && 1s/empty/500ms]-> Drain -[level == 0]-> Idle;
    }
}

grafcet! {
    /// All eleven qualifiers, for outputs, variables, code actions, assignments and blocks.
    pub sfc Qualifiers {
        forceable;
        input go, stop, again: bool;
        input level: u16;
        output n, s, l, d, p, sd, ds, sl: bool;
        output kept: bool = true;
        output speed: u16 = 3;
        var flag: bool;
        var count: u16;
        var limit: time = 2s;
        param pause: time = 3s;
        action beep();
        action drum(speed: u16, limit: u16);
        clock 1ms;

        initial step Off {
            R s; R sd; R ds; R sl; R kept; R drum(0, 0);
            P0 beep();
        }
        step First {
            N n; S s; L 1s l; D pause d; P p; SD 1s sd; DS 1s ds; SL limit sl; S kept; S flag;
            P1 count = count + 1;
            P+ beep();
            N drum(45, level) if level > 2;
        }
        step Second {
            L 2s l; D 2s d; N s if stop; SD 2s sd; R flag;
            N drum(55, level);
            N count = count + 1;
            P- { count = 0; limit = 4s; }
            P { if count > 7 { count -= 1; } }
            speed = count if flag;
        }
        step Third { S drum(1, 2); SL 1s { count += 1; } SD 1s drum(3, 4); N beep(); }

        Off -[rising(go)]-> First -[again]-> First -[falling(go) && !again]-> Second -[s && speed > 1]-> Third;
        Second -[stop]-> Third;
        Third -[Third.T >= limit || n]-> Off;
    }
}

grafcet! {
    /// Nested parallel branches, and branches that compete.
    pub sfc Parallel {
        input a, b, c: bool;
        output x, y: bool;
        initial step Start;
        step Left; step Right { x; }
        step Inner { y; }
        step Outer; step Done;
        Start -[a]-> (Left, Right);
        Left -[b]-> (Inner, Outer);
        (Inner, Outer, Right) -[both: c]-> Done -[a]-> Start;
    }
}

grafcet! {
    /// A bit for each step: one at a time, entered anew, with times and a variable.
    pub sfc Flags {
        encoding flags;
        forceable;
        input go, stop: bool;
        output x, y: bool;
        var n: u8 = 0;
        initial step Off { x if n > 3; }
        step On { L 1s y; P1 n = n.wrapping_add(1); P0 { n |= 1; } }
        Off -[rising(go)]-> On -[go && 1s/On]-> On -[stop]-> Off;
    }
}

/// A place.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Point {
    /// To the right.
    pub x: u8,
    /// Up.
    pub y: u8,
}

impl Point {
    /// Whether it is one.
    #[must_use]
    pub const fn is_far(self) -> bool {
        self.x > 100
    }
}

/// Something that holds or not.
#[derive(Clone, Copy, Debug)]
pub struct Flag {
    /// It holds.
    pub z: bool,
}

grafcet! {
    /// Structs whose fields have the names of values, wherever Rust may stand.
    pub sfc Fields {
        input x, y: u8;
        output q: bool;
        output at: Point = Point { x: 0, y: 0 };
        var other: Point = Point { x: 0, y: 0 };
        let z = x > 3 && y > 3;
        action go(at: Point);
        initial step A { q if Point { x, y }.is_far(); at = Point { x, y }; }
        step B { P1 other = Point { x, y: 1 }; N go(Point { x, y }); P0 { let y = 3; other = Point { x, y }; } }
        A -[Point { x, y }.is_far() && other == Point { x: 1, y }]-> B -[Flag { z }.z || x > 200]-> A;
    }
}

grafcet! {
    /// `let` where Rust binds names.
    pub sfc Bound {
        input a: bool;
        input n: Option<u8>;
        output q: bool;
        output count: u8 = 0;
        initial step A {
            q if match n { Some(x) if x > 3 => { let y = x; y > 4 }, _ => false };
            P1 {
                if let Some(x) = n && x > 3 { count = x; } else if let None = n && a { count = 0; }
                let mut left = n;
                while let Some(x) = left { left = x.checked_sub(1); }
                if let Some(x) = left { count = x; }
            }
        }
        step B;
        A -[if let Some(x) = n && x > 3 { a } else { !a }]-> B -[{ let x = n; matches!(x, Some(y) if y > 3) }]-> A;
    }
}

/// Carries out no action.
#[derive(Clone, Copy, Debug)]
pub struct Silent;

impl BatchActions for Silent {
    fn heat(&mut self, _: Phase, _: i16) {}
}

impl FieldsActions for Silent {
    fn go(&mut self, _: Phase, _: Point) {}
}

impl QualifiersActions for Silent {
    fn beep(&mut self, _: Phase) {}
    fn drum(&mut self, _: Phase, _: u16, _: u16) {}
}

#[test]
fn runs() {
    let mut motor = Motor::new();
    assert!(motor.cycle(&MotorInputs::default()).red);
    let far = FieldsInputs { x: 101, y: 3 };
    assert_eq!(Fields::new().cycle(&far, &mut Silent).at, Point { x: 101, y: 3 });
    assert!(!Qualifiers::new().cycle(&QualifiersInputs::default(), 0, &mut Silent).n);
}
