//! A30: what the compiler says of the length of a search, beside an interpreter that looks for longer.

use grafcet_compiler::analysis::{Facts, Stability};
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::{self, Model};
use grafcet_compiler::parse;
use grafcet_conformance::oracle::Interpreted;
use grafcet_conformance::random::Rng;
use grafcet_conformance::{Subject as _, Values};

/// Longer than any search of these charts that ends.
const LONG: u32 = 200;

/// Writes charts of branches, loops and sequences beside each other, whose conditions look at inputs and at times of the step in front.
struct Writer<'r> {
    rng: &'r mut Rng,
    steps: Vec<String>,
    transitions: Vec<String>,
}

impl Writer<'_> {
    fn step(&mut self, is_initial: bool) -> usize {
        let number = self.steps.len();
        self.steps.push(format!("{}step S{number};", if is_initial { "initial " } else { "" }));
        number
    }

    fn goes(&mut self, from: &[usize], to: &[usize]) {
        let list = |steps: &[usize]| {
            let names: Vec<String> = steps.iter().map(|step| format!("S{step}")).collect();
            if names.len() == 1 { names[0].clone() } else { format!("({})", names.join(", ")) }
        };
        let timed = format!("2ms/S{}", from[0]);
        let likely = ["a", "b", "a && b", "!c", "c || a", "true"];
        let other = ["rising(a)", "!rising(b)", "falling(c) || a", &timed];
        let condition = if self.rng.chance(80) { self.rng.pick(&likely) } else { self.rng.pick(&other) };
        self.transitions.push(format!("{} -[{condition}]-> {};", list(from), list(to)));
    }

    /// A sequence from one step to the last of it, with forks up to a depth; it may lead back to where it came by.
    fn sequence(&mut self, first: usize, depth: usize) -> usize {
        let (mut at, mut passed) = (first, vec![first]);
        for _ in 0..self.rng.between(1, 3) {
            if depth > 0 && self.rng.chance(50) {
                let begins: Vec<usize> = (0..self.rng.between(2, 3)).map(|_| self.step(false)).collect();
                self.goes(&[at], &begins);
                let ends: Vec<usize> = begins.iter().map(|begin| self.sequence(*begin, depth - 1)).collect();
                at = self.step(false);
                self.goes(&ends, &[at]);
            } else {
                let next = self.step(false);
                self.goes(&[at], &[next]);
                at = next;
            }
            passed.push(at);
        }
        if self.rng.chance(if depth == 2 { 40 } else { 8 }) {
            let back = *self.rng.pick(&passed);
            if back != at {
                self.goes(&[at], &[back]);
            }
        }
        at
    }

    fn chart(rng: &mut Rng) -> String {
        let mut writer = Writer { rng, steps: Vec::new(), transitions: Vec::new() };
        for _ in 0..writer.rng.between(1, 2) {
            let first = writer.step(true);
            let last = writer.sequence(first, 2);
            writer.goes(&[last], &[first]);
        }
        format!("{} {}", writer.steps.join(" "), writer.transitions.join(" "))
    }
}

fn bounded(body: &str, bound: u32) -> Model {
    let text = format!("grafcet G {{ max_evolutions {bound}; input a, b, c: bool; {body} }}");
    // Circles are looked for that the checker would refuse.
    let mut sink = Sink::new();
    let chart = parse::chart(text.parse().expect("tokens"), &mut sink).expect("a chart");
    let model = model::resolve(&chart, &mut sink);
    assert!(!model.incomplete, "{text}");
    _ = sink.finish();
    model
}

/// After how many evolutions a search goes on for ever, as the compiler says.
fn claimed(model: &Model) -> Option<u32> {
    let facts = Facts::of(model);
    (1..100).find(|evolutions| Stability::goes_on_after(model, &facts.concurrency, *evolutions))
}

