//! How often a condition that calls a function with a state asks it: once in an evolution.

use core::cell::Cell;

use grafcet::grafcet;

thread_local! {
    static ASKED: Cell<u32> = const { Cell::new(0) };
}

fn pressed() -> bool {
    ASKED.with(|asked| asked.set(asked.get() + 1));
    false
}

/// How often it was asked meanwhile.
fn asked(cycle: impl FnOnce()) -> u32 {
    let before = ASKED.with(Cell::get);
    cycle();
    ASKED.with(Cell::get) - before
}

grafcet! {
    sfc Sequence {
        input go: bool;
        output run: bool;
        initial step Idle;
        step Run { run; }
        Idle -[go]-> Run -[!go]-> Idle;
        any -[pressed()]-> Idle;
    }
}

grafcet! {
    sfc Otherwise {
        input go: bool;
        output run: bool;
        initial step Idle;
        step Run { run; }
        step Slow;
        Idle -[pressed()]-> Run -[!go]-> Idle;
        Idle -[else]-> Slow -[go]-> Idle;
    }
}

grafcet! {
    grafcet Joined {
        #![allow(grafcet::overlapping_branches)]
        input go: bool;
        output run: bool;
        initial step Left;
        initial step Right;
        step Run { run; }
        step Slow;
        (Left, Right) -[go && pressed()]-> Run -[!go]-> (Left, Right);
        (Left, Right) -[else]-> Slow -[rising(go)]-> (Left, Right);
    }
}

#[test]
fn an_any_of_a_sequence_asks_in_the_active_step() {
    let mut chart = Sequence::new();
    chart.cycle(&SequenceInputs { go: false });
    chart.cycle(&SequenceInputs { go: true });
    assert_eq!(asked(|| _ = chart.cycle(&SequenceInputs { go: true })), 1);
}

#[test]
fn an_else_does_not_ask_again() {
    let mut chart = Otherwise::new();
    chart.cycle(&OtherwiseInputs { go: false });
    assert_eq!(asked(|| _ = chart.cycle(&OtherwiseInputs { go: false })), 1);
    let mut chart = Joined::new();
    chart.cycle(&JoinedInputs { go: false });
    // From `Slow` back, the branch is tried once, and to `Slow` again.
    assert_eq!(asked(|| _ = chart.cycle(&JoinedInputs { go: true })), 1);
}
