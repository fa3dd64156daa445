use core::time::Duration;

use grafcet::{Phase, grafcet};

// While a transition is being written, the types stay: the arguments of `cycle`, what is constant, the names.
grafcet! {
    sfc Dyer {
        input start: bool;
        output ready: bool;
        param dye: time = 6s;
        action drum(rpm: u16);

        initial step Idle { N ready; }
        step Dye { N drum(45); }

        Idle -[start]-> Dye;
        Dye -[dye/Dye]->
    }
}

const COTTON: DyerParams = DyerParams::new();
const WOOL: DyerParams = DyerParams { dye: Dyer::ticks(Duration::from_secs(5)) };

struct Drum;

impl DyerActions for Drum {
    fn drum(&mut self, _: Phase, _: u16) {}
}

fn main() {
    let mut dyer = Dyer::with_params(WOOL);
    dyer.set_params(COTTON);
    let outputs = dyer.cycle(&DyerInputs { start: true }, 0_u32, &mut Drum);
    assert!(!outputs.ready && dyer.is_active(DyerStep::Dye));
    assert_eq!(dyer.next_deadline(), None);
}
