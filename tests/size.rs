//! The state of a chart holds what the chart needs, and nothing else.

mod charts;

use grafcet::grafcet;
use proc_macro2::TokenStream;

grafcet! {
    /// One step at a time: a plain enum.
    sfc Motor {
        input on, off, over_temp: bool;
        output relay, green, red: bool;
        initial step Off { N red; }
        step On { N relay; N green; }
        Off -[on && !over_temp]-> On -[off || over_temp]-> Off;
    }
}

grafcet! {
    /// One stored output.
    grafcet Line24V {
        input b1, b2, b3, b4, b5: bool;
        output q1, q2, q3: bool;
        initial step S1 { q1; }
        step S2 { S q2; }
        step S3 { q3 if b5; }
        step S4 { R q2; }
        S1 -[b1]-> S2 -[b2]-> S3 -[b3]-> S4 -[b4]-> S1;
    }
}

grafcet! {
    /// Three branches beside each other.
    sfc Parallel {
        input go, done: bool;
        output a, b, c: bool;
        initial step Start;
        step A { a; }
        step B { b; }
        step C { c; }
        Start -[go]-> (A, B, C);
        (A, B, C) -[done]-> Start;
    }
}

/// Charts of so many steps, with a bit for each.
macro_rules! flags {
    ($dialect:ident $name:ident: $first:ident $($step:ident)*) => {
        grafcet! {
            $dialect $name {
                encoding flags;
                input go, back: bool;
                initial step $first;
                $(step $step;)*
                $first $(-[go]-> $step)* -[back && !go]-> $first;
            }
        }
    };
}

flags! { sfc SevenFlags: S1 S2 S3 S4 S5 S6 S7 }
flags! { sfc EightFlags: S1 S2 S3 S4 S5 S6 S7 S8 }
flags! { grafcet SearchedFlags: S1 S2 S3 S4 S5 S6 S7 S8 }
flags! { grafcet SixteenFlags: S1 S2 S3 S4 S5 S6 S7 S8 S9 S10 S11 S12 S13 S14 S15 S16 }

grafcet! {
    /// Three branches beside each other, with bits.
    sfc ParallelFlags {
        encoding flags;
        input go, done: bool;
        output a, b, c: bool;
        initial step Start;
        step A { a; }
        step B { b; }
        step C { c; }
        Start -[go]-> (A, B, C);
        (A, B, C) -[done]-> Start;
    }
}

#[test]
fn flags() {
    assert_eq!(size_of::<SevenFlags>(), 1, "seven bits, and one for the first cycle");
    assert_eq!(size_of::<EightFlags>(), 2);
    assert_eq!(size_of::<SearchedFlags>(), 1, "the first cycle is like the others");
    assert_eq!(size_of::<SixteenFlags>(), 2);
    assert_eq!(size_of::<ParallelFlags>(), 1, "and not a byte per branch");
    assert_eq!(size_of::<ParallelFlagsSituation>(), 1);
    // What is seen from outside is the same.
    let step: SevenFlagsStep = SevenFlags::new().situation();
    assert_eq!(step, SevenFlagsStep::S1);
    assert_eq!(SevenFlags::new().active_steps().capacity(), 1);
    assert_eq!(ParallelFlags::new().active_steps().capacity(), Parallel::new().active_steps().capacity());
}

#[test]
fn situation() {
    assert_eq!(size_of::<Motor>(), 1);
    assert_eq!(size_of::<Line24V>(), 1, "one byte for the situation, which tells q2");
    assert_eq!(size_of::<Parallel>(), 3, "one byte per branch");
    // Whether the first cycle has run and whether a search was stable need no bytes: nor do names and outputs.
    assert_eq!(size_of::<Option<Motor>>(), 1);
    assert_eq!(size_of::<MotorStep>(), 1);
    assert_eq!(size_of::<ParallelSituation>(), 3);
    assert_eq!(size_of::<MotorInputs>(), 3);
}

