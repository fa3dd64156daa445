//! Both dialects with everything at once.

use grafcet::{Chart, Phase, Ticks, grafcet};

grafcet! {
    /// A batch: parallel branches, times, edges, a recipe, a code action.
    pub sfc Batch {
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
    /// A cell: forcing, an enclosing step, a macro-step, an action on clearing.
    pub grafcet Cell {
        input estop, start, part, full, clamped, auto: bool;
        output belt, clamp, lamp, bell: bool;
        var n: u16 = 0;

        partial Safety {
            initial step Ready;
            step Stopped { force Production {}; lamp; }
            Ready -[estop]-> Stopped -[!estop]-> Restart -[true]-> Ready;
            step Restart { force Production {INIT}; }
        }

        partial Production {
            initial step Idle;
            step Feed { belt; }
            macro step Clamp {
                entry step Close { S clamp; }
                exit step Open { R clamp; }
                Close -[clamped]-> Open;
            }
            enclosing step Auto {
                bell if Clamp.X;
                partial Counting {
                    linked step Count { on rising(part) n = n + 1; }
                }
            }
            Idle -[start]-> Feed -[full]-> Clamp -[!clamped]-> Idle;
            Idle -[auto && !start]-> Auto -[n >= 2 && !part => n = 0]-> Idle;
        }
    }
}

grafcet! {
    /// Times, a code action in every way, a block and a delay under the rules of IEC 60848.
    pub grafcet Oven {
        input door, start: bool;
        output lamp, fan: bool;
        output burner: bool;
        output power: u8;
        #[allow(grafcet::unused_variable)]
        var runs: u16 = 0;
        var hot: bool;
        param bake: time = 10s;
        action beep(times: u8);
        clock 10ms;
        max_evolutions 8;

        initial step Off { P1 beep(1); lamp if door; }
        step Bake { S burner; hot; N beep(2); power = 80; L 2s fan; P0 { runs += 1; } }
        step Cool { R burner; D 1s fan; on falling(door) beep(3); }

        Off -[begin: rising(start) && !door => beep(4)]-> Bake -[bake/Bake || 1s/door/200ms]-> Cool;
        Cool -[Cool.T >= 3s && !hot]-> Off;
    }
}

/// Runs any chart without code actions.
pub fn run<C: for<'a> Chart<Actions<'a> = ()>>(chart: &mut C, inputs: &C::Inputs) -> C::Outputs {
    chart.scan(inputs, Ticks::ZERO, &mut ())
}

/// Counts its calls.
#[derive(Default)]
pub struct Calls(pub usize);

impl BatchActions for Calls {
    fn heat(&mut self, _: Phase, _: i16) {
        self.0 += 1;
    }
}

impl OvenActions for Calls {
    fn beep(&mut self, _: Phase, _: u8) {
        self.0 += 1;
    }
}

#[test]
fn runs() {
    let (mut batch, mut calls) = (Batch::with_params(BatchParams { hot: 90, ..Default::default() }), Calls::default());
    batch.cycle(&BatchInputs::default(), 0, &mut calls);
    batch.cycle(&BatchInputs { start: true, ..Default::default() }, 10, &mut calls);
    assert_eq!(&batch.active_steps()[..], [BatchStep::Fill, BatchStep::Heat]);
    assert_eq!(calls.0, 1);

    let mut cell = Cell::new();
    run(&mut cell, &CellInputs::default());
    assert!(run(&mut cell, &CellInputs { estop: true, ..Default::default() }).lamp);

    let mut oven = Oven::new();
    assert_eq!(oven.cycle(&OvenInputs::default(), 0, &mut calls).power, 0);
    let q = oven.cycle(&OvenInputs { start: true, ..Default::default() }, 1, &mut calls as &mut dyn OvenActions);
    assert!(q.burner && q.fan && q.power == 80);
    assert_eq!(oven.next_deadline(), Some(Ticks::new(1)));
    assert_eq!(calls.0, 4);
}
