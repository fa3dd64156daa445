//! The example `pick_and_place` as a closed loop under random choices and faults: what is proved of it is seen.

#[path = "../examples/pick_and_place.rs"]
#[allow(dead_code, reason = "the rest is for people")]
pub mod pick_and_place_example;

use pick_and_place_example::pick_and_place::{ArmStep, BeltStep, JawStep, PickAndPlaceStep, TowerStep};
use pick_and_place_example::{Free, Loop};

/// Numbers that look like chance.
struct Chance(u32);

impl Chance {
    fn of(&mut self, percent: u32) -> bool {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (self.0 >> 16) % 100 < percent
    }
}

/// Nothing collides.
fn is_safe(all: &Loop, belt: bool, dip: bool) -> bool {
    let (tower, arm) = (all.tower.situation(), all.arm.situation());
    let moves = matches!(arm, ArmStep::Going | ArmStep::Coming);
    let carries = all.cell.situation() == PickAndPlaceStep::Carry;
    let collisions = [
        tower != TowerStep::Top && moves,
        all.jaw.situation() == JawStep::Open && carries,
        tower == TowerStep::Bottom && belt,
        all.belt.situation() == BeltStep::Moving && dip,
    ];
    !collisions.contains(&true)
}

#[test]
fn what_is_proved_is_seen() {
    let mut chance = Chance(3);
    let (mut dones, mut alarms, mut stuck) = (0, 0, 0);
    let mut all = Loop::new();
    let mut asked = None;
    for cycle in 0..20_000 {
        let mut free = Free::default();
        free.line.part_wanted = chance.of(50);
        free.belt.early_moving = chance.of(30);
        (free.tower.early_going, free.tower.early_coming) = (chance.of(30), chance.of(30));
        (free.arm.early_going, free.arm.early_coming) = (chance.of(30), chance.of(30));
        // Now and then nothing is well for a while.
        let faulty = cycle / 500 % 2 == 1;
        free.tower.jammed = faulty && chance.of(60);
        free.jaw.empty = faulty && chance.of(60);
        let (inputs, outputs) = all.cycle(free);
        assert!(is_safe(&all, outputs.belt, outputs.dip), "in cycle {cycle}");
        let answered = outputs.done || outputs.alarm;
        asked = (inputs.start && !answered).then(|| asked.unwrap_or(cycle));
        assert!(
            asked.is_none_or(|since| cycle - since < 40),
            "asked for in cycle {asked:?}, and not answered within 20 s"
        );
        dones += u32::from(outputs.done);
        alarms += u32::from(outputs.alarm);
        stuck += u32::from(all.cell.situation() == PickAndPlaceStep::Jam);
    }
    assert!(dones > 500 && alarms > 100 && stuck > 10, "{dones} {alarms} {stuck}");
}
