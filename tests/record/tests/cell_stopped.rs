//! Written from a record: `Cell` does again what it did when it was recorded.

use grafcet_sim::{Chart, Replay};

#[test]
fn cell_stopped() {
    let chart = Chart::in_file(include_str!("../../../examples/charts/cell.rs"), "Cell").expect("the chart");
    let (record, expected) = (include_bytes!("cell_stopped.record"), include_str!("cell_stopped.expected"));
    if let Err(changed) = Replay::new().compare(&chart, record, expected) {
        panic!("{changed}");
    }
}
