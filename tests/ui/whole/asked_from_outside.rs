//! A mistake in the chart is the only one: what else a program asks of it is there.
use core::fmt::Display;

use grafcet::{Ticks, grafcet};

grafcet! {
    sfc Press {
        input start, down: bool;
        input level: u16;
        input heat: f32;
        input wait: time;
        output lower: bool;
        var strokes: u32;
        var pause: time = 2s;
        initial step Rest;
        step Lower { lower; P1 strokes = strokes + 1; }
        Rest -[start]-> Lower -[downn && level > 3 && heat > 1.0 && pause > wait]-> Rest;
    }
}

static STARTED: PressInputs = PressInputs { start: true, ..PressInputs::DEFAULT };
const NAME: &str = PressStep::Lower.name();

fn shown(name: impl Display) -> String {
    name.to_string()
}

fn main() {
    let mut press = Press::new();
    press.cycle(&STARTED);
    assert!(press.is_exactly(&[PressStep::Lower]));
    let (strokes, pause): (u32, Ticks) = (press.vars().strokes, press.vars().pause);
    println!("{strokes} {pause:?} {NAME} {}", shown(PressStep::Rest) + &shown(PressTransition::RestToLower));
}
