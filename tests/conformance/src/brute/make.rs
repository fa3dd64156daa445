//! Small random charts, right and wrong ones: the same number is the same chart on every machine.

use std::fmt::Write as _;

use super::draw::Arrow;
use super::hierarchy::Body;
use super::memories::{self, Over};
use super::words::Words;
use crate::random::Rng;

/// The lints: random charts are not sensible ones.
const ALLOWED: &str = "\
    several_initial_steps unreachable_step dead_transition unsafe_step stuck_join deadlock never_true always_true \
    shadowed_branch overlapping_branches level_source_transition conflicting_values write_race set_without_reset \
    reset_without_set timed_contention unused_input undriven_output unused_variable unused_action unused_param unused_let";

/// The attribute that allows the lints.
#[must_use]
pub fn allowed() -> String {
    let rules: Vec<String> = ALLOWED.split_whitespace().map(|rule| format!("grafcet::{rule}")).collect();
    format!("#![allow({})]", rules.join(", "))
}

/// How a chart is made.
pub(super) struct Maker {
    pub(super) rng: Rng,
    pub(super) grafcet: bool,
    /// Whether conditions read times.
    pub(super) timed: bool,
    /// How many steps have been named.
    pub(super) steps: usize,
    /// How many partial grafcets have been named.
    pub(super) partials: usize,
}

/// The text of a chart: one declaration, association or transition a line, so that a line can be left out.
#[must_use]
pub fn chart(number: u64, grafcet: bool, timed: bool) -> String {
    let mut maker = Maker { rng: Rng::new(number ^ 0x5eed), grafcet, timed, steps: 0, partials: 0 };
    let bodies = maker.bodies();
    let mut words = Words::new(&mut maker, &bodies);
    let mut lines = vec![format!("{} C {{", if grafcet { "grafcet" } else { "sfc" }), allowed()];
    let mut inside = Vec::new();
    for body in &bodies {
        maker.write(body, &mut words, &mut inside);
    }
    lines.append(&mut words.declarations());
    lines.append(&mut inside);
    lines.append(&mut words.claims(&mut maker));
    lines.push("}".to_owned());
    let mut text = String::new();
    for line in lines {
        _ = writeln!(text, "{line}");
    }
    // Where all times are the same, brute force sees all that can happen.
    if timed && number % 2 == 1 { text.replace("1s", "5s").replace("1m", "5s") } else { text }
}

/// The same chart, which counts, and claims something of the count, of its variables and, where it is timed, of the times of its steps.
#[must_use]
pub fn counting(number: u64, grafcet: bool, timed: bool) -> String {
    let mut rng = Rng::new(number ^ 0xc0_047);
    let (mut lines, mut steps, mut vars) = (Vec::new(), Vec::new(), Vec::new());
    for line in chart(number, grafcet, timed).lines() {
        lines.push(line.to_owned());
        if let Some(name) = line.strip_prefix("var ").and_then(|rest| rest.split(':').next()) {
            vars.push(name.to_owned());
        }
        let named =
            line.strip_suffix(" {").and_then(|line| line.split_once("step ")).filter(|_| !line.contains("macro"));
        if let Some((_, name)) = named {
            steps.push(name.to_owned());
            if rng.chance(50) {
                lines.push((*rng.pick(&["P1 n = (n + 1) % 4;", "P1 n = n / 2;", "P1 n = 3;"])).to_owned());
            }
        }
    }
    lines.insert(2, "var n: u8 = 0;".to_owned());
    let end = lines.len() - 1;
    for _ in 0..3 {
        let step = rng.pick(&steps).clone();
        let mut some = vec![format!("n == {}", rng.below(5)), format!("n < {} && {step}.X", rng.between(1, 4))];
        some.extend(vars.iter().map(|var| format!("{var} && {step}.X")));
        if timed {
            some.push(format!("{step}.T {} {}s", rng.pick(&["<", ">=", ">", "=="]), rng.pick(&[1, 5, 7])));
            some.push(format!("{}s/{step}", rng.pick(&[1, 5])));
        }
        let (what, other) = (rng.pick(&some).clone(), rng.pick(&some).clone());
        let claim = match rng.below(3) {
            0 => format!("never {what};"),
            1 => format!("always {what} => {other};"),
            _ => format!("always {what} || {other};"),
        };
        lines.insert(end, claim);
    }
    lines.join("\n") + "\n"
}

/// What brute force takes for a param with a range: an input has another value in each cycle, too, and an assumption keeps it in the range.
const AS_INPUT: &str = "input k: u8;\nassume never k < 1 || k > 3;\n";

