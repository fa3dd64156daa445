//! Plants on the host: a closed loop of the chart and what it moves.

use grafcet::{Ticks, grafcet};

grafcet! {
    sfc Press {
        input start, top, bottom: bool;
        output lower, alarm: bool;

        initial step Rest;
        step Down { lower; }
        step Up;
        step Stopped { alarm; }

        Rest -[start && top]-> Down -[bottom]-> Up -[top]-> Rest;
        Down -[5s/Down]-> Stopped -[start && top]-> Rest;
    }

    /// It goes down as long as it is told to, and up by a spring.
    #[cfg(test)]
    plant Cylinder {
        input lower: bool;
        output top, bottom: bool;
        fault jammed, blind;

        initial step Top { top; }
        step Going;
        step Bottom { N bottom if !blind; }
        step Coming;
        step Slipped;

        Top -[lower && !jammed]-> Going;
        either Going -[1s..2s/Going && !jammed]-> (Bottom or Slipped);
        Going -[!lower]-> Coming;
        Bottom -[!lower]-> Coming;
        Slipped -[!lower]-> Coming -[1s..2s/Coming]-> Top;
    }
}

/// The chart and its plant, cycle by cycle, 100 ms apart.
struct Loop {
    press: Press,
    cylinder: Cylinder,
    shown: CylinderOutputs,
    now: u32,
}

impl Loop {
    fn new() -> Self {
        let mut cylinder = Cylinder::new();
        let shown = cylinder.cycle(&CylinderInputs::default(), Ticks::ZERO);
        Self { press: Press::new(), cylinder, shown, now: 0 }
    }

    /// One cycle with these choices and faults.
    fn cycle(&mut self, start: bool, free: CylinderInputs) -> PressOutputs {
        let inputs = PressInputs { start, top: self.shown.top, bottom: self.shown.bottom };
        let told = self.press.cycle(&inputs, self.now);
        self.shown = self.cylinder.cycle(&CylinderInputs { lower: told.lower, ..free }, self.now);
        self.now += 100;
        told
    }

    /// After so many cycles with the same of all.
    fn after(&mut self, cycles: u32, start: bool, free: CylinderInputs) -> PressStep {
        for _ in 0..cycles {
            self.cycle(start, free);
        }
        self.press.situation()
    }
}

#[test]
fn a_stroke_takes_as_long_as_the_plant_likes() {
    let slow = CylinderInputs::default();
    let fast = CylinderInputs { early_going: true, early_coming: true, ..slow };
    let strokes = [slow, fast].map(|free| {
        let mut press = Loop::new();
        press.after(2, false, free);
        press.cycle(true, free);
        let mut cycles = 1;
        while press.press.situation() != PressStep::Rest {
            press.cycle(false, free);
            cycles += 1;
            assert!(cycles < 100, "it does not come back");
        }
        cycles
    });
    // The cycle that starts, two seconds or one down, one that sees it, the same time up, and one that sees that.
    assert_eq!(strokes, [43, 23]);
}

#[test]
fn faults_are_switched_on_by_name() {
    let well = CylinderInputs::default();
    for fault in [
        CylinderInputs { jammed: true, ..well },
        CylinderInputs { blind: true, ..well },
        CylinderInputs { choose_slipped: true, ..well },
    ] {
        let mut press = Loop::new();
        assert_eq!(press.after(2, false, fault), PressStep::Rest);
        assert_eq!(press.after(1, true, fault), PressStep::Down);
        assert_eq!(press.after(49, false, fault), PressStep::Down);
        assert_eq!(press.after(2, false, fault), PressStep::Stopped);
    }
}

#[test]
fn random_choices_never_leave_it_waiting() {
    let mut seed = 1_u32;
    let mut random = || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        seed >> 31 == 1
    };
    let mut press = Loop::new();
    let mut rests = 0;
    for _ in 0..10_000 {
        let free = CylinderInputs { early_going: random(), early_coming: random(), ..CylinderInputs::default() };
        press.cycle(true, free);
        rests += u32::from(press.press.situation() == PressStep::Rest);
        assert_ne!(press.press.situation(), PressStep::Stopped);
    }
    assert!(rests > 200, "{rests}");
}
