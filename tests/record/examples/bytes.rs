//! How many bytes the record of each example takes, in a storm of inputs of which one bit changes every fourth cycle: `cargo run -p grafcet-record --example bytes`.

use grafcet::record::{Happened, Recordable, Recorder, Records};
use grafcet_record::branch_on_result::Sorter;
use grafcet_record::cell::Cell;
use grafcet_record::controller::{Called, Remote};
use grafcet_record::line24v::Line24V;
use grafcet_record::motor::Motor;
use grafcet_record::pick_and_place::PickAndPlace;
use grafcet_record::recipe::Dyer;
use grafcet_record::stroke::Press;
use grafcet_record::tickless::Crossing;
use grafcet_record::{Nobody, Storm};

const CYCLES: u32 = 4_000;

/// After the last byte that is not zero.
fn used(record: &[u8]) -> usize {
    record.iter().rposition(|byte| *byte != 0).map_or(0, |last| last + 1)
}

fn measure<C: Recordable>(chart: C, actions: &mut C::Actions<'_>) {
    // So long that all of it stands in the first block.
    let mut recorder = Recorder::new(chart, vec![0; 500_000]).expect("enough memory");
    let begin = used(recorder.record());
    let mut storm = Storm::<C::Inputs>::new(1);
    for _ in 0..CYCLES {
        let (inputs, now) = storm.cycle();
        recorder.cycle(&inputs, now, actions);
    }
    let bytes = used(recorder.record()) - begin;
    let records = Records::of(recorder.record()).expect("a record");
    let entries = records.blocks().flat_map(|block| block.expect("a block").entries());
    let written =
        entries.filter(|entry| matches!(entry, Ok(entry) if matches!(entry.what, Happened::Cycle { .. }))).count();
    let (inputs, state) = (<C::Inputs as grafcet::record::Record>::BITS, C::STATE_BITS + C::PARAM_BITS);
    let per = |bytes: usize, count: usize| {
        f64::from(u32::try_from(bytes).unwrap_or(0)) / f64::from(u32::try_from(count).unwrap_or(1))
    };
    println!(
        "| {} | {inputs} | {state} | {written} of {CYCLES} | {:.1} | {:.1} |",
        C::NAME,
        per(bytes, written),
        per(bytes, CYCLES as usize)
    );
}

fn main() {
    println!("| chart | bits of inputs | bits of state and recipe | cycles written | bytes each | bytes per cycle |");
    println!("| --- | --- | --- | --- | --- | --- |");
    measure(Motor::new(), &mut ());
    measure(Line24V::new(), &mut ());
    measure(Sorter::new(), &mut ());
    measure(Cell::new(), &mut ());
    measure(Crossing::new(), &mut ());
    measure(Press::new(), &mut ());
    measure(PickAndPlace::new(), &mut ());
    measure(Dyer::new(), &mut Nobody);
    measure(Called::new(), &mut Nobody);
    measure(Remote::new(), &mut Nobody);
}