/// The chart `$name` with what makes it larger.
macro_rules! chart {
    ($dialect:ident $name:ident { $($tokens:tt)* }) => {
        grafcet! {
            $dialect $name {
                // What is measured need not make sense.
                #![allow(grafcet::unused_input, grafcet::unused_variable, grafcet::set_without_reset)]
                #![allow(grafcet::shadowed_branch)]
                input a, b: bool;
                input level: u16;
                initial step First;
                First -[a]-> Second -[b]-> First;
                $($tokens)*
            }
        }
    };
}

chart! { sfc Continuous { output speed: u16; output q: bool; step Second { speed = level; q if b; } } }
chart! { sfc Stored { output q: bool; step Second { S q; } Second -[b && a]-> Third; step Third { R q; } Third -[b]-> First; } }
chart! { sfc StoredWord { output speed: u16; step Second { P1 speed = level; } } }
chart! { sfc Read { output q: bool; step Second { q; } Second -[q]-> First; } }
chart! { sfc Edge { step Second; Second -[rising(a)]-> First; } }
chart! { sfc OneEdge { step Second; Second -[rising(a)]-> First; First -[falling(a)]-> Second; } }
chart! { sfc TwoEdges { step Second; Second -[rising(a)]-> First; Second -[rising(b)]-> First; } }
chart! { grafcet Variables { var n: u16; var x: bool; step Second { P1 n = n + 1; P1 x = b; } } }
chart! { grafcet Combinational { var x: bool; step Second { x; } Second -[x && !a]-> First; } }
chart! { sfc Recipe { param limit: u16 = 3; step Second; Second -[level > limit]-> First; } }
chart! { sfc Call { action call(); step Second { P1 call(); } } }
chart! { sfc Calls { action call(); step Second { N call(); } } }

#[test]
fn memory_follows_from_use() {
    assert_eq!(size_of::<Continuous>(), 1, "continuous outputs are not remembered");
    assert_eq!(size_of::<Stored>(), 1 + 1);
    assert_eq!(size_of::<StoredWord>(), 2 + 2, "the situation, aligned, and the output");
    assert_eq!(size_of::<Read>(), 1, "an output that is read is the one of the cycle before, which the step tells");
    assert_eq!(size_of::<Edge>(), 1 + 1);
    assert_eq!(size_of::<OneEdge>(), 1 + 1, "both edges of one signal compare with one value");
    assert_eq!(size_of::<TwoEdges>(), 1 + 2);
    assert_eq!(size_of::<Variables>(), 1 + 1 + 2);
    assert_eq!(size_of::<Combinational>(), 1, "what follows from the situation is not remembered");
    assert_eq!(size_of::<Recipe>(), 2 + 2);
    assert_eq!(size_of::<Call>(), 1);
    assert_eq!(size_of::<Calls>(), 1, "whether the next call is a first one the state tells");
}

/// A type of the program: nobody knows what its address is a multiple of.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Grams(u8);

chart! { grafcet Unsure { output n: u16; step Second { P1 n = n.wrapping_add(1); } } }
chart! { grafcet UnsureAndFull { output n: u16; var m: u8; step Second { P1 n = n.wrapping_add(1); P1 m = m.wrapping_add(1); } Second -[m == 77]-> First; } }
chart! { grafcet UnsureAndOwn { output n: u16; var m: Grams = Grams(0); step Second { P1 n = n.wrapping_add(1); P1 m = Grams(m.0.wrapping_add(1)); } Second -[m == Grams(77)]-> First; } }
chart! { grafcet UnsureSize { output n: u16; var m: usize; step Second { P1 n = n.wrapping_add(1); P1 m = m.wrapping_add(1); } Second -[m == 77]-> First; } }
chart! { grafcet UnsureWide { output n: u16; var m: u128; step Second { P1 n = n.wrapping_add(1); P1 m = m.wrapping_add(1); } Second -[m == 77]-> First; } }
chart! { grafcet UnsureRecipe { output n: u16; param k: u8 = 77; step Second { P1 n = n.wrapping_add(1); } Second -[level == u16::from(k)]-> First; } }