/// How many searches of some cycles have made as many evolutions as the claim says, all of which have to go on.
fn given_up(rng: &mut Rng, body: &str, claim: u32) -> usize {
    let (short, long) = (bounded(body, claim), bounded(body, LONG));
    let mut found = 0;
    for _ in 0..8 {
        let (mut one, mut other) = (Interpreted::new(&short).expect("read"), Interpreted::new(&long).expect("read"));
        let mut now = 0;
        for _ in 0..12 {
            let input = |name: &str, rng: &mut Rng| (name.to_owned(), i128::from(rng.chance(70)));
            let inputs: Values = ["a", "b", "c"].iter().map(|name| input(name, rng)).collect();
            now += u32::try_from(rng.below(4)).unwrap_or_default();
            let (shown, longer) =
                (one.cycle(&inputs, now).expect("a cycle"), other.cycle(&inputs, now).expect("a cycle"));
            assert_eq!(
                shown.stable, longer.stable,
                "given up after {claim} evolutions at {now} with {inputs:?}\n{body}"
            );
            if !shown.stable {
                found += 1;
                break;
            }
            assert_eq!(shown, longer, "{body}");
        }
    }
    found
}

#[test]
fn a30_what_has_made_as_many_evolutions_as_the_compiler_says_goes_on_for_ever() {
    let (mut claims, mut found) = (0, 0);
    let mut rng = Rng::new(30);
    for _ in 0..300 {
        let body = Writer::chart(&mut rng);
        if let Some(claim) = claimed(&bounded(&body, LONG)) {
            claims += 1;
            found += given_up(&mut rng, &body, claim);
        }
    }
    assert!(claims > 120 && found > 300, "{claims} claims, {found} searches given up");
}

/// A fork of two branches: two evolutions for edges, two through a branch, and each step that is active alone once.
#[test]
fn the_longest_search_is_a_path() {
    let body = "initial step A; step B1; step C1; step B2; A -[a]-> (B1, C1); B1 -[b]-> B2; (B2, C1) -[c]-> A;";
    assert_eq!(claimed(&bounded(body, LONG)), Some(2 + 2 + 3 + 1));
}

#[test]
fn of_these_nothing_is_said() {
    for body in [
        // A circle within a branch: it turns until the other one lets it out.
        "initial step A; step B1; step C1; step B2; A -[a]-> (B1, C1); B1 -[b]-> B2; B2 -[b]-> B1; (B2, C1) -[c]-> A;",
        // A condition that looks at another step.
        "initial step A; step B1; step C1; step B2; A -[a]-> (B1, C1); B1 -[C1.X]-> B2; (B2, C1) -[c]-> A;",
        // What a step counts.
        "var n: u8 = 0; initial step A; step B1 { P1 n = (n + 1) % 9; } step C1; A -[a]-> (B1, C1); (B1, C1) -[n < 7]-> A;",
        // A time of another step.
        "initial step A; step B1; step C1; step B2; A -[a]-> (B1, C1); B1 -[2ms/C1]-> B2; (B2, C1) -[c]-> A;",
        // A transition that leaves nothing.
        "initial step A; step B1; step C1; A -[a]-> (B1, C1); (B1, C1) -[c]-> A; () -[rising(b)]-> B1;",
        // What happens on an event may be another event.
        "var n: u8 = 0; initial step A; step B { on rising(n < 3) n = n + 3; } step C; A -[a]-> (B, C); (B, C) -[c]-> A;",
        // A transition of every step comes before all others.
        "initial step A; step B; step C; step D; A -[a]-> (B, C); (B, C) -[c]-> A; any -[b]-> D; D -[!b]-> A;",
        // What is enclosed begins again, what is forced waits.
        "partial Top { initial step Off; enclosing step On { partial Low { linked step A; step B; step C; \
            A -[a]-> (B, C); (B, C) -[c]-> A; } } Off -[b]-> On; On -[!b]-> Off; }",
        "partial Top { initial step Off { force Low { A }; } step On; Off -[b]-> On; On -[!b]-> Off; } partial Low { initial step A; step B; step C; \
            A -[a]-> (B, C); (B, C) -[c]-> A; }",
        // What is forced by hand has not come about so.
        "forceable; initial step A; step B; step C; A -[a]-> (B, C); (B, C) -[c]-> A;",
    ] {
        assert_eq!(claimed(&bounded(body, LONG)), None, "{body}");
    }
}
