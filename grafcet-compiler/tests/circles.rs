//! Circles that turn in one cycle (A30): those that always do once they are entered, and those that may.

use grafcet_compiler::analysis::circles::{Circle, Circles};
use grafcet_compiler::analysis::explore::{Exploration, Limits};
use grafcet_compiler::analysis::{Facts, Logic};
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::{self, Id, Model};
use grafcet_compiler::parse;

fn model(text: &str) -> Model {
    let names = "input a, b, c, d: bool; input level: u16; var n: u16 = 0; param soak: time = 5s; action call();";
    let text = format!("grafcet C {{ {names} {text} }}");
    let mut sink = Sink::new();
    let chart = parse::chart(text.parse().expect("tokens"), &mut sink).expect("a chart");
    let model = model::resolve(&chart, &mut sink);
    let messages: Vec<String> = sink.finish().into_iter().flat_map(|d| d.notes).map(|(_, text)| text).collect();
    assert_eq!(messages, [""; 0], "{text}");
    model
}

/// `A B, C D`: the sources of each circle's transitions, sorted.
fn names(model: &Model, circles: &[Circle]) -> String {
    let one = |circle: &Circle| {
        let sources = circle.transitions.iter().flat_map(|id| &model.transitions[*id].sources);
        let mut names: Vec<String> = sources.map(|step| model.steps[*step].name.to_string()).collect();
        names.sort();
        names.dedup();
        names.join(" ")
    };
    let mut all: Vec<String> = circles.iter().map(one).collect();
    all.sort();
    all.join(", ")
}

/// Asserts which circles certainly turn.
fn certain(text: &str, expected: &str) {
    let model = model(text);
    let facts = Facts::of(&model);
    let logic = Logic::within(&model, &facts.concurrency, &[]);
    let found = Circles::new(&model, &facts.concurrency, &logic, &facts.initial).certain();
    assert_eq!(names(&model, &found), expected, "{text}");
}

/// Asserts which circles may turn, and with which inputs.
fn possible(text: &str, expected: &[&str]) {
    let model = model(text);
    let facts = Facts::of(&model);
    let logic = Logic::within(&model, &facts.concurrency, &[]);
    let circles = Circles::new(&model, &facts.concurrency, &logic, &facts.initial);
    let mut found: Vec<String> = circles.possible(&circles.certain()).into_iter().map(|circle| circle.inputs).collect();
    found.sort();
    assert_eq!(found, expected, "{text}");
}

const AB: &str = "initial step A; step B; step C; step K;";

#[test]
fn equal_conditions_turn() {
    certain(&format!("{AB} A -[a]-> B -[a]-> A;"), "A B");
    certain(&format!("{AB} A -[a && !b]-> B -[!(b || !a)]-> A;"), "A B");
    certain(&format!("{AB} A -[a]-> B -[true]-> A;"), "A B");
    certain(&format!("{AB} A -[true]-> B -[true]-> C -[true]-> A;"), "A B C");
    certain(&format!("{AB} A -[level > 5]-> B -[level >= 6]-> C -[5 < level]-> A;"), "A B C");
    certain(&format!("{AB} A -[3s/a]-> B -[3s/a]-> A;"), "A B");
    certain(&format!("{AB} A -[b]-> B -[a]-> C -[a]-> B; C -[d]-> K -[d]-> K;"), "B C");
}

#[test]
fn what_is_held_at_power_up() {
    // `A` is never left in peace: the circle is entered in the very first cycle alone.
    certain("initial step A; step B; final step E; A -[a]-> B -[a]-> A; A -[!a]-> E;", "A B");
    certain("initial step A; step B; step E; A -[a]-> B -[a || b]-> A; A -[!a]-> E -[rising(a)]-> A;", "A B");
    certain("initial step A; step B; final step E; A -[a]-> B -[b]-> A; A -[!a]-> E;", "");
    // There is no edge in the first cycle.
    certain("initial step A; step B; final step E; A -[rising(a)]-> B -[a]-> A; A -[true]-> E;", "");
    certain("initial step A; step B; final step E; A -[5s/A]-> B -[true]-> A; A -[!(5s/A)]-> E;", "");
}