/// Whether a search became stable takes a byte that alignment leaves, or none.
#[test]
fn a_search_that_may_have_no_end() {
    assert_eq!(size_of::<Line24V>(), 1, "a bit above the state");
    assert_eq!(size_of::<Unsure>(), 1 + 2 + 1, "the byte that is left");
    assert_eq!(size_of::<UnsureAndFull>(), 1 + 1 + 2, "a bit above the state: no byte is left");
    assert_eq!(size_of::<UnsureAndOwn>(), 1 + 1 + 2, "the same: nobody knows what the type of the program takes");
    assert_eq!(size_of::<UnsureRecipe>(), 1 + 1 + 2, "the recipe counts, too");
    // What `usize` and 128 bits leave differs from controller to controller: a field would cost some of them RAM.
    let has_field = |fields: String| fields.contains("stable");
    assert!(has_field(format!("{:?}", Unsure::new())));
    assert!(!has_field(format!("{:?}", UnsureSize::new())));
    assert!(!has_field(format!("{:?}", UnsureWide::new())));
    macro_rules! is_stable {
        ($chart:ident, $inputs:ident) => {{
            let mut chart = $chart::new();
            let told = [(true, true), (true, false), (true, true), (true, true), (false, false)].map(|(a, b)| {
                _ = chart.cycle(&$inputs { a, b, level: 0 });
                chart.is_stable()
            });
            assert_eq!(told, [false, true, false, false, true], stringify!($chart));
        }};
    }
    is_stable!(Unsure, UnsureInputs);
    is_stable!(UnsureAndFull, UnsureAndFullInputs);
    is_stable!(UnsureAndOwn, UnsureAndOwnInputs);
    is_stable!(UnsureRecipe, UnsureRecipeInputs);
    is_stable!(UnsureSize, UnsureSizeInputs);
    is_stable!(UnsureWide, UnsureWideInputs);
}

chart! { sfc Wide {
    var k: u64; var l: u8; var m: usize; var n: u16; var o: i32; var p: i8; var q: f32; var r: u64;
    param v: u8 = 1; param w: u16 = 3;
    step Second {
        P1 {
            k = k.wrapping_add(1); l = l.wrapping_add(v); m = m.wrapping_add(1); n = n.wrapping_add(w);
            o = o.wrapping_add(1); p = p.wrapping_add(1); q += 1.0; r = r.wrapping_add(2);
        }
    }
} }

chart! { sfc WideOwn {
    var k: u64; var l: u8; var m: u64; var n: Grams = Grams(0); var o: u64; var p: u64;
    step Second {
        P1 {
            k = k.wrapping_add(1); l = l.wrapping_add(1); m = m.wrapping_add(1); n = Grams(l);
            o = o.wrapping_add(1); p = p.wrapping_add(2);
        }
    }
    Second -[n == Grams(9)]-> First;
} }

/// A large state begins with what is small, which short instructions reach there. That takes no more bytes, whatever its fields are.
#[test]
fn a_large_state_wastes_none() {
    let small = 1 + size_of::<u8>() + size_of::<i8>() + size_of::<u16>() + size_of::<WideParams>();
    let words = size_of::<i32>() + size_of::<f32>() + size_of::<usize>();
    assert_eq!(size_of::<WideParams>(), 4);
    assert_eq!(size_of::<Wide>(), (small + words).next_multiple_of(align_of::<u64>()) + 2 * size_of::<u64>());
    assert_eq!(size_of::<WideOwn>(), 3_usize.next_multiple_of(align_of::<u64>()) + 4 * size_of::<u64>());
}

