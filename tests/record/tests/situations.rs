//! Which situations `restore` and `force` take: those that a chart comes to and, where the compiler finds all of them, no others.

use std::collections::BTreeSet;

use grafcet::record::{Recordable, restore, snapshot, snapshot_len};
use grafcet::{Chart, ForceError, Ticks, grafcet};
use grafcet_record::branch_on_result::{Sorter, SorterParams};
use grafcet_record::cell::Cell;
use grafcet_record::controller::{Called, Remote};
use grafcet_record::line24v::Line24V;
use grafcet_record::mixed::{Flags, Press, PressParams};
use grafcet_record::motor::Motor;
use grafcet_record::pick_and_place::PickAndPlace;
use grafcet_record::recipe::{self, Dyer};
use grafcet_record::stroke;
use grafcet_record::tickless::Crossing;
use grafcet_record::{Chance, Nobody, Storm};

/// The active steps, a bit for each.
fn set<C: Chart>(chart: &C) -> u32 {
    (0..C::STEPS.len()).filter(|step| chart.is_active(C::STEPS[*step])).map(|step| 1 << step).sum()
}

/// The situations to which storms of inputs lead, with what is restored of each.
fn reached<C: Recordable>(chart: &C, actions: &mut C::Actions<'_>, seeds: u64) -> BTreeSet<u32> {
    let mut found = BTreeSet::new();
    for seed in 0..seeds {
        let (mut chart, mut storm) = (chart.clone(), Storm::<C::Inputs>::new(seed));
        for _ in 0..2_000 {
            let (inputs, now) = storm.cycle();
            chart.scan(&inputs, now, actions);
            if found.insert(set(&chart)) {
                let mut bytes = vec![0; snapshot_len::<C>()];
                snapshot(&chart, &mut bytes).expect("enough bytes");
                let again = restore::<C>(&bytes, Ticks::ZERO).expect("a situation that the chart was in");
                assert_eq!(set(&again), set(&chart));
            }
        }
    }
    found
}

/// All sets of steps that are taken for a situation.
fn taken<C: Recordable>() -> BTreeSet<u32> {
    let steps = C::STEPS.len();
    // A chart of one sequence holds one step and no more, whatever its bits are.
    let is_alone = format!("{:?}", C::POSSIBLE) == "Unknown";
    let allows =
        |set: &u32| C::POSSIBLE.allows(steps, |step| set >> step & 1 != 0) && (!is_alone || set.is_power_of_two());
    (0..1 << steps).filter(allows).collect()
}

fn exact<C: Recordable>(chart: &C, actions: &mut C::Actions<'_>) {
    assert_eq!(taken::<C>(), reached(chart, actions, 40), "{}", C::NAME);
}

/// A recipe by which each length will do.
const ANY: SorterParams = SorterParams { nominal: 0, tolerance: u16::MAX };

/// Every set of steps of every example.
#[test]
fn the_examples_take_exactly_what_they_come_to() {
    exact(&Motor::new(), &mut ());
    exact(&Cell::new(), &mut ());
    exact(&Line24V::new(), &mut ());
    let sorted = [SorterParams::default(), ANY].map(|params| reached(&Sorter::with_params(params), &mut (), 10));
    assert_eq!(taken::<Sorter>(), &sorted[0] | &sorted[1]);
    exact(&Called::new(), &mut Nobody);
    exact(&Remote::new(), &mut Nobody);
    exact(&Crossing::new(), &mut ());
    exact(&stroke::Press::new(), &mut ());
    exact(&PickAndPlace::new(), &mut ());
    exact(&Dyer::with_params(recipe::WOOL), &mut Nobody);
    // Heated before it is closed, as a recipe may have it.
    let slow = PressParams { limit: Ticks::new(60_000) };
    assert_eq!(
        taken::<Press>(),
        &reached(&Press::new(), &mut (), 40) | &reached(&Press::with_params(slow), &mut (), 40)
    );
    exact(&Flags::new(), &mut ());
    exact(&Shared::new(), &mut ());
}

