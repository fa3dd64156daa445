//! `else`: the branch that is taken where none of the others is.

use std::cell::Cell;

use grafcet::grafcet;

thread_local! {
    static ASKED: Cell<u32> = const { Cell::new(0) };
}

/// True every other time, and counts how often it is asked.
fn toggle(_branch: u8) -> bool {
    ASKED.with(|asked| {
        asked.set(asked.get() + 1);
        asked.get() % 2 == 0
    })
}

fn asked() -> u32 {
    ASKED.with(Cell::take)
}

grafcet! {
    /// By priority.
    sfc Ranked {
        input x: bool;
        initial step Start;
        step One;
        step Two;
        step Rest;
        Start -[x && toggle(1)]-> One -[true]-> Start;
        Start -[x && !toggle(2)]-> Two -[true]-> Start;
        Start -[rest: else]-> Rest -[true]-> Start;
    }
}

grafcet! {
    /// Nobody can tell whether the conditions exclude each other.
    grafcet Open {
        #![allow(grafcet::overlapping_branches, grafcet::unsafe_step)]
        input x, back: bool;
        initial step Wait;
        step Start;
        step One;
        step Two;
        step Rest;
        Wait -[rising(x)]-> Start;
        Start -[toggle(1)]-> One -[back]-> Wait;
        Start -[!toggle(2)]-> Two -[back]-> Wait;
        Start -[else]-> Rest -[back]-> Wait;
    }
}

#[test]
fn a_function_is_asked_once() {
    let mut chart = Ranked::new();
    let x = RankedInputs { x: true };
    chart.cycle(&x);
    assert_eq!(asked(), 0);
    // The first is false, the second (asked as the second one) is `!true`.
    chart.cycle(&x);
    assert!(chart.is_active(RankedStep::Rest));
    assert_eq!(asked(), 2);
    chart.cycle(&RankedInputs { x: false });
    chart.cycle(&RankedInputs { x: false });
    assert!(chart.is_active(RankedStep::Rest));
    assert_eq!(asked(), 0);
}

#[test]
fn also_where_branches_may_clear_together() {
    let mut chart = Open::new();
    chart.cycle(&OpenInputs::default());
    asked();
    // One evolution asks the two conditions, and no third time for the `else`: false, then `!true`.
    chart.cycle(&OpenInputs { x: true, back: false });
    assert!(chart.is_active(OpenStep::Rest));
    assert_eq!(asked(), 2);
    chart.cycle(&OpenInputs { x: false, back: true });
    // True, then `!false`: both, and not the `else`.
    toggle(0);
    chart.cycle(&OpenInputs { x: true, back: false });
    assert!(chart.is_active(OpenStep::One) && chart.is_active(OpenStep::Two) && !chart.is_active(OpenStep::Rest));
    assert_eq!(asked(), 3);
}

#[test]
fn it_is_drawn_and_described_as_else() {
    use grafcet::Chart;
    let chart = &Ranked::CHART;
    let rest = chart.transitions.iter().find(|transition| transition.name == "rest").expect("the branch");
    assert_eq!(rest.condition, "else");
    assert_eq!(Ranked::TRANSITIONS.len(), chart.transitions.len());
}

grafcet! {
    /// Exclusive by construction: nothing is said of branches that overlap, and `never` is proved.
    #[deny(warnings)]
    grafcet Gate {
        input auto, manual, stop: bool;
        output open, close: bool;
        initial step Idle;
        step Opening { open; }
        step Closing { close; }
        Idle -[auto && !manual && !stop]-> Opening;
        Idle -[manual && !auto && !stop]-> Closing;
        Idle -[else]-> Idle;
        Opening -[stop]-> Idle;
        Opening -[else]-> Opening;
        Closing -[stop]-> Idle;
        never open && close;
        home Idle;
    }
}

#[test]
fn what_excludes_by_construction_is_proved() {
    let mut gate = Gate::new();
    gate.cycle(&GateInputs::default());
    assert_eq!(gate.cycle(&GateInputs { auto: true, manual: true, ..GateInputs::default() }), GateOutputs::default());
    assert!(gate.cycle(&GateInputs { manual: true, ..GateInputs::default() }).close);
}
