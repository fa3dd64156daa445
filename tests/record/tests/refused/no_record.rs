// What cannot be recorded is told at the type that the chart names.
use grafcet::grafcet;
use grafcet::record::Recorder;

#[derive(Clone, Copy, Default, PartialEq)]
pub enum Mode {
    #[default]
    Off,
    Auto,
}

grafcet! {
    pub sfc Motor {
        input mode: Mode;
        output relay: bool;
        initial step Off;
        step On { N relay; }
        Off -[mode == Mode::Auto]-> On -[mode == Mode::Off]-> Off;
    }
}

fn main() {
    _ = Recorder::new(Motor::new(), [0; 512]);
}