#[test]
fn combinational_variables_are_what_their_steps_assert() {
    certain("var v: bool; initial step A; step B { v; } A -[a]-> B -[v]-> A;", "A B");
    certain("var v: bool; initial step A { v if a; } step B; A -[v]-> B -[!v && a]-> A;", "A B");
    certain("var v, w: bool; initial step A; step B { v if b; w if v; } A -[a && b]-> B -[w]-> A;", "A B");
    certain("var v: bool; initial step A; step B { L 3s v; } A -[a]-> B -[v]-> A;", "A B");
    certain("var v: bool; initial step A; step B { D 3s v; } A -[a]-> B -[v]-> A;", "");
    certain("var v: bool; initial step A; step B { v if b; } A -[a]-> B -[v]-> A;", "");
    certain("var v: bool; initial step A; step B { v; } A -[a]-> B -[!v]-> A; B -[v]-> K; step K; K -[b]-> A;", "");
}

#[test]
fn further_inputs_have_to_coincide() {
    for chart in [
        "A -[a]-> B -[b]-> A;",
        "A -[a || b]-> B -[a]-> A;",
        "A -[a]-> B -[b]-> C -[c]-> K -[d]-> A;",
        "A -[level > 5]-> B -[level > 6]-> A;",
        "A -[a]-> B -[!a]-> A;",
        "A -[a]-> B -[!d]-> A; B -[d]-> C -[b]-> A;",
    ] {
        certain(&format!("{AB} {chart}"), "");
    }
    possible(&format!("{AB} A -[a]-> B -[b]-> A;"), &["a = true, b = true"]);
    possible(&format!("{AB} A -[a || b]-> B -[a]-> A;"), &["a = true"]);
    possible(&format!("{AB} A -[a]-> B -[b]-> C -[c]-> K -[d]-> A;"), &["a = true, b = true, c = true, d = true"]);
    possible(&format!("{AB} A -[level > 5]-> B -[level < 9]-> A;"), &["level = 6"]);
    possible(&format!("{AB} A -[a]-> B -[!a]-> A;"), &[]);
    possible(&format!("{AB} A -[a]-> B -[a]-> A;"), &[]);
    possible(
        &format!("{AB} A -[a]-> B -[b]-> A; B -[c && !b]-> C -[a]-> A;"),
        &["a = true, b = false, c = true", "a = true, b = true"],
    );
}

#[test]
fn what_a_circle_can_be_entered_by_counts() {
    // `B` is never at rest: who comes there with `a && b` goes on at once.
    certain(&format!("{AB} A -[a && b]-> B -[a]-> A;"), "A B");
    certain(&format!("{AB} A -[a]-> B -[a || b]-> A;"), "A B");
    // Unless something else leads there.
    certain(&format!("{AB} A -[a && b]-> B -[a]-> A; A -[!a]-> B;"), "");
    certain("step A; initial step B; A -[a && b]-> B -[a]-> A;", "");
    // Entered from outside, where it turns whatever the inputs are.
    certain(&format!("{AB} A -[a]-> B -[true]-> C -[true]-> B;"), "B C");
    certain(&format!("{AB} A -[a]-> B -[true]-> C -[!b]-> B; C -[b]-> K -[!a]-> A;"), "");
}

#[test]
fn what_ends_within_the_cycle_is_no_reason_to_turn() {
    for chart in [
        "A -[rising(a)]-> B -[rising(a)]-> A;",
        "A -[rising(a)]-> B -[a]-> A;",
        "A -[falling(a)]-> B -[!a]-> A;",
        "A -[a]-> B -[5s/B && a]-> A;",
        "A -[a]-> B -[soak/B && a]-> A;",
        "A -[a]-> B -[a && B.T > 0s]-> A;",
        "A -[a && n < 3 => n = n + 1]-> B -[a]-> A;",
    ] {
        certain(&format!("{AB} {chart}"), "");
    }
    certain(&format!("{AB} A -[a]-> B -[a && B.T < 3s]-> A;"), "A B");
    certain(&format!("{AB} A -[a && n < 3]-> B -[a]-> A;"), "A B");
    certain(&format!("{AB} A -[a && n < 3]-> B -[a]-> A; B -[b && !a => n = 5]-> C -[d]-> A;"), "");
    certain(&format!("{AB} A -[a]-> B -[a && 0s/B]-> A;"), "A B");
}

