//! `encoding flags;`: a chart is the same one with a bit for each step, wherever the bits of a sequence lie.
#![deny(warnings)]

use grafcet::{Chart, grafcet};

/// Four branches: the steps of the first begin with the first bit and go over a byte, those of the second and the third lie between each other, and those of
/// the last begin within a byte and go over two. The third is empty before the others are done.
macro_rules! branches {
    ($name:ident { $($encoding:tt)* }) => {
        grafcet! {
            sfc $name {
                $($encoding)*
                input go, a, b, c: bool;
                output left, right, done, last: bool;
                initial step Rest;
                step L1; step L2; step L3; step L4 { left; } step L5; step L6; step L7; step L8; step L9;
                step R1; step T1; step R2 { right; } step T2; step R3; step T3; step R4; step T4; step R5; step T5; step R6; step T6 { done; } step T7;
                step M1; step M2; step M3; step M4; step M5; step M6; step M7; step M8; step M9 { last; }
                Rest -[go]-> (L1, R1, T1, M1);
                L1 -[a]-> L2 -[!a]-> L3 -[a]-> L4 -[!a]-> L5 -[a]-> L6 -[!a]-> L7 -[a]-> L8 -[!a]-> L9;
                R1 -[b]-> R2 -[!b]-> R3 -[b]-> R4 -[!b]-> R5 -[b]-> R6;
                T1 -[c]-> T2 -[a]-> T3 -[!c]-> T4 -[b]-> T5 -[c]-> T6;
                M1 -[c]-> M2 -[b]-> M3 -[!c]-> M4 -[a]-> M5 -[c]-> M6 -[!b]-> M7 -[a]-> M8 -[c]-> M9;
                (R6, T6) -[a]-> T7;
                (L9, T7, M9) -[!go]-> Rest;
            }
        }
    };
}

branches! { States {} }
branches! { Flags { encoding flags; } }

fn active<C: Chart>(chart: &C) -> Vec<String>
where
    C::Step: core::fmt::Debug,
{
    C::STEPS.iter().filter(|step| chart.is_active(**step)).map(|step| format!("{step:?}")).collect()
}

#[test]
fn a_bit_for_each_step_is_the_same_chart() {
    let (mut states, mut flags) = (States::new(), Flags::new());
    let (mut random, mut rounds) = (1_u32, 0);
    for cycle in 0..20_000 {
        random ^= random << 13;
        random ^= random >> 17;
        random ^= random << 5;
        if cycle % 5_000 == 4_999 {
            states.init();
            flags.init();
        }
        let [go, a, b, c] = [0, 1, 2, 3].map(|bit| random >> bit & 1 != 0);
        let one = states.cycle(&StatesInputs { go, a, b, c });
        let other = flags.cycle(&FlagsInputs { go, a, b, c });
        assert_eq!(active(&flags), active(&states), "cycle {cycle}");
        let shown = [one.left, one.right, one.done, one.last];
        assert_eq!([other.left, other.right, other.done, other.last], shown, "cycle {cycle}");
        assert_eq!(flags.situation().to_string(), states.situation().to_string(), "cycle {cycle}");
        assert_eq!(flags.active_steps().len(), states.active_steps().len());
        rounds += usize::from(active(&flags) == ["Rest"]);
    }
    assert!(rounds > 100, "the branches come to their end {rounds} times");
}
