//! What passes need, each on programs made by hand of which one lacks it: the lowering makes none of these today.

use grafcet_compiler::model::{Id, InputId, OutputId};
use grafcet_compiler::program::passes::{Pass, optimise};
use grafcet_compiler::program::{Comparison, Expr, PlaceId, Program, Role, Statement, Type, Value};
use grafcet_conformance::program::program as optimised;

use super::passes::kettle;
use super::read;
use super::regions::CELL;

/// One partial grafcet takes the other's steps away.
const TWO: &str = "grafcet Two { input a, b: bool; output p: bool; partial Up { initial step A { force Down {}; } step B; A -[a]-> B -[b]-> A; } \
         partial Down { initial step C; step D { p; } C -[a]-> D -[b]-> C; } }";

/// An arm of no step is none of a step: what two arms do is not done for the step that has none.
#[test]
fn what_only_some_states_do_is_not_hoisted() {
    let model = read(TWO);
    let mut program = optimised(&model, &[]).expect("a program");
    let state = program.place(Role::State(1)).expect("a region");
    let p = program.place(Role::Output(OutputId::new(0))).expect("an output");
    let set = || vec![Statement::Set(p, Expr::Value(Value::Bool(true)))];
    let arm = |step: Option<usize>| (vec![Value::Step(step.map(|at| program.regions[1][at]))], set());
    let cycle = |arms| {
        vec![Statement::Loop { rounds: 1, body: vec![Statement::Match(state, arms, Vec::new()), Statement::Break] }]
    };
    let of_some = cycle(vec![arm(Some(0)), arm(None)]);
    let of_all = cycle(vec![arm(Some(0)), arm(Some(1)), arm(None)]);
    for (cycle, hoisted) in [(of_some, false), (of_all, true)] {
        program.cycle = cycle;
        optimise(&mut program, &[Pass::Hoist]);
        let Some(Statement::Loop { body, .. }) = program.cycle.first() else { panic!("{program}") };
        assert_eq!(matches!(body[0], Statement::Set(..)), hoisted, "{program}");
    }
}

/// A match that leads to one state from each other one is no question: not where a state is left that it does not name, be it none, nor where one leads elsewhere.
#[test]
fn what_leads_to_one_state_from_all_others_is_no_question() {
    let model = read(TWO);
    let mut program = optimised(&model, &[]).expect("a program");
    let state = program.place(Role::State(1)).expect("a region");
    let [one, other] = program.regions[1][..] else { panic!("two steps") };
    let arm = |from, to| (vec![Value::Step(from)], vec![Statement::Set(state, Expr::Value(Value::Step(to)))]);
    let (named, empty) = (|| arm(Some(one), Some(other)), || arm(None, Some(other)));
    for (arms, asked) in
        [(vec![named(), empty()], false), (vec![named()], true), (vec![named(), arm(None, Some(one))], true)]
    {
        program.cycle = vec![Statement::Match(state, arms, Vec::new())];
        optimise(&mut program, &[Pass::Hoist]);
        assert_eq!(matches!(program.cycle[..], [Statement::Match(..)]), asked, "{program}");
    }
}

/// What a round reads before it is set anew is not set in front of the search.
#[test]
fn what_a_round_reads_first_stays_in_it() {
    let model = read(CELL);
    let mut program = optimised(&model, &[]).expect("a program");
    let [one, other, ..] = locals(&program)[..] else { panic!("two locals") };
    let on = || Statement::Set(other, Expr::Value(Value::Bool(true)));
    for (front, moved) in [(vec![], true), (vec![Statement::Set(one, Expr::Place(other))], false)] {
        let body = [front, vec![on(), Statement::Break]].concat();
        program.cycle = vec![Statement::Loop { rounds: 2, body }];
        optimise(&mut program, &[Pass::Peel]);
        assert_eq!(matches!(program.cycle[0], Statement::Set(..)), moved, "{program}");
    }
}

/// A stored value is compared with its next one unless each change of it tells that something moves.
#[test]
fn what_changes_alone_is_compared() {
    let model = read(CELL);
    let mut program = optimised(&model, &[]).expect("a program");
    let [moves, next, asked, ..] = locals(&program)[..] else { panic!("three locals") };
    let value = program.place(Role::Output(OutputId::new(0))).expect("an output");
    let set = |place, holds| Statement::Set(place, Expr::Value(Value::Bool(holds)));
    for tells in [true, false] {
        let told = if tells { vec![set(next, true), set(moves, true)] } else { vec![set(next, true)] };
        let differs = Expr::Compare(Comparison::Differs, Box::new(Expr::Place(value)), Box::new(Expr::Place(next)));
        let body = vec![
            set(moves, false),
            Statement::Set(next, Expr::Place(value)),
            Statement::If(Expr::Place(asked), told, Vec::new()),
            Statement::Set(moves, Expr::Any(vec![Expr::Place(moves), differs])),
            Statement::Set(value, Expr::Place(next)),
            Statement::If(Expr::Not(Box::new(Expr::Place(moves))), vec![Statement::Break], Vec::new()),
        ];
        program.cycle = vec![Statement::Loop { rounds: 2, body }];
        optimise(&mut program, &[Pass::Stays]);
        let Some(Statement::Loop { body, .. }) = program.cycle.first() else { panic!("{program}") };
        let compares = body.iter().any(|one| matches!(one, Statement::Set(_, Expr::Any(_))));
        assert_eq!(compares, !tells, "{program}");
    }
}

