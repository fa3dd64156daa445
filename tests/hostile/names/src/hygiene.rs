//! Signals that are called what the generated code might call its own variables.

use grafcet::{Phase, grafcet};

grafcet! {
    /// One active step.
    pub sfc Plain {
        #![allow(grafcet::unused_variable, grafcet::set_without_reset, grafcet::reset_without_set)]
        input inputs, now, actions, self_, before, after, outputs, value, first, step, elapsed, steps, again: bool;
        input forced, forced0: bool;
        forceable;
        output situation, stable, entered, reset, q: bool;
        var last: bool;
        var active: u8;

        initial step Off { N situation; P1 active = active + 1; }
        step On { N stable; S entered; R reset; N q if inputs || now && value && forced != forced0; N last = last || step && elapsed; }

        Off -[inputs && !now || actions || self_]-> On -[before || after || outputs && first]-> Off;
        On -[rising(value) || steps && again && Off.X]-> On;
    }
}

grafcet! {
    /// Parallel steps, times, edges, delays, calls, blocks.
    pub sfc Timed {
        #![allow(grafcet::unused_variable, grafcet::set_without_reset)]
        input inputs, now, actions, before, after, outputs, value, first, input, done, elapsed, settled, soonest: bool;
        input since, time, ticks, duration, restart, left, flag: u16;
        output situation, region, region_0, region_1, set, steps: bool;
        output speed: u16;
        var kept, edge, memory, timer: bool;
        var count, number: u16;
        var limit: time = 1s;
        param params: time = 2s;
        param hot: u16 = 1;
        action call(phase: u16, inputs: u16);
        action scan();
        forceable;

        initial step Off { N situation; P0 scan(); }
        step One { N call(since, time); L limit region; D 2s set; SD params steps; kept; R region_0; speed = ticks + hot; }
        step Two { N call(restart, left); S region_0; P1 count = count + flag; P { number += 1; if number > hot { number = 0; } } }
        step Three { N scan(); memory; SL 1s timer; DS 1s edge; R region_1; }
        step Four { P1 { let inputs = count; count = inputs + 1; } S region_1; }

        Off -[rising(inputs && now)]-> (One, Two);
        (One, Two) -[falling(value) && first || params/One && 1s/before/500ms || actions]-> (Three, Four);
        (Three, Four) -[Three.T >= limit && duration > 1 || input && done && elapsed || after]-> Off;
        (Three, Four) -[settled && soonest && outputs]-> Off;
    }
}

grafcet! {
    /// So long that tables say what there is to do in a step.
    pub sfc Small {
        optimize size;
        input kind, found, once, table, after: bool;
        output kinds: bool;

        initial step S0; step S1 { N kinds; } step S2; step S3; step S4 { N kinds; } step S5; step S6; step S7 { N
        kinds; } step S8; step S9; step S10 { N kinds; } step S11; step S12; step S13 { N kinds; } step S14; step S15;
        step S16 { N kinds; } step S17; step S18; step S19 { N kinds; } step S20;

        S0 -[kind]-> S1 -[found && !once]-> S2 -[kind]-> S3 -[found && !once]-> S4 -[kind]-> S5 -[found && !once]-> S6
        -[kind]-> S7 -[found && !once]-> S8 -[kind]-> S9 -[found && !once]-> S10 -[kind]-> S11 -[found && !once]-> S12
        -[kind]-> S13 -[found && !once]-> S14 -[kind]-> S15 -[found && !once]-> S16 -[kind]-> S17 -[found && !once]->
        S18 -[table]-> S19 -[after]-> S20 -[kind]-> S0;
    }
}

grafcet! {
    /// The same under the rules of IEC 60848.
    pub grafcet Search {
        #![allow(grafcet::stuck_join)]
        input inputs, now, actions, before, after, outputs, value, first, input, fresh, stable, evolutions_left: bool;
        input elapsed, settled, due, active: u16;
        output situation, region, called, set: bool;
        output next, association: u16;
        var kept: bool;
        var count, number: u16;
        param params: time = 2s;
        action call(phase: u16, now: u16);
        max_evolutions 5;
        forceable;

        partial Above {
            initial step Ready;
            step Hold { force Below {*}; }
            Ready -[rising(inputs) && now]-> Hold -[falling(now) || kept]-> Ready;
        }
        partial Below {
            initial step Off { N situation; P0 call(elapsed, due); kept; N call(active, number); }
            step One { L 1s region if value; S called if !first; on rising(value) count = count + 1; N call(elapsed, settled); }
            step Two { D params set; R called if first; P1 next = elapsed; P0 { let next = settled; association = next; } }
            macro step Both { entry step In; exit step Out; In -[first]-> Out; }
            Off -[actions]-> (One, Two);
            (One, Two) -[before && after || 1s/outputs/2s || fresh => number = number + 1]-> Both;
            Both -[Both.T > 1s && input && stable]-> Off;
            () -[rising(evolutions_left) => call(count, active)]-> Two;
        }
    }
}

