//! Charts that use everything at once: they have to compile, and keep to a few obvious expectations.

use grafcet::{Phase, grafcet};

grafcet! {
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

#[derive(Default)]
struct Calls(Vec<(Phase, i16)>);

impl BatchActions for Calls {
    fn heat(&mut self, phase: Phase, setpoint: i16) {
        self.0.push((phase, setpoint));
    }
}

#[test]
fn batch() {
    let mut batch = Batch::new();
    let mut calls = Calls::default();
    let idle = BatchInputs { level: 5, ..Default::default() };
    assert!(batch.cycle(&idle, 0, &mut calls).lamp);
    batch.cycle(&BatchInputs { start: true, ..idle }, 10, &mut calls);
    assert_eq!(&batch.active_steps()[..], [BatchStep::Fill, BatchStep::Heat]);
    assert_eq!(calls.0, [(Phase::First, 80)]);
    let q = batch.cycle(&idle, 1010, &mut calls);
    assert!(q.pump && q.lamp && q.valve && q.speed == 10);
    let q = batch.cycle(&BatchInputs { full: true, ..idle }, 5010, &mut calls);
    assert!(!q.pump && !q.valve && q.speed == 0);
    assert_eq!(&batch.active_steps()[..], [BatchStep::Stir]);
    assert_eq!(calls.0[2..], [(Phase::Repeated, 40)]);
}

grafcet! {
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

#[test]
fn cell() {
    let mut cell = Cell::new();
    let idle = CellInputs::default();
    cell.cycle(&idle);
    cell.cycle(&CellInputs { auto: true, ..idle });
    assert_eq!(format!("{:?}", cell.situation()), "{Ready, Auto, Count}");
    cell.cycle(&CellInputs { part: true, ..idle });
    cell.cycle(&idle);
    cell.cycle(&CellInputs { part: true, ..idle });
    assert_eq!(format!("{:?}", cell.situation()), "{Ready, Auto, Count}");
    cell.cycle(&idle);
    assert_eq!(format!("{:?}", cell.situation()), "{Ready, Idle}");
    cell.cycle(&CellInputs { estop: true, ..idle });
    assert_eq!(format!("{:?}", cell.situation()), "{Stopped}");
    cell.cycle(&idle);
    assert_eq!(format!("{:?}", cell.situation()), "{Ready, Idle}");
}

grafcet! {
    /// Two stations beside each other, and a bit for each step.
    pub grafcet Stations {
        encoding flags;
        input part, drilled, tested: bool;
        output drill, test, motor: bool;

        initial step Wait;
        step Drill { S motor; drill; }
        step Drilled;
        step Test { test; }
        step Tested;
        step Out { R motor; }

        Wait -[part]-> (Drill, Test);
        Drill -[drilled]-> Drilled;
        Test -[tested]-> Tested;
        (Drilled, Tested) -[!part]-> Out -[2s/Out]-> Wait;
    }
}

#[test]
fn stations() {
    let mut stations = Stations::new();
    let none = StationsInputs::default();
    assert!(stations.is_active(StationsStep::Wait) && !stations.cycle(&none, 0).motor);
    let q = stations.cycle(&StationsInputs { part: true, ..none }, 10);
    assert!(q.motor && q.drill && q.test);
    assert_eq!(&stations.active_steps()[..], [StationsStep::Drill, StationsStep::Test]);
    stations.cycle(&StationsInputs { part: true, drilled: true, ..none }, 20);
    assert_eq!(format!("{:?}", stations.situation()), "{Drilled, Test}");
    assert!(!stations.cycle(&StationsInputs { tested: true, ..none }, 30).motor);
    assert!(stations.situation().is_active(StationsStep::Out));
    stations.cycle(&none, 2030);
    assert!(stations.situation() == Stations::new().situation(), "{stations:?}");
}
