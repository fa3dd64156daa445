//! Descriptions out of flat tables: a compiler takes far longer for values within values. For the code that the macro
//! generates; what is not in the tables ends the evaluation of the constant.

use super::{Action, Any, Step, Transition};

/// What texts are.
pub type Text = &'static str;
/// What the numbers of steps and transitions are.
pub type Number = u32;
/// What the numbers by which a transition names steps are.
pub type End = usize;

/// One of the numbers of a step: it is initial.
pub const INITIAL: Number = 1;
/// The same: it carries the activation link.
pub const LINKED: Number = 2;

/// How many numbers describe a step: its partial grafcet; [`INITIAL`] and [`LINKED`]; one more than the macro-step around it, or
/// zero; how many actions and how many forcing orders it has.
const STEP: usize = 5;

/// How many numbers describe a transition: how many steps stand before it and after it, how many actions it has.
const TRANSITION: usize = 3;

/// So many associations, of four texts each.
#[must_use]
pub const fn actions<'a, const N: usize>(texts: &'a [&'a str]) -> [Action<'a>; N] {
    let mut all = [Action::new("", "", "", ""); N];
    let mut number = 0;
    while number < N {
        let at = 4 * number;
        all[number] = Action::new(texts[at], texts[at + 1], texts[at + 2], texts[at + 3]);
        number += 1;
    }
    all
}

/// So many steps: their names, five numbers of each, see `STEP`, and what belongs to them, one after the other.
#[must_use]
pub const fn steps<'a, const N: usize>(
    names: &'a [&'a str],
    numbers: &[Number],
    mut actions: &'a [Action<'a>],
    mut forces: &'a [&'a str],
) -> [Step<'a>; N] {
    let mut all = [Step::new("", 0, &[], &[]); N];
    let mut number = 0;
    while number < N {
        let at = STEP * number;
        let (own_actions, later_actions) = actions.split_at(numbers[at + 3] as usize);
        let (own_forces, later_forces) = forces.split_at(numbers[at + 4] as usize);
        let mut step = Step::new(names[number], numbers[at] as usize, own_actions, own_forces);
        step.initial = numbers[at + 1] & INITIAL != 0;
        step.linked = numbers[at + 1] & LINKED != 0;
        step.expansion = (numbers[at + 2] as usize).checked_sub(1);
        all[number] = step;
        (actions, forces) = (later_actions, later_forces);
        number += 1;
    }
    all
}

/// The same steps, of which some, by their numbers, have a time after which they are late.
#[must_use]
pub const fn with_times<'a, const N: usize>(mut all: [Step<'a>; N], times: &[(usize, &'a str)]) -> [Step<'a>; N] {
    let mut number = 0;
    while number < times.len() {
        let (step, within) = times[number];
        all[step] = all[step].within(within);
        number += 1;
    }
    all
}

/// So many transitions: name and condition, three numbers of each, see `TRANSITION`, and what belongs to them, one after the
/// other: the steps before and after, and the actions.
#[must_use]
pub const fn transitions<'a, const N: usize>(
    texts: &'a [&'a str],
    numbers: &[Number],
    mut ends: &'a [End],
    mut clearing: &'a [&'a str],
) -> [Transition<'a>; N] {
    let mut all = [Transition::new("", &[], &[], "", &[]); N];
    let mut number = 0;
    while number < N {
        let at = TRANSITION * number;
        let (sources, behind) = ends.split_at(numbers[at] as usize);
        let (targets, later_ends) = behind.split_at(numbers[at + 1] as usize);
        let (own, later) = clearing.split_at(numbers[at + 2] as usize);
        all[number] = Transition::new(texts[2 * number], sources, targets, texts[2 * number + 1], own);
        (ends, clearing) = (later_ends, later);
        number += 1;
    }
    all
}

/// The same transitions, of which some, by their numbers, are `any`.
#[must_use]
pub const fn with_any<'a, const N: usize>(
    mut all: [Transition<'a>; N],
    anys: &[(usize, Any<'a>)],
) -> [Transition<'a>; N] {
    let mut number = 0;
    while number < anys.len() {
        let (transition, any) = anys[number];
        all[transition] = all[transition].from_any(any.steps, any.except);
        number += 1;
    }
    all
}

#[cfg(test)]
mod tests {
    use super::{INITIAL, LINKED, actions, steps, transitions, with_any};
    use crate::description::{Action, Any, Step, Transition};

    #[test]
    fn each_step_gets_its_own() {
        static ACTIONS: [Action<'static>; 3] = actions(&["N", "", "", "a", "L", "5s", "", "b", "S", "", "c", "d"]);
        let (first, others) = ACTIONS.split_at(1);
        let b = others[0];
        assert_eq!((b.qualifier, b.time, b.condition, b.text), ("L", "5s", "", "b"));
        let numbers = [0, INITIAL, 0, 1, 0, 1, LINKED, 0, 0, 2, 0, INITIAL | LINKED, 3, 2, 0];
        let all: [Step<'_>; 3] = steps(&["A", "B", "C"], &numbers, &ACTIONS, &["F {A}", "G {*}"]);
        let expected = [
            Step::new("A", 0, first, &[]).initial(),
            Step::new("B", 1, &[], &["F {A}", "G {*}"]).linked(),
            Step::new("C", 0, others, &[]).initial().linked().inside(2),
        ];
        assert_eq!(all, expected);
    }

    #[test]
    fn each_transition_gets_its_own() {
        let numbers = [1, 2, 0, 0, 1, 1, 2, 0, 2];
        let all: [Transition<'_>; 3] =
            transitions(&["", "a", "t", "b", "", "c"], &numbers, &[0, 1, 2, 3, 4, 5], &["x = 1", "y = 2", "z = 3"]);
        let expected = [
            Transition::new("", &[0], &[1, 2], "a", &[]),
            Transition::new("t", &[], &[3], "b", &["x = 1"]),
            Transition::new("", &[4, 5], &[], "c", &["y = 2", "z = 3"]),
        ];
        assert_eq!(all, expected);
    }
    #[test]
    fn some_transitions_are_any() {
        let plain = [Transition::new("", &[0], &[1], "a", &[]), Transition::new("stop", &[], &[2], "b", &[])];
        let all = with_any(plain, &[(1, Any { steps: &[0, 1], except: &["C"] })]);
        assert_eq!(all, [plain[0], plain[1].from_any(&[0, 1], &["C"])]);
        assert_eq!(all[1].any, Some(Any { steps: &[0, 1], except: &["C"] }));
    }
}