/// A value is set where its next one is, unless the round may be left in between, or the next one is used after the loop.
#[test]
fn a_value_waits_for_the_end_of_the_round_where_somebody_could_see_the_difference() {
    let model = read(CELL);
    let mut program = optimised(&model, &[]).expect("a program");
    let [next, asked, seen, ..] = locals(&program)[..] else { panic!("three locals") };
    let value = program.place(Role::Output(OutputId::new(0))).expect("an output");
    let on = Expr::Value(Value::Bool(true));
    let nothing = Vec::new;
    let left = || vec![Statement::If(Expr::Place(asked), vec![Statement::Break], Vec::new())];
    let used = || vec![Statement::Set(seen, Expr::Place(next))];
    for (between, after, set) in [(nothing(), nothing(), true), (left(), nothing(), false), (nothing(), used(), false)]
    {
        let change = vec![Statement::Set(next, on.clone())];
        let front =
            vec![Statement::Set(next, Expr::Place(value)), Statement::If(Expr::Place(asked), change, Vec::new())];
        let body = [front, between, vec![Statement::Set(value, Expr::Place(next)), Statement::Break]].concat();
        program.cycle = [vec![Statement::Loop { rounds: 2, body }], after].concat();
        optimise(&mut program, &[Pass::Stays]);
        let Some(Statement::Loop { body, .. }) = program.cycle.first() else { panic!("{program}") };
        let waits = body.iter().any(|one| matches!(one, Statement::Set(place, Expr::Place(_)) if *place == value));
        assert_eq!(waits, !set, "{program}");
    }
}

/// A way to a step that does not ask for its time begins none, unless one of those that lead to a step that asks leaves that to an earlier one: because it begins none
/// itself, or because it does so only where the step was not active at the beginning of the cycle, and not of the evolution.
#[test]
fn a_time_begins_on_each_way_where_one_to_a_step_that_asks_does_not_begin_it() {
    let model = read(CELL);
    let naive = || optimised(&model, &[]).expect("a program");
    let state = naive().place(Role::State(2)).expect("a region");
    let since = naive().place(Role::Began(2)).expect("a region by time");
    let [was, ..] = copies(&naive(), 2)[..] else { panic!("a copy of the state") };
    let [wait, close, work, ..] = naive().regions[2][..] else { panic!("three steps") };
    let to = |step| Statement::Set(state, Expr::Value(Value::Step(Some(step))));
    let begin = || Statement::Set(since, Expr::Now);
    let copy = || Statement::Set(was, Expr::Place(state));
    let close_asks = || {
        let passed = Expr::Since(Box::new(Expr::Now), Box::new(Expr::Place(since)));
        let long = Expr::Value(Value::Ticks(4));
        let over = Expr::Compare(Comparison::AtLeast, Box::new(passed), Box::new(long));
        (vec![Value::Step(Some(close))], vec![Statement::If(over, vec![to(work), begin()], Vec::new())])
    };
    let from = |step, way| (vec![Value::Step(Some(step))], way);
    let closes = |to_close| Statement::Match(state, vec![from(wait, to_close), close_asks()], Vec::new());
    let if_entered = || {
        let entered = Expr::Value(Value::Step(Some(close)));
        let differs = Expr::Compare(Comparison::Differs, Box::new(Expr::Place(was)), Box::new(entered));
        Statement::If(differs, vec![begin()], Vec::new())
    };
    let round = |front: Vec<_>, body: Vec<_>| {
        let body = [body, vec![Statement::Break]].concat();
        [front, vec![Statement::Loop { rounds: 2, body }]].concat()
    };
    for (what, cycle, fewer) in [
        ("each way begins the time", round(vec![], vec![closes(vec![to(close), begin()])]), true),
        ("one begins none", round(vec![], vec![closes(vec![to(close)])]), false),
        ("where it was not active", round(vec![], vec![copy(), closes(vec![if_entered(), to(close)])]), true),
        (
            "the deadline alone asks",
            round(
                vec![],
                vec![Statement::Match(
                    state,
                    vec![from(wait, vec![to(close), begin()]), from(close, vec![to(work), begin()])],
                    Vec::new(),
                )],
            ),
            true,
        ),
        ("since the cycle began", round(vec![copy()], vec![closes(vec![if_entered(), to(close)])]), false),
    ] {
        let mut program = naive();
        program.cycle = cycle;
        let before = program.to_string().matches("since.Wait = now").count();
        optimise(&mut program, &[Pass::Begun]);
        let after = program.to_string().matches("since.Wait = now").count();
        assert_eq!(after, before - usize::from(fewer), "{what}: {program}");
    }
}

