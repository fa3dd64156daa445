//! `next_deadline` beside Rust whose value nobody can follow.

use core::sync::atomic::{AtomicBool, Ordering};

use grafcet::{Ticks, grafcet};

static PIN: AtomicBool = AtomicBool::new(false);

/// A function that looks at a pin: it may have another value each time.
fn pin() -> bool {
    PIN.load(Ordering::Relaxed)
}

fn high(level: u8) -> bool {
    level > 9
}

/// Equal by its first field alone.
#[derive(Clone, Copy, Default)]
pub struct Reading(u8, u8);

impl PartialEq for Reading {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}

grafcet! {
    /// Each step asks in its own way.
    sfc Asks {
        input go: bool;
        input level: u8;
        input reading: Reading;
        assume pure high;
        output q, r: bool;
        var seen: bool = false;
        var kept: Reading = Reading(0, 0);
        initial step Calm { N q if high(level); N seen = high(level); }
        step Output { N q if pin(); }
        step Value { N seen = pin() || seen; }
        step Kept { N kept = reading; N r if kept.1 > 3 && seen; }
        step Leaves;
        Calm -[go]-> Output -[go]-> Value -[go]-> Kept -[go]-> Leaves -[pin() || 5s/Leaves]-> Calm;
    }
}

grafcet! {
    /// A delay is sampled in every cycle, whatever is active.
    sfc Samples {
        #![allow(grafcet::dead_transition, grafcet::unreachable_step, grafcet::never_true, grafcet::deadlock)]
        output q: bool;
        initial step Here { N q if (5ms/(pin())); }
        step There;
        Here -[false]-> There;
    }
}

grafcet! {
    /// The search looks at the pin in every cycle.
    grafcet Searches {
        output q: bool;
        initial step Here { q if 5s/Here; }
        step There;
        Here -[pin()]-> There -[!pin() && 1s/There]-> Here;
    }
}

#[test]
fn what_may_have_another_value_is_asked_again_at_once() {
    let mut chart = Asks::new();
    let still = AsksInputs { level: 12, ..Default::default() };
    let go = AsksInputs { go: true, ..still };
    let at_once = Some(Ticks::new(7));
    // What is said to be pure, and an assignment that changes nothing, let the chart sleep.
    for _ in 0..3 {
        chart.cycle(&still, 7);
    }
    assert_eq!(chart.next_deadline(), None);
    for step in [AsksStep::Output, AsksStep::Value, AsksStep::Kept, AsksStep::Leaves] {
        chart.cycle(&go, 7);
        for _ in 0..3 {
            chart.cycle(&still, 7);
            assert!(chart.is_active(step));
            assert_eq!(chart.next_deadline(), at_once, "{step}");
        }
    }
}

#[test]
fn a_delay_and_a_search_ask_too() {
    let (mut samples, mut searches) = (Samples::new(), Searches::new());
    for _ in 0..3 {
        samples.cycle(&SamplesInputs {}, 3);
        searches.cycle(&SearchesInputs {}, 3);
    }
    assert_eq!(samples.next_deadline(), Some(Ticks::new(3)));
    assert_eq!(searches.next_deadline(), Some(Ticks::new(3)));
}

grafcet! {
    /// An edge lets a transition clear and forbids none.
    grafcet Helped {
        input a: bool;
        initial step Rest;
        step Wait;
        step Late;
        Rest -[rising(a)]-> Wait -[rising(a) && 5ms/Wait]-> Late -[3ms/Late]-> Rest;
    }
}

grafcet! {
    /// An edge forbids a transition.
    grafcet Hindered {
        input a: bool;
        initial step Rest;
        step Wait;
        Rest -[!rising(a) && a]-> Wait -[5ms/Wait]-> Rest;
    }
}

#[test]
fn an_edge_that_only_lets_clear_leaves_nothing_to_the_next_cycle() {
    let mut helped = Helped::new();
    helped.cycle(&HelpedInputs { a: false }, 0);
    helped.cycle(&HelpedInputs { a: true }, 1);
    assert!(helped.is_active(HelpedStep::Wait));
    // The search has gone on without the edge (A2): the same inputs change nothing.
    assert_eq!(helped.next_deadline(), Some(Ticks::new(6)));
    helped.cycle(&HelpedInputs { a: true }, 1);
    assert_eq!((helped.is_active(HelpedStep::Wait), helped.next_deadline()), (true, Some(Ticks::new(6))));

    let mut hindered = Hindered::new();
    hindered.cycle(&HinderedInputs { a: false }, 0);
    hindered.cycle(&HinderedInputs { a: true }, 1);
    assert_eq!((hindered.is_active(HinderedStep::Rest), hindered.next_deadline()), (true, Some(Ticks::new(1))));
    hindered.cycle(&HinderedInputs { a: true }, 1);
    assert!(hindered.is_active(HinderedStep::Wait));
}

grafcet! {
    /// Edges of inputs alone, in a chart that is long enough to go through its program.
    grafcet OfInputs {
        input stop, ack, go, a, b, c: bool;
        output q: bool;
        partial Safety {
            initial step Ready;
            step Stopped;
            Ready -[stop]-> Stopped -[!stop && rising(ack)]-> Ready;
        }
        partial Work {
            initial step Rest;
            step First { q; }
            step Second;
            step Third { q; }
            step Fourth;
            step Fifth { q; }
            Rest -[rising(go)]-> First -[a]-> Second -[b]-> Third -[c]-> Fourth -[a && b]-> Fifth -[5s/Fifth]-> Rest;
        }
    }
}

/// What the first search does not see of an input's edge (A26), no later one sees.
#[test]
fn after_the_first_cycle_edges_of_inputs_ask_for_nothing() {
    for go in [false, true] {
        let mut chart = OfInputs::new();
        chart.cycle(&OfInputsInputs { go, ..Default::default() }, 7);
        assert_eq!(chart.next_deadline(), None, "{go}");
    }
}
