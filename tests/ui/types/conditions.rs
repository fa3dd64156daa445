use grafcet::grafcet;

// rustc's own errors point at the user's tokens.
#[derive(Clone, Copy, Default)]
pub enum Mode {
    #[default]
    Off,
    Auto,
}

grafcet! {
    pub sfc Motor {
        input level: u16;
        input mode: Mode;
        output relay: bool;

        initial step Off;
        step On { N relay if level; }

        Off -[level]-> On -[level > "high"]-> Off;
        Off -[mode.is_auto()]-> On;
        On -[mode == Mode::Auto]-> Off;
        On -[LIMIT < level]-> Off;
        On -[!level]-> Off;
    }
}

fn main() {}
