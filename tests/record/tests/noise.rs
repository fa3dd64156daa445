//! Any bytes, also with check sums that are right: nothing panics, and no chart is made that cannot be. Those that a fuzzer has found, and others made of them, too.

use std::fs;
use std::path::Path;

use grafcet::record::wire::{Follow, Wire, frame_len, wire_len};
use grafcet::record::{Recordable, Recorder, Records, replay, restore, snapshot, snapshot_len};
use grafcet_record::cell::Cell;
use grafcet_record::fuzz::TARGETS;
use grafcet_record::recipe::Dyer;
use grafcet_record::tickless::Crossing;
use grafcet_record::wrong::{check, content, frame, spoilt};
use grafcet_record::{Chance, Nobody, Storm};

fn is_read<C: Recordable>(chart: &C, actions: &mut C::Actions<'_>) {
    let mut chance = Chance::new(5);
    let wire = Wire::new(Vec::new(), vec![0; wire_len::<C>()]).every(5, 30);
    let mut recorder = Recorder::both(chart.clone(), vec![0; 900], wire).expect("enough memory");
    let mut storm = Storm::<C::Inputs>::new(3);
    for _ in 0..300 {
        let (inputs, now) = storm.cycle();
        recorder.cycle(&inputs, now, actions);
    }
    let (record, sent) = (recorder.keep().0.bytes(), recorder.keep().1.writer());
    let frames: Vec<Vec<u8>> = sent.split_inclusive(|byte| *byte == 0).filter_map(content).collect();
    assert!(frames.len() > 100);
    let intact: Vec<u8> = frames.iter().flat_map(|content| frame(content)).collect();
    assert_eq!(intact, sent[1..], "frames are what they are taken for");
    let mut bytes = vec![0; snapshot_len::<C>()];
    snapshot(recorder.chart(), &mut bytes).expect("enough bytes");
    let mut restored = 0;
    for _ in 0..3_000 {
        if let Ok(records) = Records::of(&spoilt(record, &mut chance)) {
            _ = replay::<C>(&records, actions, |_| {});
        }
        // The values alone are others; the check sum is right.
        let (head, values) = bytes.split_at(12);
        let mut forged = [head, &spoilt(&values[..values.len() - 4], &mut chance)].concat();
        forged.extend(check(&forged));
        if let Ok(mut chart) = restore::<C>(&forged, 7) {
            restored += 1;
            let (inputs, now) = storm.cycle();
            chart.scan(&inputs, now, actions);
        }
    }
    assert!(restored > 30, "{}: {restored}", C::NAME);
    let mut follow = Follow::<C, _>::new(vec![0; frame_len::<C>()]);
    let mut seen = 0;
    for _ in 0..100 {
        for content in &frames {
            let sent = if chance.below(3) == 0 { frame(&spoilt(content, &mut chance)) } else { frame(content) };
            follow.bytes(&sent, actions, |_| seen += 1);
        }
        follow.bytes(&spoilt(sent, &mut chance), actions, |_| seen += 1);
    }
    assert!(seen > 1_000, "{}: {seen}", C::NAME);
}

#[test]
fn any_bytes_are_read_without_panic() {
    is_read(&Cell::new(), &mut ());
    is_read(&Crossing::new(), &mut ());
    is_read(&Dyer::new(), &mut Nobody);
}

/// Of how many inputs made of those of the corpus each target is asked.
const MADE: usize = 80;

/// The corpus of the fuzzer, and inputs made of it.
#[test]
fn the_corpus_finds_nothing() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus");
    for (name, target) in TARGETS {
        let files = fs::read_dir(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
        let mut files: Vec<_> = files.map(|file| file.expect("a file").path()).collect();
        files.sort();
        let corpus: Vec<Vec<u8>> = files.iter().map(|file| fs::read(file).expect("a file")).collect();
        assert!(corpus.len() > 10, "{name}: {} files", corpus.len());
        for bytes in &corpus {
            target(bytes);
        }
        let mut chance = Chance::new(9);
        for _ in 0..MADE {
            let [one, other] =
                [(); 2].map(|()| &corpus[chance.below(u32::try_from(corpus.len()).expect("few")) as usize]);
            let cut = |bytes: &[u8], chance: &mut Chance| {
                chance.below(u32::try_from(bytes.len() + 1).expect("short")) as usize
            };
            let joined = [&one[..cut(one, &mut chance)], &other[cut(other, &mut chance)..]].concat();
            target(&spoilt(&joined, &mut chance));
        }
    }
}
