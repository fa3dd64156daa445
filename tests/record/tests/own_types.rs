//! Inputs, variables and parameters of the program's own types in a record: through `serde`, and enums whose variants a chart lists.

use grafcet::record::{
    Damage, Reader, Record, Recordable, Recorder, Records, ReplayError, Writer, postcard_len, replay, restore,
    snapshot, snapshot_len,
};
use grafcet::{grafcet, recordable};
use serde::{Deserialize, Serialize};

/// What a crane shall do.
#[derive(Clone, Copy, Default, PartialEq, Debug, Serialize, Deserialize)]
enum Order {
    #[default]
    None,
    Move {
        to: i16,
        speed: u8,
    },
    Load(f32),
}

// A byte for the variant; three for an `i16` and one for a `u8`, or four for an `f32`.
recordable! { Order as serde in 5 bytes }

/// No `Record`, no `serde`: the chart lists its variants.
#[derive(Clone, Copy, Default, PartialEq, Debug)]
enum Mode {
    #[default]
    Off,
    Auto,
    Manual,
}

grafcet! {
    /// A crane that keeps the order it works on, and how it came to it.
    #[derive(Debug, PartialEq)]
    sfc Crane {
        input order: Order;
        input mode: Mode in {Manual, Off, Auto};
        output up, left: bool;
        var held: Order = Order::None;
        var by: Mode in {Manual, Off, Auto} = Mode::Auto;
        param kept: Mode in {Manual, Off, Auto} = Mode::Manual;
        initial step Wait { P1 held = Order::None; }
        step Work { P1 held = order; P1 by = mode; N up if matches!(held, Order::Load(_)); }
        step By { N left if by == kept; }
        Wait -[mode != Mode::Off && order != Order::None]-> Work -[order != held]-> By -[mode == Mode::Off]-> Wait;
    }
}

const ORDERS: [Order; 5] = [
    Order::None,
    Order::Move { to: i16::MIN, speed: 255 },
    Order::Move { to: 3, speed: 0 },
    Order::Load(-0.0),
    Order::Load(f32::MAX),
];

/// Some sequence in which everything comes to pass.
fn inputs() -> impl Iterator<Item = CraneInputs> {
    let modes = [Mode::Off, Mode::Auto, Mode::Off, Mode::Manual];
    (0_usize..600)
        .map(move |cycle| CraneInputs { order: ORDERS[cycle / 3 % 7 % ORDERS.len()], mode: modes[cycle / 5 % 11 % 4] })
}

#[test]
fn what_serde_writes_is_recorded_and_replayed() {
    for memory in [100_000, 700] {
        let mut recorder = Recorder::new(Crane::new(), vec![0; memory]).expect("enough memory");
        let mut chart = Crane::new();
        let mut expected = Vec::new();
        for inputs in inputs() {
            recorder.cycle(&inputs, 0_u32, &mut ());
            let outputs = chart.cycle(&inputs);
            expected.push((inputs, outputs, chart.situation()));
        }
        recorder.flush();
        let records = Records::of(recorder.record()).expect("a record");
        let (mut shown, mut lifted, mut left) = (0, 0, 0);
        let replayed = replay::<Crane>(&records, &mut (), |moment| {
            let (inputs, outputs, situation) = expected[moment.cycle as usize];
            assert_eq!((*moment.inputs, moment.outputs), (inputs, outputs), "cycle {}", moment.cycle);
            assert_eq!(moment.chart.situation(), situation, "cycle {}", moment.cycle);
            shown += 1;
            lifted += u32::from(outputs.up);
            left += u32::from(outputs.left);
        });
        assert_eq!(replayed, Ok(()));
        assert!(shown > 20, "{shown}");
        assert!(memory < 1_000 || lifted > 3 && left > 3, "{lifted} {left}");
    }
}

#[test]
fn a_snapshot_has_them_too() {
    let mut chart = Crane::new();
    let mut bytes = [0; snapshot_len::<Crane>()];
    for inputs in inputs() {
        chart.cycle(&inputs);
        snapshot(&chart, &mut bytes).expect("as many bytes as it takes");
        let mut again: Crane = restore(&bytes, 0).expect("what was written");
        assert!(again.is_same_state(&chart));
        assert_eq!(again.cycle(&inputs), chart.clone().cycle(&inputs));
    }
}

