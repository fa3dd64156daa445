//! The power goes while a snapshot is written, at any byte: the chart comes back as it was stored last, or the time before.

use grafcet::Ticks;
use grafcet::record::{Recordable, snapshot_len};
use grafcet_record::cell::Cell;
use grafcet_record::fram::{Fram, Places};
use grafcet_record::mixed::Press;
use grafcet_record::{Chance, Storm};

/// An FRAM that takes so many bytes until the power goes; the one that is written then may become anything.
struct Emulated<'m> {
    bytes: &'m mut Vec<u8>,
    left: usize,
    torn: Option<u8>,
}

impl Fram for Emulated<'_> {
    fn read(&mut self, address: usize, to: &mut [u8]) {
        to.copy_from_slice(&self.bytes[address..address + to.len()]);
    }

    fn write(&mut self, address: usize, bytes: &[u8]) {
        let whole = bytes.len().min(self.left);
        self.bytes[address..address + whole].copy_from_slice(&bytes[..whole]);
        self.left -= whole;
        if whole < bytes.len() {
            // Later ones are not written at all.
            if let Some(torn) = self.torn.take() {
                self.bytes[address + whole] = torn;
            }
        }
    }
}

fn comes_back<C: Recordable, const LEN: usize>(chart: &C, actions: &mut C::Actions<'_>) {
    assert_eq!(LEN, snapshot_len::<C>());
    let mut chance = Chance::new(3);
    let mut last_ones = 0;
    // Fresh memory holds anything.
    let mut memory: Vec<u8> =
        (0..Places::<Emulated<'_>, LEN>::BYTES + 5).map(|_| chance.number().to_le_bytes()[0]).collect();
    let mut stored: [Option<C>; 2] = [None, None];
    let mut storm = Storm::<C::Inputs>::new(5);
    let mut now = Ticks::ZERO;
    for _ in 0..3_000 {
        // So many bytes are written in a whole store, in three parts.
        let whole = 8 + LEN + 8;
        let left = chance.below(u32::try_from(5 * whole).expect("short")) as usize;
        let fram = Emulated { bytes: &mut memory, left, torn: Some(chance.number().to_le_bytes()[0]) };
        let (mut places, found) = Places::<_, LEN>::open::<C>(fram, 5, now);
        match (&found, &stored) {
            (Some(found), [_, Some(last)]) if found.is_same_state(last) => last_ones += 1,
            (Some(found), [Some(before), _]) if found.is_same_state(before) => {}
            // Not even one has been stored whole.
            (None, [None, _]) => {}
            _ => panic!("{}: neither the last one nor the one before comes back", C::NAME),
        }
        let mut current = found.clone().unwrap_or_else(|| chart.clone());
        stored = [found.clone(), found];
        for store in 1..=5 {
            for _ in 0..chance.below(5) {
                let (inputs, then) = storm.cycle();
                current.scan(&inputs, then, actions);
                now = then;
            }
            places.store(&current);
            // In the one that the power has cut short nobody knows which of both it is.
            let is_cut = store * whole > left;
            stored = if is_cut {
                [stored[1].take(), Some(current.clone())]
            } else {
                [Some(current.clone()), Some(current.clone())]
            };
            if is_cut {
                break;
            }
        }
    }
    assert!(last_ones > 300, "{}: {last_ones}", C::NAME);
}

#[test]
fn a_chart_comes_back() {
    comes_back::<Cell, { snapshot_len::<Cell>() }>(&Cell::new(), &mut ());
    comes_back::<Press, { snapshot_len::<Press>() }>(&Press::new(), &mut ());
}