chart! { sfc Timed { step Second; Second -[5s/Second]-> First; } }
chart! { sfc TimedBranches {
    step Second; step A1; step A2; step B1; step B2;
    Second -[level > 3]-> (A1, B1); A1 -[5s/A1]-> A2; B1 -[6s/B1]-> B2; (A2, B2) -[a]-> First;
} }
chart! { sfc LongBranches {
    step Second; step A1; step A2; step B1; step B2;
    Second -[level > 3]-> (A1, B1); A1 -[65536ms/A1]-> A2; B1 -[65537ms/B1]-> B2; (A2, B2) -[a]-> First;
} }
chart! { grafcet TimedOnce { step Second; Second -[5s/Second || Second.T > 1s && b]-> First; } }
chart! { sfc Limited { output q: bool; step Second { L 2s q; } } }
chart! { sfc LimitedTwice { output q: bool; step Second { L 2s q; } step Third { L 2s q; } Second -[a]-> Third -[b]-> First; } }
chart! { sfc Kept { output q: bool; step Second { SL 2s q; } } }
chart! { sfc Delayed { step Second; Second -[1s/b/2s]-> First; } }
chart! { sfc TimedRecipe { param soak: time = 5s; step Second; Second -[soak/Second]-> First; } }

#[test]
fn time() {
    // The reading of the clock; and of the single bytes: the situation, and whether anything is due at once.
    let with = |words: usize, bytes: usize| (4 * (1 + words) + 2 + bytes).next_multiple_of(4);
    // A recorder asks for the reading in any case.
    let recorded = usize::from(cfg!(feature = "record"));
    assert_eq!(
        size_of::<Timed>(),
        with(recorded, 0),
        "when the active step was entered, and nothing else of the clock"
    );
    assert_eq!(
        size_of::<TimedBranches>(),
        with(1 + recorded, 2),
        "one for each branch, and the state with which its last cycle began"
    );
    assert_eq!(size_of::<LongBranches>(), with(1 + recorded, 2), "the same with longer times");
    assert_eq!(size_of::<TimedOnce>(), with(1, 0), "one time, however often it is looked at");
    assert_eq!(size_of::<Limited>(), with(recorded, 0), "the same");
    assert_eq!(
        size_of::<LimitedTwice>(),
        with(1, 0),
        "a timer: how long it has run, and the input of the cycle before"
    );
    assert_eq!(size_of::<Kept>(), with(1, 2), "a timer and a flip-flop");
    assert_eq!(
        size_of::<Delayed>(),
        with(1, 2),
        "a delay: how long, and its input and output; what the last cycle began with"
    );
    assert_eq!(size_of::<TimedRecipe>(), with(2, 0));
}

/// A sequence of these steps.
macro_rules! sequence {
    ($dialect:ident $name:ident: $first:ident $($step:ident)*) => {
        grafcet! {
            $dialect $name {
                input go, back: bool;
                initial step $first;
                $(step $step;)*
                $first $(-[go]-> $step)* -[back]-> $first;
            }
        }
    };
}

/// A sequence of two hundred steps and more.
macro_rules! long {
    ($dialect:ident $name:ident: $($more:ident)*) => {
        sequence! { $dialect $name:
            S000 S001 S002 S003 S004 S005 S006 S007 S008 S009 S010 S011 S012 S013 S014 S015 S016 S017 S018 S019
            S020 S021 S022 S023 S024 S025 S026 S027 S028 S029 S030 S031 S032 S033 S034 S035 S036 S037 S038 S039
            S040 S041 S042 S043 S044 S045 S046 S047 S048 S049 S050 S051 S052 S053 S054 S055 S056 S057 S058 S059
            S060 S061 S062 S063 S064 S065 S066 S067 S068 S069 S070 S071 S072 S073 S074 S075 S076 S077 S078 S079
            S080 S081 S082 S083 S084 S085 S086 S087 S088 S089 S090 S091 S092 S093 S094 S095 S096 S097 S098 S099
            S100 S101 S102 S103 S104 S105 S106 S107 S108 S109 S110 S111 S112 S113 S114 S115 S116 S117 S118 S119
            S120 S121 S122 S123 S124 S125 S126 S127 S128 S129 S130 S131 S132 S133 S134 S135 S136 S137 S138 S139
            S140 S141 S142 S143 S144 S145 S146 S147 S148 S149 S150 S151 S152 S153 S154 S155 S156 S157 S158 S159
            S160 S161 S162 S163 S164 S165 S166 S167 S168 S169 S170 S171 S172 S173 S174 S175 S176 S177 S178 S179
            S180 S181 S182 S183 S184 S185 S186 S187 S188 S189 S190 S191 S192 S193 S194 S195 S196 S197 S198 S199
            $($more)*
        }
    };
}