fn written<T: Record>(value: &T) -> Vec<u8> {
    let mut bytes = vec![0; T::BITS.div_ceil(8)];
    value.write(&mut Writer::new(&mut bytes));
    bytes
}

#[test]
fn a_value_takes_a_bit_and_its_bytes() {
    assert_eq!(Order::BITS, 41);
    for order in ORDERS {
        let read = Order::read(&mut Reader::new(&written(&order))).expect("what was written");
        assert!(order.is_same(&read), "{order:?} {read:?}");
        assert!(postcard_len(&order).is_some_and(|len| len <= 5), "{order:?}");
    }
    assert_eq!(ORDERS.map(|order| postcard_len(&order)).into_iter().max(), Some(Some(5)));
    // They are equal, and something else.
    assert!(!Order::Load(0.0).is_same(&Order::Load(-0.0)));
    assert!(Order::Load(f32::NAN).is_same(&Order::Load(f32::NAN)));
    // It fits (1), the variant (1), `to` in zigzag (6), `speed` (7).
    let bits = |bytes: &[u8]| Order::read(&mut Reader::new(bytes));
    let put = |values: &[(u32, usize)]| {
        let mut bytes = [0; 6];
        let mut writer = Writer::new(&mut bytes);
        for (value, width) in values {
            writer.put(*value, *width);
        }
        bytes
    };
    assert_eq!(bits(&put(&[(1, 1), (1, 8), (6, 8), (7, 8)])), Some(Order::Move { to: 3, speed: 7 }));
    // The same number in two bytes is not what is written.
    assert_eq!(bits(&put(&[(1, 1), (1, 8), (0x86, 8), (0, 8), (7, 8)])), None);
    // No such variant, something after the value, nothing.
    assert_eq!(bits(&put(&[(1, 1), (3, 8)])), None);
    assert_eq!(bits(&put(&[(1, 1), (0, 8), (1, 8)])), None);
    assert_eq!(bits(&[0; 6]), None);
    assert_eq!(bits(&[1, 0]), None);
}

#[derive(Clone, Copy, Default, PartialEq, Debug, Serialize, Deserialize)]
struct Wide(u16);

// Enough up to 127 alone.
recordable! { Wide as serde in 1 bytes }

grafcet! {
    sfc Narrow {
        input level: Wide;
        output full: bool;
        initial step Low;
        step High { N full; }
        Low -[level.0 > 100]-> High -[level.0 < 50]-> Low;
    }
}

#[test]
fn a_value_that_does_not_fit_is_not_shown_as_another() {
    let mut recorder = Recorder::new(Narrow::new(), vec![0; 5_000]).expect("enough memory");
    for level in [0, 101, 40, 127, 128, 128, 300, 40] {
        recorder.cycle(&NarrowInputs { level: Wide(level) }, 0_u32, &mut ());
    }
    recorder.flush();
    let records = Records::of(recorder.record()).expect("a record");
    let mut shown = Vec::new();
    let replayed = replay::<Narrow>(&records, &mut (), |moment| shown.push(moment.inputs.level.0));
    assert_eq!(replayed, Err(ReplayError::Damage(Damage::Nonsense)));
    assert_eq!(shown, [0, 101, 40, 127]);
}

/// The bits follow from the chart, which lists the variants in another order than the enum.
#[test]
fn listed_variants_are_numbered_as_the_chart_lists_them() {
    let number = |mode| {
        let bytes = written(&CraneInputs { order: Order::None, mode });
        // After the 41 bits of the order.
        bytes[5] >> 1
    };
    assert_eq!([Mode::Manual, Mode::Off, Mode::Auto].map(number), [0, 1, 2]);
    assert_eq!(CraneInputs::BITS, 43);
    let mut bytes = written(&CraneInputs::default());
    bytes[5] |= 0b110;
    assert_eq!(CraneInputs::read(&mut Reader::new(&bytes)), None, "there is no fourth variant");
}

/// What rustc says where a type can be recorded in no way.
#[test]
fn messages() {
    trybuild::TestCases::new().compile_fail("tests/refused/*.rs");
}