grafcet! {
    /// With a bit for each step, in several bytes.
    pub grafcet Flags {
        #![allow(grafcet::deadlock)]
        encoding flags;
        forceable;
        input before, after, first_of_byte, byte, set, moved, steps: bool;
        output situation, state, on: bool;
        var count: u8;
        initial step A0 { situation if before && A1.X; }
        step A1; step A2 { state; } step A3; step A4; step A5; step A6; step A7; step A8; step A9; step B0;
        step B1; step B2; step B3; step B4; step B5; step B6; step B7; step B8; step B9; step C0 { on if set && byte; }
        step C1; step C2; step C3; step C4; step C5; step C6; step C7; step C8; step C9 { P1 { let byte = 2; count += byte; } }
        A0 -[before && !A1.X || after && A2.X]-> (A1, A2);
        (A1, A2) -[first_of_byte && A2.X]-> A3 -[byte]-> A4 -[set]-> A5 -[moved && count == 0]-> A6 -[steps]-> A7;
        A7 -[byte]-> A8 -[set]-> A9 -[byte]-> B0 -[set]-> B1 -[byte]-> B2 -[set]-> B3 -[byte]-> B4 -[set]-> B5;
        B5 -[byte]-> B6 -[set]-> B7 -[byte]-> B8 -[set]-> B9 -[byte]-> C0 -[!set]-> C1 -[byte]-> C2 -[set]-> C3;
        C3 -[byte]-> C4 -[set]-> C5 -[byte]-> C6 -[set]-> C7 -[byte]-> C8 -[before && set]-> C9 -[rising(set)]-> A0;
    }
}

/// Carries out no action.
#[derive(Clone, Copy, Debug)]
pub struct Silent;

impl TimedActions for Silent {
    fn call(&mut self, _: Phase, _: u16, _: u16) {}
    fn scan(&mut self, _: Phase) {}
}

impl SearchActions for Silent {
    fn call(&mut self, _: Phase, _: u16, _: u16) {}
}

grafcet! {
    /// Names that an expression binds itself.
    pub sfc Bound {
        input count, limit: u16;
        input counts: [u16; 4];
        input mode: Option<u16>;
        output found: bool;
        output sum: u16;
        var total: u16;
        initial step Off { sum = counts.iter().fold(count, |sum, count| sum + count); }
        step On {
            found;
            P1 { let limit_of = |count: u16| count + limit; total = limit_of(1) + limit_of(2); }
            P0 { for count in counts { total += count; } }
        }
        Off -[counts.iter().any(|count| *count >= limit)]-> On;
        On -[matches!(mode, Some(limit) if limit > 3)]-> Off;
        On -[if let Some(count) = mode { count > limit } else { false }]-> Off;
        On -[{ let limit = 3; counts.contains(&limit) } && total > 0]-> Off;
    }
}

const LOW: bool = false;
const HIGH: bool = true;

grafcet! {
    /// Conditions that read nothing, beside those of several steps.
    pub sfc Constant {
        input go: bool;
        output done: bool;
        initial step Start;
        step A;
        step B;
        step C;
        final step End { done; }
        Start -[LOW || HIGH]-> (A, B);
        B -[go]-> C;
        (A, C) -[LOW || HIGH]-> End;
    }
}

#[test]
fn runs() {
    let mut constant = Constant::new();
    for _ in 0..3 {
        assert!(!constant.cycle(&ConstantInputs::default()).done, "`C` is not active");
    }
    constant.cycle(&ConstantInputs { go: true });
    assert!(constant.cycle(&ConstantInputs::default()).done);
    let mut bound = Bound::new();
    let inputs = BoundInputs { count: 1, limit: 4, counts: [4, 1, 1, 1], mode: Some(4) };
    assert_eq!(bound.cycle(&inputs).sum, 8);
    assert!(bound.cycle(&inputs).found);
    assert!(!bound.cycle(&inputs).found);
    let mut plain = Plain::new();
    assert!(plain.cycle(&PlainInputs::default()).situation);
    assert!(plain.cycle(&PlainInputs { inputs: true, ..Default::default() }).q);
    let mut timed = Timed::new();
    assert!(timed.cycle(&TimedInputs::default(), 0, &mut Silent).situation);
    let q = timed.cycle(&TimedInputs { inputs: true, now: true, ticks: 7, ..Default::default() }, 1, &mut Silent);
    assert_eq!(q.speed, 8);
    let mut flags = Flags::new();
    let all =
        FlagsInputs { first_of_byte: true, byte: true, set: true, moved: true, steps: true, ..Default::default() };
    assert!(flags.cycle(&FlagsInputs { before: true, ..Default::default() }).state);
    assert!(flags.cycle(&all).on && flags.is_active(FlagsStep::C0));
    let mut search = Search::new();
    assert!(search.cycle(&SearchInputs::default(), 0, &mut Silent).situation);
    let q = search.cycle(&SearchInputs { actions: true, elapsed: 9, ..Default::default() }, 1, &mut Silent);
    assert_eq!(q.next, 9);
}