/// A counting chart that counts by a value between two bounds and claims something of it: every third one.
#[must_use]
pub fn by_recipe(chart: &str, number: u64) -> String {
    // Brute force goes through all values of numbers.
    if number % 3 != 0
        || chart.contains("u8;\ninput")
        || chart.contains("input level")
        || !chart.contains("var n: u8 = 0;\n")
    {
        return chart.to_owned();
    }
    let chart = chart.replace("P1 n = 3;", "P1 n = k;").replace("P1 n = n / 2;", "P1 n = (n + k) % 4;");
    let claims = chart.replace("n == 2", "n == k").replace("n < 3", "n < k");
    claims.replacen("var n: u8 = 0;\n", &format!("{AS_INPUT}var n: u8 = 0;\n"), 1)
}

/// The same with the param.
#[must_use]
pub fn with_param(chart: &str) -> String {
    chart.replace(AS_INPUT, "param k: u8 in 1..=3 = 2;\n")
}

/// The variants of the enum.
const VARIANTS: [&str; 3] = ["Idle", "Busy", "Done"];

/// A counting chart that keeps a variant of an enum, asks for one in some conditions, and claims something of both: every third one.
#[must_use]
pub fn with_modes(chart: &str, number: u64) -> String {
    if number % 3 != 1 {
        return chart.to_owned();
    }
    let mut rng = Rng::new(number ^ 0xe_117);
    let asked = rng.chance(60);
    let some = |rng: &mut Rng| match rng.below(if asked { 5 } else { 3 }) {
        0 => format!("m == Mode::{}", rng.pick(&VARIANTS)),
        1 => format!("m != Mode::{}", rng.pick(&VARIANTS)),
        2 => format!("matches!(m, Mode::{} | Mode::{})", rng.pick(&VARIANTS), rng.pick(&VARIANTS)),
        _ => format!("i == Mode::{}", rng.pick(&VARIANTS)),
    };
    let mut lines = Vec::new();
    for line in chart.lines() {
        let claims = ["never ", "always "].iter().any(|word| line.starts_with(word))
            || line.contains(" leads_to ")
            || line.contains(" before ");
        let mut line = line.to_owned();
        if claims {
            for count in ["n == 0", "n == 2", "n == 3", "n < 2"] {
                if line.contains(count) {
                    line = line.replacen(count, &some(&mut rng), 1);
                }
            }
        } else if let (Some(at), true) = (line.find("-["), rng.chance(30)) {
            let mode = some(&mut rng);
            line = format!("{}-[{mode}]->{}", &line[..at], line[at..].split_once("]->").map_or("", |(_, to)| to));
        } else if line == "P1 n = (n + 1) % 4;" || line == "P1 n = 3;" {
            lines.push(format!("P{} m = Mode::{};", rng.below(2), rng.pick(&VARIANTS)));
        }
        lines.push(line);
    }
    let list = VARIANTS.join(", ");
    lines.insert(2, format!("var m: Mode in {{{list}}} = Mode::Idle;"));
    if asked {
        lines.insert(2, format!("input i: Mode in {{{list}}};"));
    }
    lines.join("\n") + "\n"
}

/// A counting chart that claims, of some conditions at a time, that one does not hold with another that stands below an edge or a delay; and
/// beside it what brute force takes for it, which says the same without them.
#[must_use]
pub(crate) fn remembering(number: u64, grafcet: bool) -> (String, String, Vec<Over>) {
    let mut rng = Rng::new(number ^ 0x3e_3e);
    let text = counting(number, grafcet, false);
    let is_property = |line: &str| ["never ", "always ", "home "].iter().any(|word| line.starts_with(word));
    let mut lines: Vec<String> = text.lines().filter(|line| !is_property(line)).map(str::to_owned).collect();
    let is_step = |line: &&str| line.contains("step ") && !line.contains("macro");
    let steps = text.lines().filter(is_step).filter_map(|line| line.strip_suffix(" {")?.rsplit(' ').next());
    let steps: Vec<&str> = steps.collect();
    let names = text.lines().filter_map(|line| line.split_once(' ')?.1.strip_suffix(": bool;"));
    let names: Vec<&str> = names.collect();
    let mut one = || {
        let not = if rng.chance(30) { "!" } else { "" };
        match rng.below(6) {
            0 => format!("(n == {})", rng.below(4)),
            1 | 2 => format!("{not}{}.X", rng.pick(&steps)),
            3 => format!("({not}{}.X && {})", rng.pick(&steps), rng.pick(&names)),
            _ => format!("{not}{}", rng.pick(&names)),
        }
    };
    let (mut judged, mut overs, end) = (lines.clone(), Vec::new(), lines.len() - 1);
    // Time passes, whatever the chart asks.
    let timed = format!("never {}.T > 2m && {0}.T < 2m;", steps[0]);
    for index in 0..4 {
        let (of, other) = (one(), one());
        let over = match (number + index) % 5 {
            0 => Over::Rise,
            1 => Over::Fall,
            2 => Over::Delay(1_000, 0),
            3 => Over::Delay(1_000, 2_000),
            _ => Over::RiseOfDelay(1_000),
        };
        lines.insert(end, format!("never {other} && {of};"));
        judged.insert(end, format!("never {other} && {};", memories::text(over, &of)));
        overs.insert(0, over);
    }
    lines.insert(end + 4, timed.clone());
    judged.insert(end + 4, timed);
    (lines.join("\n") + "\n", judged.join("\n") + "\n", overs)
}

