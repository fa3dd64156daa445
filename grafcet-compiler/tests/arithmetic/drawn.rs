//! What is said about random charts beside what happens under all values, in a program that panics where a result does not fit
//! into its type, and in one that goes on.

use crate::expr::{Build, Expr, NAMES, Random, Ty};
use crate::judged::said;

/// Comparisons that all hold, looked at one after the other.
struct All(Vec<(Expr, &'static str, Expr)>);

impl All {
    fn random(random: &mut Random, names: &[Ty], most: usize) -> Self {
        let count = 1 + random.below(most);
        let one = |random: &mut Random| {
            let ty =
                if random.below(3) > 0 { random.of(names) } else { random.of(&[Ty::U8, Ty::I8, Ty::U16, Ty::I16]) };
            let depth = random.below(3);
            let first = Expr::random(random, names, ty, depth);
            let second =
                if random.below(3) > 0 { Expr::constant(random, ty) } else { Expr::random(random, names, ty, 1) };
            (first, random.of(&["<", "<=", ">", ">=", "==", "!="]), second)
        };
        Self((0..count).map(|_| one(random)).collect())
    }

    fn text(&self) -> String {
        let texts: Vec<String> =
            self.0.iter().map(|(a, sign, b)| format!("({}) {sign} ({})", a.text(), b.text())).collect();
        texts.join(" && ")
    }

    /// One that is `said` is not run: what does not hold anyway asks for no result.
    fn holds(&self, values: &[i64], build: Build, said: bool) -> Option<bool> {
        let mut open = false;
        for (a, sign, b) in &self.0 {
            let (low, high) = a.ty().limits();
            let holds = match (a.value(values, build), b.value(values, build)) {
                (Some(a), Some(b)) => compare(a, sign, b),
                // No value of the type is beyond its end.
                (None, Some(b)) if !matches!(*sign, "==" | "!=") && compare(low, sign, b) == compare(high, sign, b) => {
                    compare(low, sign, b)
                }
                _ if !said => return None,
                _ => {
                    open = true;
                    continue;
                }
            };
            if !holds {
                return Some(false);
            }
        }
        (!open).then_some(true)
    }
}

fn compare(a: i64, sign: &str, b: i64) -> bool {
    match sign {
        "<" => a < b,
        "<=" => a <= b,
        ">" => a > b,
        ">=" => a >= b,
        "==" => a == b,
        _ => a != b,
    }
}

/// What happens under some values: the assumption, the three conditions, the property; none where the program panics.
type Case = [Option<bool>; 5];

fn cases(names: &[Ty], all: &[All; 5], build: Build) -> Vec<Case> {
    let range = |name: usize| names.get(name).map_or(0..=0, |ty| ty.limits().0..=ty.limits().1);
    let mut cases: Vec<Case> = Vec::new();
    for a in range(0) {
        for b in range(1) {
            let case = [0, 1, 2, 3, 4].map(|which: usize| all[which].holds(&[a, b], build, which % 4 == 0));
            if case[0] == Some(false) && !cases.contains(&case) {
                cases.push(case);
            }
        }
    }
    cases
}

/// A ring of three steps under some values.
struct Ring {
    /// Where cycles end, and of those that property holds there under the values of one.
    ends: [bool; 3],
    holds: [bool; 3],
    /// From one end of a cycle to that of the next one.
    leads: [[bool; 3]; 3],
}

impl Ring {
    /// None where a search turns for ever.
    fn of(cases: &[Case], is_grafcet: bool) -> Option<Self> {
        let mut ring = Self { ends: [false; 3], holds: [false; 3], leads: [[false; 3]; 3] };
        let mut holds = [[false; 3]; 3];
        for case in cases {
            if is_grafcet && (1..=3).all(|which| case[which] == Some(true)) {
                return None;
            }
            for (from, held) in holds.iter_mut().enumerate() {
                if let Some(to) = after(*case, from, is_grafcet) {
                    ring.leads[from][to] = true;
                    held[to] |= case[4] == Some(true);
                }
            }
        }
        // A27: the first cycle of an `sfc` evaluates no transition.
        if is_grafcet {
            (ring.ends, ring.holds) = (ring.leads[0], holds[0]);
        } else {
            ring.ends[0] = true;
            ring.holds[0] = cases.iter().any(|case| case[4] == Some(true));
        }
        for _ in 0..3 {
            for (from, to) in
                (0..9).map(|pair| (pair / 3, pair % 3)).filter(|(from, _)| ring.ends[*from]).collect::<Vec<_>>()
            {
                ring.ends[to] |= ring.leads[from][to];
                ring.holds[to] |= holds[from][to];
            }
        }
        Some(ring)
    }

    /// From where there is a way to the end of a cycle in the first step.
    fn ways_home(&self) -> [bool; 3] {
        let mut home = [true, false, false];
        for _ in 0..3 {
            for from in 0..3 {
                home[from] |= (0..3).any(|to| self.leads[from][to] && home[to]);
            }
        }
        home
    }
}

/// Where a cycle ends; none where the program panics.
fn after(case: Case, from: usize, is_grafcet: bool) -> Option<usize> {
    let mut at = from;
    while case[at + 1]? {
        at = (at + 1) % 3;
        if !is_grafcet {
            break;
        }
    }
    Some(at)
}

#[test]
fn properties_are_sound_under_all_values() {
    let [sfc, grafcet] = [("sfc", 260), ("grafcet", 260)].map(|(dialect, charts)| counts(dialect, charts));
    assert!(sfc.proved > 120 && sfc.violated > 70 && sfc.given_up < 10, "{sfc:?}");
    assert!(grafcet.proved > 120 && grafcet.violated > 50 && grafcet.given_up < 10, "{grafcet:?}");
}

#[derive(Default, Debug)]
struct Counts {
    proved: usize,
    violated: usize,
    /// What depends on results that do not fit into their types, and what does not.
    open: usize,
    given_up: usize,
}

fn counts(dialect: &str, charts: usize) -> Counts {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let mut counts = Counts::default();
    let is_grafcet = dialect == "grafcet";
    for round in 0..charts {
        let count = if round % 10 == 0 { 2 } else { 1 };
        let names: Vec<Ty> = (0..count).map(|_| random.of(&[Ty::U8, Ty::I8])).collect();
        let all = [2, 3, 3, 3, 2].map(|most| All::random(&mut random, &names, most));
        let (checked, wrapping) = (cases(&names, &all, Build::Checked), cases(&names, &all, Build::Wrapping));
        if checked.is_empty() || wrapping.is_empty() {
            continue;
        }
        let rings = (Ring::of(&checked, is_grafcet), Ring::of(&wrapping, is_grafcet));
        let (Some(sure), Some(possible)) = rings else { continue };
        let at = random.below(3);
        let inputs: Vec<String> =
            names.iter().zip(NAMES).map(|(ty, name)| format!("input {name}: {};", ty.name())).collect();
        let shared = format!(
            "{dialect} Chart {{ #![allow(grafcet::never_true, grafcet::always_true, grafcet::dead_transition, grafcet::deadlock, \
             grafcet::unreachable_step, grafcet::unused_input)] {} \
             output q, r: bool; assume never {}; \
             initial step A; step B {{ N q; }} step C {{ N r; }} A -[{}]-> B -[{}]-> C -[{}]-> A;",
            inputs.join(" "),
            all[0].text(),
            all[1].text(),
            all[2].text(),
            all[3].text()
        );
        let chart = format!("{shared} never {}.X && {}; }}", ["A", "B", "C"][at], all[4].text());
        let found = said(&chart);
        let has = |rule: &str| found.iter().any(|one| one.starts_with(rule));
        assert!(!has("notation"), "{chart}\n{found:?}");
        let is_clear = sure.leads == possible.leads && sure.holds == possible.holds;
        match (has("property_violated"), has("property_undecided")) {
            (true, false) => assert!(sure.holds[at], "{chart}\n{found:?}"),
            (false, false) => assert!(!possible.holds[at], "{chart}\n{found:?}"),
            _ if is_clear => counts.given_up += 1,
            _ => counts.open += 1,
        }
        *(if sure.holds[at] { &mut counts.violated } else { &mut counts.proved }) += 1;
        let chart = format!("{shared} home A; }}");
        let found = said(&chart);
        let has = |rule: &str| found.iter().any(|one| one.starts_with(rule));
        let (certain, maybe) = (sure.ways_home(), possible.ways_home());
        match (has("not_home"), has("property_undecided")) {
            (true, false) => assert!((0..3).any(|end| sure.ends[end] && !maybe[end]), "{chart}\n{found:?}"),
            // Wherever it can come to, it can go on without a panic.
            (false, false) => assert!((0..3).all(|end| !possible.ends[end] || certain[end]), "{chart}\n{found:?}"),
            _ if is_clear => counts.given_up += 1,
            _ => counts.open += 1,
        }
    }
    counts
}
