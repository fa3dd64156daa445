use grafcet::grafcet;

/// A type of the surrounding program.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
enum Mode {
    #[default]
    Stop,
    Auto,
    Manual,
    Jog,
}

// Branches that Rust tells apart in ways the checker does not look into.
grafcet! {
    grafcet Enum {
        input mode: Mode; input done: bool; output a, b, c: bool;
        initial step I; step A { a; } step B { b; } step C { c; }
        I -[mode == Mode::Auto]-> A; I -[mode == Mode::Manual]-> B; I -[matches!(mode, Mode::Jog | Mode::Stop)]-> C;
        A -[done && mode != Mode::Auto]-> I; B -[done && mode != Mode::Manual]-> I; C -[!matches!(mode, Mode::Jog | Mode::Stop)]-> I;
    }
}

// Comparisons with what the recipe may change.
grafcet! {
    grafcet Float {
        input t: f32; input on: bool; param low: f32 = 20.0; param high: f32 = 80.0; output heat, cool: bool;
        initial step I; step H { heat; } step C { cool; }
        I -[on && t < low]-> H; I -[on && t > high]-> C;
        H -[t >= low + 2.0 || !on]-> I; C -[t <= high - 2.0 || !on]-> I;
    }
}

// What different variants choose does not conflict.
grafcet! {
    grafcet EnumWrite {
        input mode: Mode in {Stop, Auto, Manual, Jog}; input go: bool; output speed: u16 = 0; output n: u8 = 0;
        initial step I { speed = 10 if mode == Mode::Auto; speed = 20 if mode == Mode::Manual; } step A { P1 n = 1; } step B { P1 n = 2; }
        I -[go && mode == Mode::Auto]-> A -[!go]-> I; I -[go && mode == Mode::Manual]-> B -[!go]-> I;
    }
}

/// What may be unknown.
fn known(level: u8) -> Option<u8> {
    (level > 0).then_some(level)
}

// What is left by `return`, `?`, `break` and `continue` is the user's own.
grafcet! {
    grafcet Leaving {
        input level: u8; input go: bool; output high: bool; output sum: u8 = 0;
        initial step I;
        step A { high if (|| Some(known(level)? > 100))().unwrap_or(false); P1 { 'told: { let Some(n) = known(level) else { break 'told }; sum = n; } } }
        step B { P1 { sum = 0; for n in 1..level { if n % 2 == 0 { continue; } sum += n; if sum > 9 { break; } } } }
        I -[go && loop { if level > 3 { break true } else if level < 9 { break level == 1 } }]-> A -[!go]-> B -[go]-> I;
    }
}

// Modes exclude each other, and there are no others.
grafcet! {
    sfc EnumHome {
        input mode: Mode in {Stop, Auto, Manual, Jog}; input done: bool; output a, b: bool;
        initial step I; step A { N a; } step B { N b; }
        I -[mode == Mode::Auto]-> A; I -[matches!(mode, Mode::Manual | Mode::Jog)]-> B;
        A -[done && mode != Mode::Auto]-> I; B -[Mode::Auto == mode]-> A; B -[mode == Mode::Stop]-> I;
        never a && b; home I; home B;
    }
}

/// A macro of the program, called with braces.
macro_rules! halved {
    ($value:expr) => {
        $value / 2
    };
}

// Conditions that begin with a block, which Rust takes for a statement of its own elsewhere.
grafcet! {
    grafcet Blocks {
        input a, b: bool; input level: u8; output high, low: bool;
        initial step I;
        step A { high if const { 1 } & level == 1; low if { b } & a; }
        I -[loop { if a { break b } else if !a { break a } } & b]-> A;
        A -[halved! { level } > 3 && a]-> I;
        A -[(if a { level } else { 0 }) == 0 && !a]-> I;
        A -[match level { 0 => 1, n => n } == 9 && a && halved! { level } <= 3]-> I;
    }
}
