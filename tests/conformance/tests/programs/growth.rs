//! What a cycle costs depends on what is active, not on how large the chart is: charts of more and more parallel branches, one after the other.

use std::fmt::Write as _;

use grafcet_compiler::model::Model;
use grafcet_compiler::program::passes::Pass;
use grafcet_compiler::program::{Expr, Statement};
use grafcet_conformance::program::program as optimised;

use super::passes::{drawn, each_left_out};
use super::read;

/// What the steps of such a chart do, what its transitions ask for, and what stands behind them.
#[derive(Clone, Copy)]
struct Kind {
    name: &'static str,
    /// In the second and the fifth step of each block.
    actions: [&'static str; 2],
    /// In the transitions of both branches.
    asks: [&'static str; 2],
    more: &'static str,
    dialects: &'static [&'static str],
}

const PLAIN: Kind =
    Kind { name: "plain", actions: ["", ""], asks: ["b", "c"], more: "", dialects: &["sfc", "grafcet"] };

const KINDS: [Kind; 7] = [
    PLAIN,
    Kind { name: "by time", asks: ["5ms/STEP", "c"], ..PLAIN },
    Kind { name: "edges", asks: ["rising(b)", "c"], ..PLAIN },
    // In an `sfc` each step that counts as it is entered or left has a truth of its own.
    Kind {
        name: "counted where a step is entered",
        dialects: &["grafcet"],
        actions: ["P1 n = n % 50 + 1;", "P1 n = n % 60 + 2;"],
        ..PLAIN
    },
    Kind {
        name: "counted where a step is left",
        dialects: &["grafcet"],
        actions: ["P0 n = n % 50 + 1;", "P0 n = n % 60 + 2;"],
        ..PLAIN
    },
    Kind { name: "stored", actions: ["S u;", "R u; S v;"], ..PLAIN },
    Kind { name: "with a stop", asks: ["5ms/STEP", "c"], more: "any except S0 -[d && !a]-> S0;", ..PLAIN },
];

/// Blocks of a fork, two branches, their convergence and a step.
fn blocks(dialect: &str, kind: Kind, count: usize) -> String {
    let mut chart =
        format!("{dialect} Blocks {{ input a, b, c, d: bool; output n: u8; output p, q, r, s, t, u, v: bool; ");
    for first in (0..count).map(|block| 6 * block) {
        let initial = if first == 0 { "initial " } else { "" };
        let [one, four] = kind.actions;
        _ = write!(
            chart,
            "{initial}step S{first}; step S{} {{ p; {one} }} step S{} {{ q; }} step S{} {{ r; }} step S{} {{ s; {four} }} step S{} {{ t; }} ",
            first + 1,
            first + 2,
            first + 3,
            first + 4,
            first + 5
        );
        let ask = |number: usize| kind.asks[number].replace("STEP", &format!("S{}", first + 1));
        let next = if first / 6 + 1 == count { 0 } else { first + 6 };
        _ = write!(
            chart,
            "S{first} -[a]-> (S{}, S{}); S{} -[{}]-> S{}; S{} -[{}]-> S{}; (S{}, S{}) -[d]-> S{}; S{} -[b && !a]-> S{next}; ",
            first + 1,
            first + 3,
            first + 1,
            ask(0),
            first + 2,
            first + 3,
            ask(1),
            first + 4,
            first + 2,
            first + 4,
            first + 5,
            first + 5
        );
    }
    chart + kind.more + " }"
}

/// Blocks of two branches, of which one forks again.
fn nested(dialect: &str, kind: Kind, count: usize) -> String {
    let mut chart =
        format!("{dialect} Nested {{ input a, b, c, d: bool; output n: u8; output p, q, r, s, t, u, v: bool; ");
    for block in 0..count {
        let step = |number: usize| format!("S{}", 8 * block + number);
        let [one, four] = kind.actions;
        let initial = if block == 0 { "initial " } else { "" };
        let does = ["", "p;", "q;", "r;", "s;", "t;", "u;", "v;"];
        for (number, does) in does.iter().enumerate() {
            let more = if number == 1 {
                one
            } else if number == 4 {
                four
            } else {
                ""
            };
            _ = write!(chart, "{}step {} {{ {does} {more} }} ", if number == 0 { initial } else { "" }, step(number));
        }
        let [ask, other] = kind.asks.map(|ask| ask.replace("STEP", &step(1)));
        let next = if block + 1 == count { "S0".to_owned() } else { format!("S{}", 8 * block + 8) };
        _ = write!(chart, "{} -[a]-> ({}, {}); ", step(0), step(1), step(2));
        _ = write!(chart, "{} -[b]-> ({}, {}); ", step(2), step(3), step(4));
        _ = write!(chart, "({}, {}) -[{other}]-> {}; ", step(3), step(4), step(5));
        _ = write!(chart, "{} -[{ask}]-> {}; ", step(1), step(6));
        _ = write!(chart, "({}, {}) -[d]-> {}; {} -[b && !a]-> {next}; ", step(5), step(6), step(7), step(7));
    }
    chart + kind.more + " }"
}

/// So many statements and operands stand on the longest way through some statements.
fn longest(statements: &[Statement<'_>]) -> usize {
    statements
        .iter()
        .map(|statement| match statement {
            Statement::Part(_, body) | Statement::Loop { body, .. } => longest(body),
            Statement::Set(_, value) => 1 + operands(value),
            Statement::If(condition, then, otherwise) => operands(condition) + longest(then).max(longest(otherwise)),
            Statement::Match(_, arms, otherwise) => {
                1 + arms.iter().map(|(_, body)| longest(body)).max().unwrap_or(0).max(longest(otherwise))
            }
            _ => 1,
        })
        .sum()
}

fn operands(expr: &Expr<'_>) -> usize {
    match expr {
        Expr::Not(inner) => operands(inner),
        Expr::All(parts) | Expr::Any(parts) => parts.iter().map(operands).sum(),
        Expr::Compare(_, a, b) | Expr::Add(a, b) | Expr::Sub(a, b) | Expr::Since(a, b) => operands(a) + operands(b),
        Expr::Choose(parts) => parts.iter().map(operands).sum(),
        Expr::User(user) => user.binds.iter().map(|(_, value)| operands(value)).sum(),
        _ => 1,
    }
}

fn cost(model: &Model) -> usize {
    longest(&optimised(model, &Pass::ALL).expect("a program").cycle)
}

/// Forty blocks ask as much in a cycle as five.
#[test]
fn parallel_branches_one_after_the_other_do_not_add_up() {
    for kind in KINDS {
        for dialect in kind.dialects {
            for chart in [blocks, nested] {
                let of = |count: usize| cost(&read(&chart(dialect, kind, count)));
                let (few, many) = (of(5), of(40));
                // Of so many blocks a pass may find another shape, as where a stop of many states is asked in front of the match on them.
                assert!(many <= few + 4, "{dialect}, {}: {few} with five blocks, {many} with forty", kind.name);
            }
        }
    }
}

/// They do what the interpreter does, each pass left out in turn.
#[test]
fn parallel_branches_one_after_the_other_do_what_they_should() {
    let inputs = [("a", false), ("b", false), ("c", false), ("d", false)];
    for kind in KINDS {
        for dialect in ["sfc", "grafcet"] {
            for chart in [blocks, nested] {
                each_left_out(&read(&chart(dialect, kind, 5)), &drawn(&inputs, 300), 20);
            }
        }
    }
}