/// A counting chart, which claims something over several cycles, too, and may say which inputs come again and again.
#[must_use]
pub fn of_several_cycles(chart: &str, number: u64, timed: bool) -> String {
    let mut rng = Rng::new(number ^ 0xa9a1);
    let mut lines: Vec<String> = chart.lines().map(str::to_owned).collect();
    let is_step = |line: &&str| line.contains("step ") && !line.contains("macro");
    let steps = chart.lines().filter(is_step).filter_map(|line| line.strip_suffix(" {")?.rsplit(' ').next());
    let steps: Vec<&str> = steps.collect();
    let inputs: Vec<&str> =
        chart.lines().filter_map(|line| line.strip_prefix("input ")?.strip_suffix(": bool;")).collect();
    let end = lines.len() - 1;
    for _ in 0..3 {
        let mut one = || match rng.below(4) {
            0 => format!("n == {}", rng.below(5)),
            1 => format!("!{}.X", rng.pick(&steps)),
            _ => (*rng.pick(&steps)).to_owned(),
        };
        let (what, other) = (one(), one());
        let claim = match rng.below(if timed { 4 } else { 2 }) {
            0 => format!("{what} leads_to {other};"),
            1 => format!("{what} before {other};"),
            time => format!("{what} leads_to {other} within {}s;", [1, 7][time % 2]),
        };
        lines.insert(end, claim);
    }
    if let Some(input) = inputs.first().filter(|_| rng.chance(50)) {
        lines.insert(end, format!("assume often {input};"));
        lines.insert(end, format!("assume often !{input};"));
    }
    lines.join("\n") + "\n"
}

impl Maker {
    fn write(&mut self, body: &Body, words: &mut Words, lines: &mut Vec<String>) {
        if let Some(name) = &body.name {
            lines.push(format!("partial {name} {{"));
        }
        for step in &body.steps {
            lines.push(format!("{}step {} {{", step.words, step.name));
            step.forces.iter().for_each(|force| lines.push(force.clone()));
            if !step.words.contains("macro") {
                lines.append(&mut words.actions(self, step));
            }
            for inner in &step.inner {
                self.write(inner, words, lines);
            }
            lines.push("}".to_owned());
        }
        for (index, arrow) in body.arrows.iter().enumerate() {
            let condition = if Self::is_last(&body.arrows, index) && self.rng.chance(25) {
                "else".to_owned()
            } else {
                words.condition(self, arrow)
            };
            lines.push(format!("{} -[{condition}]-> {};", list(&arrow.from), list(&arrow.to)));
        }
        if self.rng.chance(12) {
            let except = if self.rng.chance(25) {
                format!(" except {}", self.rng.pick(&body.steps).name)
            } else {
                String::new()
            };
            let to = self.rng.pick(&body.steps).name.clone();
            let like = Arrow { from: vec![to.clone()], to: Vec::new() };
            lines.push(format!("any{except} -[{}]-> {to};", words.condition(self, &like)));
        }
        if body.name.is_some() {
            lines.push("}".to_owned());
        }
    }

    /// Whether it is the last of several that leave the same steps: it can be their `else`.
    fn is_last(arrows: &[Arrow], index: usize) -> bool {
        let from = &arrows[index].from;
        let same = |arrow: &Arrow| arrow.from == *from;
        !from.is_empty() && arrows[..index].iter().any(same) && !arrows[index + 1..].iter().any(same)
    }
}

fn list(steps: &[String]) -> String {
    match steps {
        [one] => one.clone(),
        many => format!("({})", many.join(", ")),
    }
}
