//! What a chart waits for on the controller, as numbers, is what the simulation tells from its source as text.

use std::fmt::Write as _;

use grafcet::record::{Blocked, Recordable, Recorder};
use grafcet_record::Storm;
use grafcet_record::branch_on_result::Sorter;
use grafcet_record::cell::{Cell, CellInputs};
use grafcet_record::line24v::Line24V;
use grafcet_record::motor::Motor;
use grafcet_record::tickless::Crossing;
use grafcet_sim::{Chart, Replay};

/// Cycle by cycle, in storms of inputs.
fn agree<C>(chart: &C, file: &str)
where
    C: for<'a> Recordable<Actions<'a> = ()> + Blocked,
{
    let source = Chart::in_file(file, C::NAME).unwrap_or_else(|refused| panic!("{}: {refused}", C::NAME));
    for seed in 0..5 {
        let mut recorder = Recorder::new(chart.clone(), vec![0; 100_000]).expect("enough memory");
        let mut storm = Storm::<C::Inputs>::new(seed);
        let mut blocked: Vec<Vec<usize>> = Vec::new();
        for _ in 0..1_000 {
            let (inputs, now) = storm.cycle();
            recorder.cycle(&inputs, now, &mut ());
            blocked.push(recorder.chart().blocked().collect());
        }
        recorder.flush();
        let trace =
            Replay::new().run(&source, recorder.record()).unwrap_or_else(|error| panic!("{}: {error}", C::NAME));
        let mut number = 0;
        for cycle in &trace.cycles {
            number += cycle.skipped as usize;
            let waiting: Vec<usize> = cycle.blocked.waiting.iter().map(|waiting| waiting.transition).collect();
            assert_eq!(blocked[number], waiting, "{} {seed}: cycle {number}", C::NAME);
            number += 1;
        }
        assert_eq!(number, blocked.len(), "{}", C::NAME);
    }
}

#[test]
fn the_numbers_are_those_of_the_simulation() {
    agree(&Motor::new(), include_str!("../../../examples/charts/motor.rs"));
    agree(&Cell::new(), include_str!("../../../examples/charts/cell.rs"));
    agree(&Line24V::new(), include_str!("../../../examples/charts/line24v.rs"));
    agree(&Sorter::new(), include_str!("../../../examples/charts/branch_on_result.rs"));
    agree(&Crossing::new(), include_str!("../../../examples/charts/tickless.rs"));
}

/// A few bytes from the controller, and the chart's source at the desk.
#[test]
fn a_number_is_a_transition_of_the_source() {
    let mut cell = Cell::new();
    cell.cycle(&CellInputs::default());
    let sent: Vec<u8> = cell.blocked().filter_map(|number| u8::try_from(number).ok()).collect();

    let source = Chart::in_file(include_str!("../../../examples/charts/cell.rs"), "Cell").expect("a chart");
    let mut text = String::new();
    for number in sent {
        let transition = &source.names().transitions[usize::from(number)];
        _ = writeln!(text, "{}: {}", transition.name, transition.condition);
    }
    let described: Vec<&str> = cell.blocked().map(|number| Cell::CHART.transitions[number].condition).collect();
    let conditions: Vec<&str> = text.lines().filter_map(|line| Some(line.split_once(": ")?.1)).collect();
    assert_eq!(conditions, described);
    assert_eq!(text, "Ready → Stopped: estop\nManual → Auto: rising(auto)\n");
}
