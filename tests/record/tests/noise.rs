//! Any bytes, also with check sums that are right: nothing panics, and no chart is made that cannot be.

use grafcet::record::wire::{Follow, Wire, frame_len, wire_len};
use grafcet::record::{Recordable, Recorder, Records, replay, restore, snapshot, snapshot_len};
use grafcet_record::cell::Cell;
use grafcet_record::recipe::Dyer;
use grafcet_record::tickless::Crossing;
use grafcet_record::{Chance, Nobody, Storm};

/// CRC-32C, bit by bit.
fn check(bytes: &[u8]) -> [u8; 4] {
    let step = |sum: u32| if sum & 1 == 0 { sum >> 1 } else { sum >> 1 ^ 0x82f6_3b78 };
    let byte = |sum: u32, byte: &u8| (0..8).fold(sum ^ u32::from(*byte), |sum, _| step(sum));
    (!bytes.iter().fold(u32::MAX, byte)).to_le_bytes()
}

/// The same with a few other bits, bytes or lengths.
fn spoilt(bytes: &[u8], chance: &mut Chance) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    for _ in 0..=chance.below(4) {
        let place = chance.below(u32::try_from(bytes.len()).unwrap_or(1)) as usize;
        match chance.below(6) {
            0 => bytes.truncate(place.max(1)),
            1 => bytes.insert(place, chance.number().to_le_bytes()[0]),
            2 => bytes[place] = chance.number().to_le_bytes()[0],
            3 => bytes[place] = 0xff,
            _ => bytes[place] ^= 1 << chance.below(8),
        }
    }
    bytes
}

/// A frame of this content.
fn frame(content: &[u8]) -> Vec<u8> {
    let mut frame = Vec::new();
    let whole = [content, &check(content)].concat();
    for part in whole.split(|byte| *byte == 0) {
        let mut parts = part.chunks(254).peekable();
        if part.is_empty() {
            frame.push(1);
        }
        while let Some(chunk) = parts.next() {
            frame.push(u8::try_from(chunk.len() + 1).expect("at most 255"));
            frame.extend(chunk);
            if chunk.len() == 254 && parts.peek().is_none() {
                frame.push(1);
            }
        }
    }
    frame.push(0);
    frame
}

/// The content of a frame.
fn content(frame: &[u8]) -> Option<Vec<u8>> {
    let (mut content, mut rest) = (Vec::new(), frame.strip_suffix(&[0])?);
    while let Some((len, after)) = rest.split_first() {
        let (part, after) = after.split_at_checked(usize::from(*len) - 1)?;
        content.extend(part);
        if *len < 255 && !after.is_empty() {
            content.push(0);
        }
        rest = after;
    }
    content.truncate(content.len().checked_sub(4)?);
    Some(content)
}

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
