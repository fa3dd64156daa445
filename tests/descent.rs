//! Partial grafcets one above another that evolve in place: what is decided above shows below in the same evolution, and nothing
//! below clears or acts any more.

use grafcet::grafcet;

grafcet! {
    /// One above the other: a transition above jumps after all that is below.
    grafcet Tower {
        input stop, go, on, inner: bool;
        output clamp, busy: bool;
        output parts, left: u8;

        partial Safety {
            initial step Ready;
            step Stopped { force Modes {}; }
            step Restart { force Modes {INIT}; }
            Ready -[stop]-> Stopped -[!stop && go]-> Restart -[true]-> Ready;
        }
        partial Modes {
            initial step Manual { R clamp; }
            enclosing step Auto {
                partial Work {
                    linked step Feed;
                    step Close { S clamp; busy; P0 left = (left + 1) % 100; }
                    step Count { P1 parts = parts.wrapping_add(1); }
                    Feed -[inner]-> Close -[!inner]-> Count -[inner]-> Feed;
                }
            }
            Manual -[on && rising(on)]-> Auto -[!on]-> Manual;
        }
    }
}

const NOTHING: TowerInputs = TowerInputs { stop: false, go: false, on: false, inner: false };

fn automatic() -> Tower {
    let mut tower = Tower::new();
    tower.cycle(&NOTHING);
    tower.cycle(&TowerInputs { on: true, ..NOTHING });
    assert!(tower.is_active(TowerStep::Auto) && tower.is_active(TowerStep::Feed));
    tower
}

#[test]
fn a17_what_an_enclosing_step_brings_along_clears_in_the_next_evolution() {
    let mut tower = Tower::new();
    tower.cycle(&NOTHING);
    // Entered with `inner`, the search goes on to `Close`, one evolution later.
    let outputs = tower.cycle(&TowerInputs { on: true, inner: true, ..NOTHING });
    assert!(tower.is_active(TowerStep::Close) && outputs.clamp && outputs.busy);
}

#[test]
fn a19_where_the_outer_step_is_left_the_inner_transition_neither_clears_nor_acts() {
    let mut tower = automatic();
    let outputs = tower.cycle(&TowerInputs { inner: true, ..NOTHING });
    assert!(tower.is_active(TowerStep::Manual) && !tower.is_active(TowerStep::Close));
    assert!(!outputs.clamp, "`Close` was never entered");
    assert_eq!(outputs.left, 0);
}

#[test]
fn a12_actions_on_what_is_forced_away_run_where_the_order_is_given() {
    let mut tower = automatic();
    let outputs = tower.cycle(&TowerInputs { on: true, inner: true, ..NOTHING });
    assert!(outputs.clamp && outputs.left == 0);
    let outputs = tower.cycle(&TowerInputs { on: true, inner: false, stop: true, ..NOTHING });
    assert!(tower.is_active(TowerStep::Stopped) && !tower.is_active(TowerStep::Auto));
    assert_eq!((outputs.left, outputs.parts), (1, 0), "`Close` is left by force, `Count` is not entered");
    assert!(outputs.clamp, "nothing has let go");
    let outputs = tower.cycle(&TowerInputs { on: true, go: true, ..NOTHING });
    assert!(tower.is_active(TowerStep::Ready) && tower.is_active(TowerStep::Manual));
    assert!(!outputs.clamp, "`Manual` was entered by force");
}

grafcet! {
    /// A partial grafcet with two above it, one of them beside another: what has been decided is noted.
    grafcet Plant {
        input stop, hold, a, b: bool;
        output steps: u16;
        output others: u16;

        partial Above {
            initial step Free;
            step Fork;
            step Left;
            step Right;
            step Held { force Below {*}; }
            step Off { force Below {}; force Beside {INIT}; }
            Free -[hold]-> Held -[!hold]-> Free;
            Free -[stop && !hold]-> Off -[!stop]-> Fork -[true]-> (Left, Right);
            (Left, Right) -[true]-> Free;
        }
        partial Below {
            initial step One { P1 steps = steps.wrapping_add(1); }
            step Two { P1 steps = steps.wrapping_add(1); }
            One -[a]-> Two -[!a]-> One;
        }
        partial Beside {
            initial step Here;
            step There { P1 others = others.wrapping_add(1); }
            Here -[b]-> There -[!b]-> Here;
        }
    }
}

const IDLE: PlantInputs = PlantInputs { stop: false, hold: false, a: false, b: false };

#[test]
fn a13_a_held_partial_grafcet_clears_nothing_in_the_evolution_in_which_the_order_comes() {
    let mut plant = Plant::new();
    assert_eq!(plant.cycle(&IDLE).steps, 1);
    let outputs = plant.cycle(&PlantInputs { hold: true, a: true, b: true, ..IDLE });
    assert!(plant.is_active(PlantStep::One) && outputs.steps == 1, "held");
    assert!(plant.is_active(PlantStep::There) && outputs.others == 1, "nobody holds this one");
    let outputs = plant.cycle(&PlantInputs { a: true, b: true, ..IDLE });
    assert!(plant.is_active(PlantStep::Two) && outputs.steps == 2, "in the evolution after the end of the order");
}

#[test]
fn a11_a_forced_situation_shows_at_once_and_stays() {
    let mut plant = Plant::new();
    plant.cycle(&PlantInputs { b: true, ..IDLE });
    let outputs = plant.cycle(&PlantInputs { stop: true, a: true, b: true, ..IDLE });
    assert!(plant.is_active(PlantStep::Off) && plant.is_active(PlantStep::Here));
    assert!(!plant.is_active(PlantStep::One) && !plant.is_active(PlantStep::Two));
    assert_eq!((outputs.steps, outputs.others), (1, 1));
    let outputs = plant.cycle(&PlantInputs { a: true, b: true, ..IDLE });
    assert!(plant.is_active(PlantStep::Free) && plant.is_active(PlantStep::There));
    assert_eq!((outputs.steps, outputs.others), (1, 2), "`Below` stays empty");
}
