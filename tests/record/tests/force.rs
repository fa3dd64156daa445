//! A chart that was put into a situation by hand goes through record, replay and snapshot as any other.

use grafcet::record::{Recorder, Records, replay, restore, snapshot, snapshot_len};
use grafcet::{Ticks, grafcet};

grafcet! {
    sfc Oven {
        forceable;
        input start, hot, door: bool;
        output heat, fan, lamp: bool;
        output n: u8;
        initial step Ready { R lamp; }
        step Warm { heat; } step Held { S lamp; D 500ms heat; P1 n = n % 50 + 1; }
        step Blow { fan; } step Still;
        Ready -[start]-> (Warm, Blow);
        Warm -[hot || 9s/Warm]-> Held;
        Blow -[rising(door)]-> Still;
        (Held, Still) -[2s/Held && !start]-> Ready;
    }
}

fn inputs(bits: u32) -> OvenInputs {
    OvenInputs { start: bits & 1 != 0, hot: bits & 2 != 0, door: bits & 4 != 0 }
}

#[test]
fn a_record_goes_on_after_a_cycle_by_hand() {
    use OvenStep::{Blow, Held, Ready, Still, Warm};
    let situations: [&[OvenStep]; 5] = [&[Ready], &[Warm, Blow], &[Warm, Still], &[Held, Blow], &[Held, Still]];
    let mut oven = Recorder::new(Oven::new(), [0; 8192]).expect("enough memory");
    let (mut now, mut chance) = (0_u32, 1_u32);
    let mut shown = Vec::new();
    for cycle in 0..400 {
        chance = chance.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let (bits, which) = (chance >> 24, (chance >> 16) as usize % situations.len());
        now += chance >> 20 & 1023;
        if cycle % 13 == 7 {
            oven.change(|oven| oven.force(situations[which], &inputs(bits), now).map(drop)).expect("a situation");
            // The next cycle takes over, whatever happened while nobody looked.
            now += 1;
        }
        let outputs = oven.cycle(&inputs(bits), now, &mut ());
        shown.push((now, outputs));
    }
    oven.flush();
    let records = Records::of(oven.record()).expect("a record");
    let mut seen = 0;
    replay::<Oven>(&records, &mut (), |moment| {
        let (now, outputs) = &shown[shown.iter().position(|(now, _)| Ticks::new(*now) == moment.now).expect("a cycle")];
        assert_eq!((&moment.outputs, moment.now), (outputs, Ticks::new(*now)));
        seen += 1;
    })
    .expect("the chart does the same again");
    assert!(seen > 200, "{seen}");
}

#[test]
fn a_snapshot_after_a_cycle_by_hand_is_taken() {
    let mut oven = Oven::new();
    oven.cycle(&inputs(0), 0);
    oven.force(&[OvenStep::Held, OvenStep::Still], &inputs(0), 100).expect("a situation");
    let mut bytes = [0; snapshot_len::<Oven>()];
    snapshot(&oven, &mut bytes).expect("enough bytes");
    let mut again: Oven = restore(&bytes, 7).expect("what was written");
    assert!(again.is_exactly(&[OvenStep::Held, OvenStep::Still]));
    assert_eq!(again.next_deadline(), Some(Ticks::new(7)));
    assert!(!again.cycle(&inputs(0), 506).heat);
    assert!(again.cycle(&inputs(0), 507).heat);
}
