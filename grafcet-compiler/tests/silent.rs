//! No rule is silent because of another: a chart in which something is dead never passes without a word, and what is wrong
//! with an action hides nothing.

mod judged;

use std::fmt::Write;

use judged::{expanded, rules};

use grafcet_compiler::analysis::explore::{Exploration, Limits};
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::{model, parse};

#[test]
fn two_that_take_each_other_for_the_cause() {
    let chart = |dialect: &str| {
        format!(
            "{dialect} C {{ input a, b: bool; initial step S1; step S2; step S4; step S5; S1 -[a]-> S2; S1 -[b]-> S4; \
             (S2, S4) -[true]-> S4; S4 -[S5.X]-> S5; S5 -[a]-> S1; }}"
        )
    };
    assert_eq!(rules(&chart("sfc")), ["dead_transition", "stuck_join"]);
    assert_eq!(rules(&chart("grafcet")), ["dead_transition", "overlapping_branches", "stuck_join"]);
    let chart = "sfc C { input a: bool; initial step A; step B; step E; step F; A -[a]-> B; B -[E.X && a]-> E; \
                 E -[F.X]-> F -[a]-> A; B -[F.X]-> F; }";
    assert_eq!(rules(chart), ["dead_transition"]);
    let chart = "sfc C { input a: bool; initial step A; step B; A -[B.X && a]-> B -[a]-> A; }";
    assert_eq!(rules(chart), ["dead_transition"]);
}

#[test]
fn what_an_action_does_hides_nothing() {
    let chart = "grafcet C { input a, b: bool; output q, r: bool; initial step A { q; } step B { P1 q = true; S r; } \
                 step E { R r; } A -[a]-> B -[a && !a]-> E -[b]-> A; never q && r; never r && A.X; }";
    assert_eq!(rules(chart), ["mixed_modes", "never_true"]);
    let chart = "sfc C { input a, b: bool; output q, r: bool; initial step A { N q; } step B { P1 q = true; N r; } \
                 A -[a]-> B -[b]-> A; B -[b && a]-> A; never r && B.X; never q; }";
    assert_eq!(rules(chart), ["mixed_modes", "property_violated", "shadowed_branch"]);
    // What a mixed variable holds is open: nothing follows from it.
    let chart = "grafcet C { input a, b: bool; var v: bool; initial step A { v; } step B { P1 v = true; } \
                 A -[a && v]-> B -[b && !v]-> A; }";
    assert_eq!(rules(chart), ["mixed_modes"]);
    let chart = "sfc C { input a, b: bool; var v: bool; initial step A { N v; } step B { P1 v = false; } \
                 A -[a && v]-> B -[b && !v]-> A; }";
    assert_eq!(rules(chart), ["mixed_modes"]);
    let chart = "grafcet C { input a, b: bool; output q, r: bool; initial step A { q; } step B { r if rising(a); } \
                 A -[a && q]-> B -[b && !b]-> A; }";
    assert_eq!(rules(chart), ["edge_in_assignation", "never_true", "reads_continuous"]);
}

struct Random(u64);

impl Random {
    fn below(&mut self, bound: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 % bound
    }
}

/// A chart whose arrows may lead anywhere and wait for anything.
fn chart(random: &mut Random, dialect: &str) -> String {
    let mut text = format!("{dialect} C {{ input a, b: bool; initial step S0; step S1; step S2; step S3; step S4;\n");
    for from in 0..5 {
        for _ in 0..=random.below(2) {
            let other = random.below(5);
            let condition = match random.below(8) {
                0 => format!("S{other}.X"),
                1 => format!("a && S{other}.X"),
                2 => "true".to_owned(),
                3 => "!a && b".to_owned(),
                4 | 5 => "a".to_owned(),
                _ => "b && !a".to_owned(),
            };
            let (second, to, too) = (random.below(5), random.below(5), random.below(5));
            let sources = if random.below(5) == 0 && second != from {
                format!("(S{from}, S{second})")
            } else {
                format!("S{from}")
            };
            let targets = if random.below(6) == 0 && to != too { format!("(S{to}, S{too})") } else { format!("S{to}") };
            _ = writeln!(text, "{sources} -[{condition}]-> {targets};");
        }
    }
    text + "}"
}

#[test]
fn what_is_dead_does_not_pass_without_a_word() {
    let mut random = Random(0x2545_F491_4F6C_DD1D);
    let mut dead = 0;
    for round in 0..1500 {
        let text = chart(&mut random, if round % 2 == 0 { "sfc" } else { "grafcet" });
        let mut sink = Sink::new();
        let parsed = parse::chart(text.parse().expect("tokens"), &mut sink).expect("a chart");
        let model = model::resolve(&parsed, &mut sink);
        drop(sink.finish());
        let found = Exploration::of(&model, &Limits::default());
        let idle = model.transitions.ids().any(|id| !found.can_clear(id));
        let lost = model.steps.ids().any(|step| !found.reachable(step));
        if idle || lost || !found.deadlocks().is_empty() {
            dead += 1;
            assert!(!rules(&text).is_empty() || expanded(&text).contains("compile_error"), "{text}");
        }
    }
    assert!(dead > 500, "{dead}");
}