long! { sfc TwoHundred: }
long! { grafcet Marked: }
long! {
    sfc ThreeHundred:
    S200 S201 S202 S203 S204 S205 S206 S207 S208 S209 S210 S211 S212 S213 S214 S215 S216 S217 S218 S219
    S220 S221 S222 S223 S224 S225 S226 S227 S228 S229 S230 S231 S232 S233 S234 S235 S236 S237 S238 S239
    S240 S241 S242 S243 S244 S245 S246 S247 S248 S249 S250 S251 S252 S253 S254 S255 S256 S257 S258 S259
    S260 S261 S262 S263 S264 S265 S266 S267 S268 S269 S270 S271 S272 S273 S274 S275 S276 S277 S278 S279
    S280 S281 S282 S283 S284 S285 S286 S287 S288 S289 S290 S291 S292 S293 S294 S295 S296 S297 S298 S299
}

#[test]
fn long_sequences() {
    assert_eq!(size_of::<TwoHundred>(), 1);
    assert_eq!(size_of::<ThreeHundred>(), 2, "more states than a byte has values");
    assert_eq!(size_of::<Marked>(), 2, "the mark of an unstable search stands above the states");
    let mut marked = Marked::new();
    marked.cycle(&MarkedInputs { go: true, back: true });
    assert!(!marked.is_stable() && marked.is_active(MarkedStep::S002), "402 evolutions");
    marked.cycle(&MarkedInputs { go: false, back: false });
    assert!(marked.is_stable() && marked.is_active(MarkedStep::S002));
    let mut chart = ThreeHundred::new();
    for _ in 0..300 {
        chart.cycle(&ThreeHundredInputs { go: true, back: false });
    }
    assert!(chart.is_active(ThreeHundredStep::S299));
}

/// What the documentation of the type says is what the type is.
#[test]
fn encoding_is_documented() {
    let said = |chart: TokenStream| {
        let tokens = charts::expand(chart).to_string();
        let text = tokens.split("The situation takes ").nth(1).map(|rest| rest.split('.').next().unwrap_or_default());
        text.unwrap_or_default().to_owned()
    };
    let said: Vec<String> = charts::charts(include_str!("size.rs")).into_iter().map(said).collect();
    let expected = [
        "one byte: which of its 2 steps is active",
        "one byte: which of its 4 steps is active",
        "3 bytes: for each of these sets of steps, which of them is active, if any",
        "one byte (`encoding flags;`): a bit for each of its 4 steps and one for the first cycle, as long as it is still \
         to come",
    ];
    assert_eq!(said, expected, "Motor, Line24V, Parallel, ParallelFlags");
}

chart! { sfc Cleared {
    output q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14: bool; output code: u8 = 0; output parts: u16 = 0;
    step Second { q1; q2; q3; q4; q5; q6; q7; q8; q9; q10; q11; q12; q13; q14; code = 3; P1 parts = parts.wrapping_add(1); }
} }
chart! { sfc NotCleared { output q1, q2, q3, q4, q5, q6, q7, q8: bool; output code: u8 = 0; step Second { q1; q2; q3; q4; q5; q6; q7; q8; code = 3; } } }

/// Many outputs are cleared piece by piece: what stands between the pieces is chosen by where it lies, so the struct keeps the order.
#[test]
fn outputs_lie_as_they_are_cleared() {
    assert_eq!(size_of::<ClearedOutputs>(), 20, "17 bytes, in words");
    assert_eq!(std::mem::offset_of!(ClearedOutputs, parts), 0);
    assert_eq!(std::mem::offset_of!(ClearedOutputs, q1), 2);
    assert_eq!(std::mem::offset_of!(ClearedOutputs, q14), 15);
    assert_eq!(std::mem::offset_of!(ClearedOutputs, code), 16);
    assert_eq!(size_of::<NotClearedOutputs>(), 12);
}
