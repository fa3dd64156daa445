//! What stands after `in` is the whole enum: what is missing, or does not exist, is found at its name.

use grafcet::grafcet;

#[derive(Clone, Copy, Default, PartialEq)]
pub enum Mode {
    #[default]
    Off,
    Auto,
    Manual,
}

impl Mode {
    pub const DEFAULT: Self = Self::Off;
}

/// Compares as it likes.
#[derive(Clone, Copy, Default)]
pub enum Odd {
    #[default]
    One,
    Two,
}

impl PartialEq for Odd {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

grafcet! {
    pub sfc Missing {
        input mode: Mode in {Off, Auto};
        initial step A;
        step B;
        A -[mode == Mode::Auto]-> B -[mode == Mode::Off]-> A;
    }
}

grafcet! {
    pub sfc Misspelt {
        input mode: Mode in {Off, Auto, Manuel};
        initial step A;
        step B;
        A -[mode == Mode::Auto]-> B -[mode == Mode::Off]-> A;
    }
}

grafcet! {
    pub sfc Constant {
        input mode: Mode in {DEFAULT, Off, Auto, Manual};
        initial step A;
        step B;
        A -[mode == Mode::Auto]-> B -[mode == Mode::Off]-> A;
    }
}

grafcet! {
    pub sfc Unlisted {
        input mode: Mode in {Off, Auto, Manual};
        initial step A;
        step B;
        A -[mode == Mode::Hand]-> B -[mode == Mode::Off]-> A;
    }
}

grafcet! {
    pub sfc Oddly {
        input mode: Odd in {One, Two};
        initial step A;
        step B;
        A -[mode == Odd::One]-> B -[mode == Odd::Two]-> A;
    }
}

fn main() {}