grafcet! {
    /// Two of three at a time may draw their current, and a table turns beside them: 7 times 20 situations.
    grafcet Shared {
        budget 10_000;
        forceable;
        input a, b, c, end, turn: bool;
        partial First { initial step A0; step A1; A0 -[a && !(B1.X && C1.X)]-> A1 -[end && !a]-> A0; }
        partial Second { initial step B0; step B1; B0 -[b && !a && !(A1.X && C1.X)]-> B1 -[end && !b]-> B0; }
        partial Third { initial step C0; step C1; C0 -[c && !a && !b && !(A1.X && B1.X)]-> C1 -[end && !c]-> C0; }
        partial Table {
            initial step T0; step T1; step T2; step T3; step T4; step T5; step T6; step T7; step T8; step T9;
            T0 -[rising(turn)]-> T1 -[rising(turn)]-> T2 -[rising(turn)]-> T3 -[rising(turn)]-> T4 -[rising(turn)]-> T5;
            T5 -[rising(turn)]-> T6 -[rising(turn)]-> T7 -[rising(turn)]-> T8 -[rising(turn)]-> T9 -[rising(turn)]-> T0;
        }
        partial Counter {
            initial step N0; step N1;
            N0 -[rising(turn) && T9.X]-> N1 -[rising(turn) && T9.X]-> N0;
        }
    }
}

#[test]
fn three_that_exclude_each_other_and_no_two_of_them() {
    use SharedStep::{A0, A1, B0, B1, C0, C1, N0, T4};
    assert_eq!(taken::<Shared>().len(), 7 * 20, "{:?}", Shared::POSSIBLE);
    let mut shared = Shared::new();
    let none = SharedInputs::default();
    for (situation, refused) in [
        (&[A1, B1, C0, T4, N0][..], None),
        (&[A1, B0, C1, T4, N0], None),
        (&[A0, B1, C1, T4, N0], None),
        (&[A1, B1, C1, T4, N0], Some(ForceError::NoSituation)),
        (&[A1, B1, T4, N0], Some(ForceError::NoSituation)),
        (&[A1, B1, B0, C0, T4, N0], Some(ForceError::NeverTogether(B1, B0))),
    ] {
        let before = shared.situation();
        assert_eq!(shared.force(situation, &none).err(), refused, "{situation:?}");
        assert!(refused.is_none() && shared.is_exactly(situation) || shared.situation() == before);
    }
}

grafcet! {
    /// More situations than anybody counts: an order that empties, one that holds, enclosed grafcets two deep, parallel branches, edges.
    grafcet Plant {
        forceable;
        input estop, ack, auto, p1, p2, p3, q1, q2, q3, r1, r2: bool;
        input s1, s2, s3, s4, s5, s6: bool;
        input level: i16;
        output a1, a2, b1, b2, alarm: bool;
        partial Guard {
            initial step Well;
            step Tripped { alarm; force Front {}; force Middle {INIT}; }
            step Hold { force Middle {*}; }
            Well -[estop]-> Tripped -[!estop && ack]-> Hold -[1s/Hold]-> Well;
        }
        partial Front {
            initial step F0;
            step F1 { a1; }
            step F2 { a2; }
            enclosing step F3 {
                partial Inner {
                    linked step I0;
                    step I1;
                    enclosing step I2 {
                        partial Deep { linked step D0; step D1 { b1; } D0 -[q1]-> D1 -[!q1 && 200ms/D1]-> D0; }
                    }
                    I0 -[p1]-> I1 -[p2]-> I2 -[p3]-> I0;
                }
            }
            F0 -[auto]-> F1 -[p1 && Middle::M0.X]-> F2 -[p2]-> F3 -[!auto && rising(p3)]-> F0;
            () -[rising(ack) && !F0.X && !F1.X && !F2.X && !F3.X && !estop]-> F0;
        }
        partial Middle {
            initial step M0;
            step M1 { b2; } step M2; step M3; step M4; step M5;
            M0 -[q1]-> (M1, M3);
            M1 -[q2]-> M2;
            M3 -[r1 && level < 200]-> M4 -[r2 || 2s/M4]-> M5;
            (M2, M5) -[q3]-> M0;
        }
        partial Tail {
            initial step T0; step T1; step T2; step T3;
            T0 -[Middle::M2.X && r1]-> T1 -[r2 && s1]-> T2 -[!r1 && s2]-> T3 -[falling(r2) || s3 && s4]-> T0;
        }
        partial Last {
            initial step L0; step L1; step L2; step L3;
            L0 -[s1 && !s6]-> L1 -[s2 && s3]-> L2 -[s4 != s5]-> L3 -[s6 && r1]-> L0;
        }
    }
}

