//! The record of a stopped cell is one of today's layout: `BLESS=1 cargo test -p grafcet-record --test layout` makes it anew.

use std::fs;
use std::path::Path;

use grafcet::record::Recorder;
use grafcet_record::cell::{Cell, CellInputs};
use grafcet_sim::{Chart, Replay, Value};

#[test]
fn the_stopped_cell_is_of_todays_layout() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cell_stopped.record");
    let old = fs::read(&file).expect("the record");
    let chart = Chart::in_file(include_str!("../../../examples/charts/cell.rs"), "Cell").expect("the chart");
    let trace = Replay::new().run(&chart, &old).expect("a record");
    let mut recorder = Recorder::new(Cell::new(), vec![0; old.len()]).expect("enough memory");
    for cycle in &trace.cycles {
        let on = |name: &str| {
            let place = trace.names.inputs.iter().position(|input| input.name == name).expect("an input");
            cycle.inputs[place] == Value::Bool(true)
        };
        let inputs = CellInputs {
            estop: on("estop"),
            ack: on("ack"),
            auto: on("auto"),
            part: on("part"),
            clamped: on("clamped"),
            drilled: on("drilled"),
            stamped: on("stamped"),
        };
        recorder.cycle(&inputs, cycle.now, &mut ());
    }
    recorder.flush();
    if std::env::var_os("BLESS").is_some() {
        fs::write(&file, recorder.record()).expect("the record is written");
    }
    assert!(fs::read(&file).expect("the record") == recorder.record(), "the record is of another layout");
}
