//! Values of the program's own types, and step names that are no Rust ones.

use grafcet::{Phase, grafcet};

/// A mode, as the program knows it.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Mode {
    /// By hand.
    #[default]
    Manual,
    /// By itself.
    Automatic,
}

/// A type with a lifetime and a parameter.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Pair<A, B>(pub A, pub B);

const START: Mode = Mode::Automatic;

grafcet! {
    /// Every kind of value.
    pub sfc Values {
        input mode: Mode;
        input level: f32;
        input counts: [u16; 4];
        input big: u64;
        input small: i8;
        input pair: Pair<u8, (bool, char)>;
        input name: &'static str;
        input wide: i128;
        output shown: Mode;
        output chosen: Mode = START;
        output power: f32;
        output ratio: f64 = 0.5;
        output copied: [u16; 4];
        output total: u64;
        output mixed: Pair<u8, (bool, char)>;
        output text: &'static str = "none";
        var mean: f32;
        var sum: u64;
        var kept: Mode = Mode::Manual;
        var seen: [u16; 4] = [0; 4];
        param factor: f32 = 1.5;
        param offset: u64 = 1 << 40;
        param table: [u16; 4] = [1, 2, 3, 4];
        action report(mode: Mode, level: f32, text: &'static str);

        initial step Idle { shown = mode; text = name; }
        step Run {
            power = level * factor;
            ratio = f64::from(level);
            copied = counts;
            mixed = pair;
            total = sum;
            chosen = kept;
            P1 mean = level;
            N sum = sum.wrapping_add(big + offset);
            N kept = mode;
            P1 { seen = counts; seen[0] = seen[1].wrapping_add(table[2]); }
            N report(mode, level, name);
        }

        Idle -[mode == Mode::Automatic && level >= 0.5]-> Run;
        Run -[counts.iter().all(|count| *count > 3) || mean > 1.0e3 || kept == Mode::Manual && small < -3]-> Idle;
        Run -[matches!(mode, Mode::Manual) && pair.1.0 && wide > 0 && seen[0] == 3]-> Idle;
    }
}

grafcet! {
    /// Values under the rules of IEC 60848.
    pub grafcet Stored {
        input mode: Mode;
        input level: f32;
        input counts: [u16; 4];
        output shown: Mode = Mode::Manual;
        output power: f32;
        output copied: [u16; 4] = [0; 4];
        var kept: Mode = Mode::Manual;
        var mean: f32;

        initial step Idle { P1 kept = mode; power = level; }
        step Run { P1 shown = mode; P0 copied = counts; on rising(level > mean) mean = level; }

        Idle -[mode == Mode::Automatic]-> Run -[kept == mode && level < 0.5]-> Idle;
    }
}

grafcet! {
    /// Stored values that need not be equal to themselves.
    pub grafcet NoNumber {
        input go: bool;
        input level: f32;
        output seen: bool;
        var one, other: f32;

        initial step Idle;
        step First { P1 one = level; P0 other = one; seen; }
        step Second { P1 one = other; }

        Idle -[go]-> First -[!go]-> Second -[go && level < 0.0]-> Idle;
    }
}

grafcet! {
    /// The same in a type of the program.
    pub grafcet NoNumbers {
        input go: bool;
        input both: Pair<f32, f32>;
        output seen: bool;
        var one, other: Pair<f32, f32> = Pair(0.0, 0.0);

        initial step Idle;
        step First { P1 one = both; P0 other = one; seen; }
        step Second { P1 one = other; }

        Idle -[go]-> First -[!go]-> Second -[go && both.0 < 0.0]-> Idle;
    }
}

grafcet! {
    /// Names that Rust would write in another way, and raw ones.
    #[allow(non_snake_case)]
    pub sfc Names {
        input r#in, r#type, on, off, ready_1: bool;
        input X1, B2: bool;
        output r#match, r#loop: bool;
        output Q1: bool;
        var r#ref: bool;
        param r#final: time = 1s;
        action r#move(r#as: bool);

        initial step off_state { N r#match; N r#ref = true; }
        step r#fn { N r#loop if r#in; S Q1; N r#move(r#type); }
        step RUNNING { R Q1; P1 { r#ref = !r#ref; } }
        step step_3;

        off_state -[r#in && !r#type]-> r#fn -[r#go: on || X1 && r#fn.X]-> RUNNING -[r#final/RUNNING && B2]-> step_3;
        step_3 -[off || ready_1 && r#ref]-> off_state;
    }
}

grafcet! {
    /// A chart that is called like a module, with signals called like types.
    #[allow(non_camel_case_types, non_snake_case)]
    pub sfc line_1 {
        input START, Stop: bool;
        output Q1: bool;
        var Count: u8;
        param Limit: time = 1s;
        action Report(Value: u8);
        initial step idle;
        step busy { N Q1; N Report(Count); P1 { Count += 1; } }
        idle -[rising(START) && !Stop]-> busy -[Limit/busy || Count == 9]-> idle;
    }
}

/// Carries out no action.
#[derive(Clone, Copy, Debug)]
pub struct Silent;

impl ValuesActions for Silent {
    fn report(&mut self, _: Phase, _: Mode, _: f32, _: &'static str) {}
}

#[allow(non_snake_case)]
impl line_1Actions for Silent {
    fn Report(&mut self, _: Phase, _: u8) {}
}

impl NamesActions for Silent {
    fn r#move(&mut self, _: Phase, _: bool) {}
}

grafcet! {
    /// Types in which lifetimes have names.
    pub sfc Lifetimes {
        input pick: Option<for<'a> fn(&'a (u8, u8)) -> &'a u8>;
        input go: Option<for<'a, 'b> fn(&'a u8, &'b [u8]) -> &'a u8>;
        output level: u8 = 0;
        var last: for<'a> fn(&'a u8) -> &'a u8 = SAME;
        initial step A { level = go.map_or(0, |go| *last(go(&1, &[2]))); }
        step B { P1 last = SAME; level = pick.map_or(3, |pick| *pick(&(4, 5))); }
        A -[pick.is_some()]-> B -[pick.is_none()]-> A;
    }
}

const SAME: fn(&u8) -> &u8 = |value| value;

#[test]
fn lifetimes_have_names() {
    fn first(pair: &(u8, u8)) -> &u8 {
        &pair.0
    }
    fn go<'a>(value: &'a u8, _: &[u8]) -> &'a u8 {
        value
    }
    let mut chart = Lifetimes::new();
    assert_eq!(chart.cycle(&LifetimesInputs { pick: None, go: Some(go) }).level, 1);
    assert_eq!(chart.cycle(&LifetimesInputs { pick: Some(first), go: None }).level, 4);
}

#[test]
fn runs() {
    let inputs = ValuesInputs { mode: Mode::Automatic, level: 2.0, counts: [1; 4], big: 3, ..Default::default() };
    let mut values = Values::new();
    let q = values.cycle(&inputs, &mut Silent);
    assert_eq!((q.shown, q.chosen, q.text), (Mode::Automatic, Mode::Automatic, ""));
    let q = values.cycle(&inputs, &mut Silent);
    assert_eq!((q.power, q.copied, q.total), (3.0, [1; 4], 0), "`sum` is written after `total`");
    assert_eq!(values.cycle(&inputs, &mut Silent).total, (1 << 40) + 3);

    let mut stored = Stored::new();
    stored.cycle(&StoredInputs { mode: Mode::Manual, ..Default::default() });
    let q = stored.cycle(&StoredInputs { mode: Mode::Automatic, ..Default::default() });
    assert_eq!(q.shown, Mode::Automatic);

    let (nan, mut search) = (f32::NAN, NoNumber::new());
    let q = search.cycle(&NoNumberInputs { go: true, level: nan });
    assert!(q.seen, "the search ends");
    let mut search = NoNumbers::new();
    assert!(search.cycle(&NoNumbersInputs { go: true, both: Pair(nan, nan) }).seen, "the search ends");

    let mut names = Names::new();
    assert!(names.cycle(&NamesInputs::default(), 0, &mut Silent).r#match);
    assert!(names.cycle(&NamesInputs { r#in: true, ..Default::default() }, 1, &mut Silent).r#loop);
    names.cycle(&NamesInputs { X1: true, ..Default::default() }, 2, &mut Silent);
    assert!(names.is_active(NamesStep::RUNNING));
}