/// Nothing that it comes to is refused, by itself and by hand; and of what it does not come to, what its pieces tell.
#[test]
fn pieces_of_a_large_chart_are_looked_at_for_themselves() {
    use PlantStep::{D0, F0, F1, F3, I0, I1, I2, L0, M0, M1, M2, M3, M5, T0, Tripped, Well};
    assert!(format!("{:?}", Plant::POSSIBLE).starts_with("Parts"), "{:?}", Plant::POSSIBLE);
    let came = reached(&Plant::new(), &mut (), 100);
    assert!(came.len() > 300, "{}", came.len());
    let none = PlantInputs::default();
    let (mut plant, mut chance, mut storm) = (Plant::new(), Chance::new(3), Storm::<PlantInputs>::new(77));
    let all: Vec<u32> = came.iter().copied().collect();
    for _ in 0..3_000 {
        let situation = all[chance.below(u32::try_from(all.len()).expect("few")) as usize];
        let steps: Vec<PlantStep> =
            (0..26).filter(|step| situation >> step & 1 != 0).map(|step| Plant::STEPS[step]).collect();
        let (inputs, now) = storm.cycle();
        plant.force(&steps, &inputs, now).expect("it has been there");
        for _ in 0..5 {
            let (inputs, now) = storm.cycle();
            plant.cycle(&inputs, now);
            assert!(Plant::POSSIBLE.allows(Plant::STEPS.len(), |step| plant.is_active(Plant::STEPS[step])));
        }
    }
    let forced = |steps: &[PlantStep]| Plant::new().force(steps, &none, 0_u32).map(drop);
    assert_eq!(forced(&[Well, F3, I2, D0, M2, M5, T0, L0]), Ok(()));
    for (missing, steps) in [
        ("a parallel branch", &[Well, F0, M1, T0, L0][..]),
        ("what encloses", &[Well, F0, I1, M0, T0, L0]),
        ("what is enclosed", &[Well, F3, M0, T0, L0]),
        ("what is enclosed two deep", &[Well, F3, I2, M0, T0, L0]),
        ("one of those in the middle", &[Well, F3, D0, M0, T0, L0]),
        ("a whole grafcet", &[Well, F0, M1, M3, L0]),
    ] {
        assert_eq!(forced(steps), Err(ForceError::NoSituation), "without {missing}");
    }
    assert_eq!(forced(&[Tripped, F1, M0, T0, L0]), Err(ForceError::NeverTogether(Tripped, F1)));
    assert_eq!(forced(&[Well, F3, I0, I1, M0, T0, L0]), Err(ForceError::NeverTogether(I0, I1)));
}

grafcet! {
    /// An order that comes in the middle of a search.
    grafcet Held {
        budget 20;
        input go, back, keep: bool;
        input w1, w2, w3, w4, w5: bool;
        partial Guard {
            initial step G0;
            step G1 { force Main {*}; }
            G0 -[Main::B.X && keep]-> G1 -[back && !keep]-> G0;
        }
        partial Main {
            initial step A; step B; step C; step E;
            A -[go && !back]-> B -[!back]-> C -[!go]-> A;
            // From where it is held alone; without that the checker would take it for dead.
            B -[back]-> E -[!back && !go]-> A;
        }
        partial Wide {
            initial step W0; step W1; step W2; step W3; step W4; step W5;
            W0 -[w1]-> W1 -[w2]-> W2 -[w3]-> W3 -[w4 && !w1]-> W4 -[w5]-> W5 -[!w5 && w1]-> W0;
        }
    }
}

/// What a piece comes to alone is not all: an order stops it on its way, and from there it goes on.
#[test]
fn an_order_holds_a_piece_on_its_way() {
    assert!(format!("{:?}", Held::POSSIBLE).starts_with("Parts"), "{:?}", Held::POSSIBLE);
    let came = reached(&Held::new(), &mut (), 100);
    let place = |step: HeldStep| 1_u32 << Held::STEPS.iter().position(|other| *other == step).expect("a step");
    let has = |one: HeldStep, other: HeldStep| came.iter().any(|set| set & place(one) != 0 && set & place(other) != 0);
    assert!(has(HeldStep::B, HeldStep::G1), "held on its way");
    assert!(has(HeldStep::E, HeldStep::G0), "gone on from there");
}