#[test]
fn loops_of_one_step() {
    // Nothing changes (A25).
    certain(&format!("{AB} A -[a]-> A; A -[b]-> B -[c]-> A;"), "");
    certain(&format!("{AB} A -[a => n = 0]-> A;"), "");
    // Something does; its own time goes on (A4g).
    certain(&format!("{AB} A -[a => n = n + 1]-> A;"), "A");
    certain(&format!("{AB} A -[a => call()]-> A;"), "A");
    certain(&format!("{AB} A -[5s/A => n = n + 1]-> A;"), "A");
    certain(&format!("{AB} A -[a => {{ n += 1; }}]-> A;"), "A");
    certain(&format!("{AB} A -[rising(a) => n = n + 1]-> A;"), "");
    certain(&format!("{AB} A -[a && n < 5 => n = n + 1]-> A;"), "");
}

#[test]
fn what_goes_on_without_a_transition_is_no_circle() {
    let ring = "A -[a]-> B -[rising(b)]-> C; C -[rising(b) || 400ms/A]-> K; K -[c]-> A; A -[f(d)]-> A; C -[else]-> C;";
    possible(&format!("{AB} {ring}"), &[]);
}

#[test]
fn parallel_branches() {
    certain(&format!("{AB} A -[a]-> (B, C); (B, C) -[a]-> A;"), "A B C");
    certain(&format!("{AB} A -[a]-> (B, C); B -[a]-> K; (K, C) -[a]-> A;"), "A B C K");
    certain(&format!("{AB} A -[a]-> (B, C); (B, C) -[b]-> A;"), "");
    certain(&format!("{AB} A -[a]-> (B, C); B -[b]-> K; (K, C) -[a]-> A;"), "");
    // Inside of one branch.
    certain(&format!("{AB} step E; A -[a]-> (B, C); B -[b]-> K -[b]-> B; (K, C) -[!b && c]-> A;"), "B K");
    // Two marks in one circle change places: nothing changes.
    certain("initial step A; initial step B; A -[a]-> B -[a]-> A;", "");
    possible(&format!("{AB} A -[a]-> (B, C); (B, C) -[b]-> A;"), &["a = true, b = true"]);
}

#[test]
fn step_variables() {
    // `C` waits beside, so both conditions hold as long as it does.
    certain(&format!("{AB} A -[a]-> (B, C); B -[C.X]-> K -[C.X]-> B;"), "B K");
    certain(&format!("{AB} A -[a]-> (B, C); B -[C.X]-> K -[C.X]-> B; (B, C) -[!a && d]-> A;"), "B K");
    certain(&format!("{AB} A -[a]-> (B, C); B -[C.X]-> K -[C.X]-> B; (B, C) -[a && d]-> A;"), "A B C K, B K");
    certain(&format!("{AB} A -[a && !C.X]-> B -[a && !A.X]-> A;"), "A B");
    certain(&format!("{AB} A -[a]-> B -[a && A.X]-> A;"), "");
    // An edge of a step belongs to the evolution in which the step changes.
    certain(&format!("{AB} A -[a]-> B -[rising(B.X)]-> A;"), "A B");
    certain(&format!("{AB} A -[a]-> B -[falling(B.X)]-> A;"), "");
    // Two partial grafcets that turn each other.
    certain(
        "partial Left { initial step A; step B; A -[C.X]-> B -[K.X]-> A; }
         partial Right { initial step C; step K; C -[B.X]-> K -[A.X]-> C; }",
        "A B C K",
    );
    certain(
        "partial Left { initial step A; step B; A -[C.X && a]-> B -[K.X]-> A; }
         partial Right { initial step C; step K; C -[B.X]-> K -[A.X]-> C; }",
        "A B C K",
    );
    certain(
        "partial Left { initial step A; step B; A -[C.X && a]-> B -[K.X && b]-> A; }
         partial Right { initial step C; step K; C -[B.X]-> K -[A.X]-> C; }",
        "",
    );
}