/// What gives a field in the first cycle what it begins with is nothing to do, unless the field may hold something else by then.
#[test]
fn what_begins_alike_is_set_where_it_may_have_changed() {
    let model = read(
        "grafcet Begins { input on: bool; output a: bool = false; output b: bool = true; initial step Off; step On { S a; R b; } \
         Off -[on]-> On -[5ms/On || !on]-> Off; }",
    );
    let passes: Vec<Pass> = Pass::ALL.into_iter().take_while(|pass| *pass != Pass::Starting).collect();
    let naive = || optimised(&model, &passes).expect("a program");
    let first = naive().place(Role::First).expect("a first cycle");
    let [a, b] = [0, 1].map(|at| naive().place(Role::Output(OutputId::new(at))).expect("an output"));
    let set = |place, holds| Statement::Set(place, Expr::Value(Value::Bool(holds)));
    let copy = || Statement::Set(b, Expr::Place(a));
    let maybe = |body| Statement::If(Expr::Input(InputId::new(0)), body, Vec::new());
    let at_first = |body| Statement::If(Expr::Place(first), body, Vec::new());
    for (what, front, kept) in [
        ("nothing before", vec![at_first(vec![set(a, false)])], 0),
        ("written before", vec![at_first(vec![set(a, true)]), at_first(vec![set(a, false)])], 2),
        ("a copy of what was set", vec![at_first(vec![set(a, true), copy()])], 1),
        ("a copy of what may have changed", vec![at_first(vec![set(a, true), maybe(vec![set(a, false)]), copy()])], 3),
    ] {
        let mut program = naive();
        program.cycle.splice(0..0, front);
        optimise(&mut program, &[Pass::Starting]);
        let beginning = program.cycle.iter().take_while(|one| !matches!(one, Statement::Loop { .. }));
        let bodies = beginning.filter_map(|one| match one {
            Statement::If(Expr::Place(place), body, _) if *place == first => Some(body),
            _ => None,
        });
        let writes = |one: &&Statement<'_>| match one {
            Statement::Set(place, _) => [a, b].contains(place),
            other => matches!(other, Statement::If(..)),
        };
        let left = bodies.flatten().filter(writes).count();
        assert_eq!(left, kept, "{what}: {program}");
    }
}

/// That branches tell by their states whether they have moved needs that each way says rightly whether it has.
#[test]
fn ways_that_do_not_tell_whether_they_have_moved_keep_saying_it() {
    fn each<'m>(statements: &mut [Statement<'m>], found: &mut dyn FnMut(PlaceId, &mut Expr<'m>)) {
        for statement in statements {
            match statement {
                Statement::Set(place, value) => found(*place, value),
                Statement::If(_, then, otherwise) => {
                    each(then, found);
                    each(otherwise, found);
                }
                Statement::Match(_, arms, otherwise) => {
                    for (_, body) in arms {
                        each(body, found);
                    }
                    each(otherwise, found);
                }
                Statement::Part(_, body) | Statement::Loop { body, .. } => each(body, found),
                _ => {}
            }
        }
    }
    let model = read(&kettle(""));
    let passes: Vec<Pass> = Pass::ALL.into_iter().take_while(|pass| *pass != Pass::Before).collect();
    let naive = || optimised(&model, &passes).expect("a program");
    let settled = naive().place(Role::Settled).expect("what is told");
    let says = |wrong: Option<usize>| {
        let (mut program, mut said) = (naive(), 0);
        each(&mut program.cycle, &mut |place, value| {
            if let (true, Expr::Value(Value::Bool(says))) = (place == settled, value) {
                *says ^= wrong == Some(said);
                said += 1;
            }
        });
        optimise(&mut program, &[Pass::Before]);
        let mut left = 0;
        each(&mut program.cycle, &mut |place, _| left += usize::from(place == settled));
        (said, left)
    };
    // The last one says it by what has cleared.
    assert_eq!(says(None), (3, 0));
    for wrong in 0..3 {
        assert_eq!(says(Some(wrong)), (3, 4), "the way {wrong}");
    }
}

/// Locals to which the state of a region can be copied.
fn copies(program: &Program<'_>, region: usize) -> Vec<PlaceId> {
    let places = program.places.iter().enumerate();
    let is_one = |place: &grafcet_compiler::program::PlaceInfo<'_>| {
        !place.is_field && matches!(place.ty, Type::State(of) if of == region)
    };
    places.filter(|(_, place)| is_one(place)).map(|(at, _)| PlaceId(at)).collect()
}

/// Truths of one cycle.
fn locals(program: &Program<'_>) -> Vec<PlaceId> {
    let truths = program.places.iter().enumerate();
    truths.filter(|(_, place)| !place.is_field && matches!(place.ty, Type::Bool)).map(|(at, _)| PlaceId(at)).collect()
}
