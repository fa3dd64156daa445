//! Descriptions made at random, without a chart in text: more kinds of nets than people draw.

use grafcet_core::description::{Action, Description, Dialect, Let, Partial, Step, Transition};

use crate::random::Rng;

/// Calls `f` with a net of a seed.
pub(crate) fn net(seed: u64, f: impl FnOnce(&Description<'_>)) {
    let mut rng = Rng::new(seed);
    let most = if rng.chance(10) { 24 } else { 9 };
    let count = rng.between(1, most);
    let names: Vec<String> =
        (0..count).map(|n| format!("{}{n}", ["S", "Fill", "Longer_name_"][rng.below(3)])).collect();
    let actions =
        [Action::new("N", "", "", "motor"), Action::new("S", "", "a && b", "lamp"), Action::new("D", "5s", "", "q")];
    let forces = ["G {*}"];
    let steps: Vec<Step<'_>> = names
        .iter()
        .enumerate()
        .map(|(n, name)| {
            let many = rng.below(actions.len() + 1);
            let step = Step::new(
                name,
                0,
                &actions[..if rng.chance(50) { many } else { 0 }],
                &forces[..usize::from(rng.chance(5))],
            );
            if n == 0 || rng.chance(6) { step.initial() } else { step }
        })
        .collect();
    // Mostly from one step to one; some charts have many parallel branches.
    let parallel = [10, 30, 60][rng.below(3)];
    let arcs = rng.between(count.saturating_sub(1).max(1), count + count / 2 + 2);
    let mut ends = Vec::new();
    for n in 0..arcs {
        let mut side = |near: usize| {
            let many = if rng.chance(parallel) { rng.between(2, 4) } else { usize::from(!rng.chance(3)) };
            let mut steps = Vec::new();
            for number in 0..many {
                let step = if number == 0 && rng.chance(70) { near % count } else { rng.below(count) };
                if !steps.contains(&step) {
                    steps.push(step);
                }
            }
            steps
        };
        let (sources, targets) = (side(n), side(n + 1));
        ends.push(if sources.is_empty() && targets.is_empty() { (vec![0], vec![0]) } else { (sources, targets) });
    }
    let texts: Vec<(String, String)> = (0..arcs)
        .map(|n| {
            let name = if rng.chance(20) { format!("t{n}") } else { String::new() };
            let long = if rng.chance(10) { " && over_temperature || !motor_left_is_running" } else { "" };
            (name, format!("c{n}{long}"))
        })
        .collect();
    let left: Vec<&str> = names.iter().map(String::as_str).collect();
    let transitions: Vec<Transition<'_>> = ends
        .iter()
        .zip(&texts)
        .map(|((sources, targets), (name, condition))| {
            let transition = Transition::new(name, sources, targets, condition, &[]);
            let any = sources.is_empty() && rng.chance(50);
            let except = &left[..rng.below(left.len().min(6))];
            if any { transition.from_any(&[0], except) } else { transition }
        })
        .collect();
    let lets = [
        Let::new("go", "auto || rising(next)")
            .documented("Somebody wants the next one, and there is still room for it on the belt."),
        Let::new(
            "halt",
            "stop || !guard_is_closed && !key_is_turned_to_the_left || over_temperature || pressure_is_low",
        ),
    ];
    f(&Description {
        name: "Made",
        dialect: if seed % 2 == 0 { Dialect::Sfc } else { Dialect::Grafcet },
        partials: &[Partial::new("")],
        macros: &[],
        steps: &steps,
        transitions: &transitions,
        lets: &lets[..rng.below(3)],
    });
}