/// An order that appears in the middle of a search, or the end of an enclosing step, ends the circle.
#[test]
fn commands() {
    let work = "partial Work { initial step A; step B; step C; A -[a]-> B -[a]-> C -[a]-> A; }";
    let master = |order: &str, way: &str| {
        format!("partial Master {{ initial step Run; step Soon; step Held {{ force Work {order}; }} {way} }} {work}")
    };
    for order in ["{*}", "{A}", "{INIT}", "{}"] {
        certain(&master(order, "Run -[b]-> Held -[!b]-> Run;"), "A B C");
        certain(&master(order, "Run -[b]-> Held -[!b && 1s/Held]-> Run;"), "A B C");
        certain(&master(order, "Run -[b]-> Held -[!d]-> Run;"), "");
        certain(&master(order, "Run -[b]-> Soon -[true]-> Held -[!b]-> Run;"), "");
        certain(&master(order, "Run -[B.X]-> Held -[b && !a]-> Run;"), "");
        certain(&master(order, "Run -[n > 3]-> Held -[b && !a]-> Run;"), "");
    }
    let enclosed = |way: &str| {
        let work = work.replace("initial", "linked");
        format!("partial Master {{ initial step Off; enclosing step Auto {{ {work} }} step Off2; {way} }}")
    };
    certain(&enclosed("Off -[b]-> Auto -[!b]-> Off;"), "A B C");
    certain(&enclosed("Off -[b]-> Auto -[C.X]-> Off2 -[!b]-> Off;"), "");
    certain(&enclosed("Off -[b]-> Auto -[d]-> Off2 -[!b]-> Off;"), "");
}

#[test]
fn long_charts() {
    let steps =
        |n: usize| (1..n).map(|i| format!("step S{i};")).fold("initial step S0;".to_owned(), |all, one| all + &one);
    let arrow = |i: usize, condition: &str| format!("S{i} -[{condition}]-> S{};", (i + 1) % 300);
    let ring = |condition: &str| (0..300).map(|i| arrow(i, condition)).fold(String::new(), |all, one| all + &one);
    certain(&format!("{} {}", steps(300), ring("rising(a)")), "");
    let mut model_text = steps(300);
    model_text.push_str(&ring("a"));
    let model = model(&model_text);
    let facts = Facts::of(&model);
    let logic = Logic::within(&model, &facts.concurrency, &[]);
    assert_eq!(Circles::new(&model, &facts.concurrency, &logic, &facts.initial).certain().len(), 1);
}

/// A chart with one mark: the transitions that leave a step exclude each other.
struct OneMark {
    steps: usize,
    /// From, to, what `holds` looks up.
    arrows: Vec<(usize, usize, Wants)>,
}

/// A condition over `a` and `b`.
#[derive(Clone)]
enum Wants {
    Level([bool; 4]),
    RisingA(bool),
    /// What the other branch leaves over, and `b`.
    Rest(Box<Wants>),
}

impl Wants {
    fn holds(&self, before: Option<[bool; 2]>, now: [bool; 2]) -> bool {
        match self {
            Self::Level(table) => table[usize::from(now[0]) + 2 * usize::from(now[1])],
            Self::RisingA(b) => before.is_some_and(|before| !before[0]) && now[0] && (now[1] || !b),
            Self::Rest(other) => !other.holds(before, now) && now[1],
        }
    }

    fn text(&self) -> String {
        match self {
            Self::Level(table) => {
                let terms = ["!a && !b", "a && !b", "!a && b", "a && b"];
                let terms: Vec<_> = terms.iter().zip(table).filter(|(_, on)| **on).map(|(term, _)| *term).collect();
                if terms.is_empty() { "false".to_owned() } else { terms.join(" || ") }
            }
            Self::RisingA(true) => "rising(a) && b".to_owned(),
            Self::RisingA(false) => "rising(a)".to_owned(),
            Self::Rest(other) => format!("!({}) && b", other.text()),
        }
    }
}

impl OneMark {
    fn make(random: &mut u64) -> Self {
        let mut draw = |below: usize| {
            *random ^= *random << 13;
            *random ^= *random >> 7;
            *random ^= *random << 17;
            usize::try_from(*random >> 20).unwrap_or_default() % below
        };
        let steps = 2 + draw(3);
        let mut arrows = Vec::new();
        for from in 0..steps {
            let mut other = || (from + 1 + draw(steps - 1)) % steps;
            let (to, second) = (other(), other());
            let wants = match draw(6) {
                0 => Wants::RisingA(draw(2) == 0),
                1 => Wants::Level([true; 4]),
                _ => Wants::Level([draw(3) == 0, draw(2) == 0, draw(2) == 0, draw(3) > 0]),
            };
            if draw(3) == 0 && to != second {
                arrows.push((from, second, Wants::Rest(Box::new(wants.clone()))));
            }
            arrows.push((from, to, wants));
        }
        Self { steps, arrows }
    }

