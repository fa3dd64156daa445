//! `blink`: on and off from the activation of a step on, and when to look again.

use grafcet::{Ticks, grafcet};

grafcet! {
    /// A lamp that blinks unevenly while the machine waits, and a horn beside it.
    pub sfc Waiting {
        input start, stop: bool;
        output lamp, horn: bool;

        initial step Idle { lamp if blink(700ms/300ms); }
        step Run { lamp; horn if !blink(2s); }

        Idle -[start]-> Run -[stop]-> Idle;
    }
}

grafcet! {
    /// The lamp of a macro-step goes on while its expansion does.
    pub grafcet Macro {
        input go, next: bool;
        output lamp: bool;

        initial step Idle;
        macro step Job {
            entry step First { lamp if blink(400ms/100ms, Job); }
            exit step Last { lamp if blink(400ms/100ms, Job); }
            First -[next]-> Last;
        }
        Idle -[go]-> Job -[!go && !blink(400ms/100ms)]-> Idle;
    }
}

#[test]
fn it_begins_with_the_activation() {
    let mut chart = Waiting::new();
    let idle = WaitingInputs::default();
    for (now, lamp) in [(5_000, true), (5_699, true), (5_700, false), (5_999, false), (6_000, true), (6_700, false)] {
        assert_eq!(chart.cycle(&idle, now).lamp, lamp, "{now}");
    }
    chart.cycle(&WaitingInputs { start: true, ..idle }, 6_800);
    assert!(chart.cycle(&WaitingInputs { stop: true, ..idle }, 6_850).lamp);
    assert!(chart.cycle(&idle, 7_549).lamp);
    assert!(!chart.cycle(&idle, 7_550).lamp);
}

#[test]
fn the_next_deadline_is_the_next_change() {
    let mut chart = Waiting::new();
    let idle = WaitingInputs::default();
    let mut now = u32::MAX - 1_000;
    chart.cycle(&idle, now);
    // The cycle after the first one may evolve.
    assert_eq!(chart.next_deadline(), Some(Ticks::new(now)));
    let mut changes = Vec::new();
    for _ in 0..8 {
        let lamp = chart.cycle(&idle, now).lamp;
        let next = chart.next_deadline().expect("it blinks").get();
        changes.push((next.wrapping_sub(now), lamp));
        assert_eq!(chart.cycle(&idle, next.wrapping_sub(1)).lamp, lamp);
        now = next;
    }
    assert_eq!(changes, [(700, true), (300, false)].repeat(4));
    chart.cycle(&WaitingInputs { start: true, ..idle }, now);
    chart.cycle(&WaitingInputs { start: true, ..idle }, now);
    assert_eq!(chart.next_deadline(), Some(Ticks::new(now.wrapping_add(2_000))));
}

/// The time of a step stays where 32 bits end; it blinks all the same, in step.
#[test]
fn a_step_that_stays_for_a_hundred_days_goes_on_blinking() {
    let mut chart = Waiting::new();
    let idle = WaitingInputs::default();
    let mut passed = 0_u64;
    chart.cycle(&idle, 0);
    for _ in 0..20_000 {
        passed += 432_017;
        let lamp = chart.cycle(&idle, u32::try_from(passed & 0xFFFF_FFFF).unwrap_or_default()).lamp;
        assert_eq!(lamp, passed % 1_000 < 700, "{passed}");
    }
    assert!(passed > 2 * u64::from(u32::MAX));
}

grafcet! {
    /// A step that blinks and is left after a time of its own, which tells how far the period is.
    pub grafcet Timed {
        input ack: bool;
        output lamp, horn: bool;

        initial step Alarm { lamp if blink(700ms/300ms); L 2500ms horn; }
        step Rest;

        Alarm -[ack && 1200ms/Alarm]-> Rest -[!ack]-> Alarm;
    }
}

/// Three periods are kept, for the horn; then the time goes on by whole ones.
#[test]
fn what_blinks_beside_a_time_of_its_own_goes_on_blinking() {
    let mut chart = Timed::new();
    let idle = TimedInputs::default();
    let begin = u32::MAX - 2_000;
    let mut now = begin;
    let mut changes = Vec::new();
    for _ in 0..10 {
        let outputs = chart.cycle(&idle, now);
        let next = chart.next_deadline().expect("it blinks").get();
        changes.push((now.wrapping_sub(begin), outputs.lamp, outputs.horn));
        assert_eq!(chart.cycle(&idle, next.wrapping_sub(1)), outputs);
        now = next;
    }
    let by_hand = [
        (0, true, true),
        (700, false, true),
        (1_000, true, true),
        (1_200, true, true),
        (1_700, false, true),
        (2_000, true, true),
        (2_500, true, false),
        (2_700, false, false),
        (3_000, true, false),
        (3_700, false, false),
    ];
    assert_eq!(changes, by_hand);
    let mut passed = u64::from(now.wrapping_sub(begin));
    for _ in 0..20_000 {
        passed += 432_017;
        let reading = begin.wrapping_add(u32::try_from(passed & 0xFFFF_FFFF).unwrap_or_default());
        let outputs = chart.cycle(&idle, reading);
        assert_eq!((outputs.lamp, outputs.horn), (passed % 1_000 < 700, false), "{passed}");
        now = reading;
    }
    assert!(passed > 2 * u64::from(u32::MAX));
    chart.cycle(&TimedInputs { ack: true }, now);
    assert!(chart.is_active(TimedStep::Rest));
}

#[test]
fn a_macro_step_blinks_through_its_expansion() {
    let mut chart = Macro::new();
    let idle = MacroInputs::default();
    chart.cycle(&idle, 0);
    let go = MacroInputs { go: true, ..idle };
    assert!(chart.cycle(&go, 100).lamp);
    assert_eq!(chart.next_deadline(), Some(Ticks::new(500)));
    assert!(chart.cycle(&MacroInputs { next: true, ..go }, 300).lamp);
    assert!(!chart.cycle(&go, 500).lamp);
    assert!(chart.cycle(&idle, 600).lamp);
    assert!(chart.is_active(MacroStep::Last));
    chart.cycle(&idle, 1_000);
    assert!(chart.is_active(MacroStep::Idle));
    assert_eq!(chart.next_deadline(), None);
}