    fn text(&self) -> String {
        let steps = (0..self.steps).map(|step| format!("{}step S{step};", if step == 0 { "initial " } else { "" }));
        let arrows = self.arrows.iter().map(|(from, to, wants)| format!("S{from} -[{}]-> S{to};", wants.text()));
        steps.chain(arrows).collect::<Vec<_>>().join("\n")
    }

    /// The search from a step: what clears first, and where it comes to rest or which transitions turn.
    fn search(
        &self,
        start: usize,
        before: Option<[bool; 2]>,
        now: [bool; 2],
    ) -> (Option<usize>, Result<usize, Vec<usize>>) {
        let (mut at, mut before, mut cleared) = (start, before, Vec::new());
        loop {
            let next = self.arrows.iter().position(|(from, _, wants)| *from == at && wants.holds(before, now));
            let Some(next) = next else { return (cleared.first().copied(), Ok(at)) };
            // Two laps are enough for all of the circle to be one.
            if cleared.len() > 3 * self.arrows.len() {
                let mut circle: Vec<usize> = cleared.split_off(2 * self.arrows.len());
                circle.sort_unstable();
                circle.dedup();
                return (cleared.first().copied(), Err(circle));
            }
            cleared.push(next);
            at = self.arrows[next].1;
            before = Some(now);
        }
    }

    /// The circles that turn whenever one of their transitions clears in a situation that can be reached and is stable.
    fn certain(&self) -> Vec<Vec<usize>> {
        let inputs = [[false, false], [true, false], [false, true], [true, true]];
        let mut seen = vec![(0, None)];
        // A first situation that no inputs leave as it is, is never stable.
        let rests = inputs.iter().any(|now| self.search(0, None, *now).0.is_none());
        let (mut found, mut calm): (Vec<Vec<usize>>, Vec<usize>) = (Vec::new(), Vec::new());
        let mut next = 0;
        while let Some((step, before)) = seen.get(next).copied() {
            next += 1;
            for now in inputs {
                match self.search(step, before, now) {
                    (first, Ok(rest)) => {
                        calm.extend(first.filter(|_| rests || before.is_some()));
                        if !seen.contains(&(rest, Some(now))) {
                            seen.push((rest, Some(now)));
                        }
                    }
                    (_, Err(circle)) if !found.contains(&circle) => found.push(circle),
                    (_, Err(_)) => {}
                }
            }
        }
        found.retain(|circle| !circle.iter().any(|transition| calm.contains(transition)));
        found.sort();
        found
    }
}

/// Whoever reports a circle that can come to rest refuses a good chart.
#[test]
fn verdicts_equal_those_of_all_searches() {
    let mut random = 0x9E37_79B9_7F4A_7C15;
    let mut circles = 0;
    for _ in 0..1500 {
        let chart = OneMark::make(&mut random);
        let text = chart.text();
        let model = model(&text);
        let facts = Facts::of(&model);
        let logic = Logic::within(&model, &facts.concurrency, &[]);
        let expected = chart.certain();
        let mut found: Vec<Vec<usize>> = Circles::new(&model, &facts.concurrency, &logic, &facts.initial)
            .certain()
            .into_iter()
            .map(|circle| {
                let mut ids: Vec<usize> = circle.transitions.into_iter().map(Id::index).collect();
                ids.sort_unstable();
                ids
            })
            .collect();
        found.sort();
        assert_eq!(found, expected, "{text}");
        circles += found.len();
    }
    assert!(circles > 200, "{circles} circles");
}

/// The searches say so, too, of a circle of which a step is left and entered beside it, by transitions whose own searches come to rest.
#[test]
fn what_gives_a_step_back_is_no_part_of_a_circle() {
    let both = "initial step A; initial step B; step C; step E; (A, B) -[a]-> C; C -[true]-> B;";
    for beside in ["A -[a || b]-> A;", "A -[a || b]-> A; A -[b && !b]-> E;"] {
        let model = model(&format!("{both} {beside}"));
        let found = Exploration::of(&model, &Limits::default()).endless(&model).expect("it is known");
        let circles: Vec<Circle> =
            found.into_iter().map(|transitions| Circle { transitions, inputs: String::new() }).collect();
        assert_eq!(names(&model, &circles), "A B C", "{beside}");
    }
    // One that can come to rest is none.
    let model = model("initial step A; step B; A -[a]-> B; B -[b]-> A;");
    assert_eq!(Exploration::of(&model, &Limits::default()).endless(&model), Some(Vec::new()));
}
