//! Steps and arrows of a random chart, without conditions.

use super::Gen;

/// A partial grafcet, an expansion or a whole chart.
#[derive(Default)]
pub(super) struct Part {
    pub(super) name: Option<String>,
    pub(super) steps: Vec<Step>,
    pub(super) arrows: Vec<Arrow>,
}

pub(super) struct Step {
    /// `initial `, `entry linked ` …
    pub(super) words: String,
    pub(super) name: String,
    pub(super) inner: Inner,
    pub(super) forces: Vec<String>,
}

pub(super) enum Inner {
    Nothing,
    Macro(Box<Part>),
    Enclosed(Vec<Part>),
}

pub(super) struct Arrow {
    pub(super) from: Vec<String>,
    pub(super) to: Vec<String>,
    /// What makes the branches of an OR-divergence exclusive.
    pub(super) guard: Option<String>,
    /// That is the whole condition.
    pub(super) whole: bool,
}

/// How much may still be drawn.
pub(super) struct Room {
    pub(super) steps: usize,
    /// How deep hierarchy may go.
    pub(super) depth: usize,
}

impl Part {
    pub(super) fn arrow(&mut self, from: &[impl AsRef<str>], to: &[impl AsRef<str>], guard: Option<String>) {
        let from = from.iter().map(|step| step.as_ref().to_owned()).collect();
        let to = to.iter().map(|step| step.as_ref().to_owned()).collect();
        self.arrows.push(Arrow { from, to, guard, whole: false });
    }

    fn names(&self) -> Vec<String> {
        self.steps.iter().map(|step| step.name.clone()).collect()
    }

    /// The steps that one more transition can leave: `else` stands after all others.
    fn open(&self) -> Vec<String> {
        let last = |name: &String| self.arrows.iter().any(|arrow| arrow.whole && arrow.from.contains(name));
        self.names().into_iter().filter(|name| !last(name)).collect()
    }
}

impl Gen {
    /// The partial grafcets of the chart; the first has no name where it is the whole chart.
    pub(super) fn structure(&mut self) -> Vec<Part> {
        if self.rng.chance(6) {
            return vec![self.sequence()];
        }
        if !self.grafcet || self.rng.chance(45) {
            let steps = self.rng.between(3, 12);
            return vec![self.partial(None, steps)];
        }
        let count = self.rng.between(2, 3);
        let names: Vec<String> = (0..count).map(|_| self.fresh('G')).collect();
        let mut parts = Vec::new();
        let mut masters = Vec::new();
        for (index, name) in names.iter().enumerate() {
            // Every partial grafcet has at most one master, which stands above it and has one token (A14).
            let slaves: Vec<usize> = (index + 1..count).filter(|_| self.rng.chance(60)).collect();
            let slaves: Vec<usize> = slaves.into_iter().filter(|slave| !masters.contains(slave)).collect();
            masters.extend(&slaves);
            let part = if slaves.is_empty() {
                let steps = self.rng.between(2, 6);
                self.partial(Some(name.clone()), steps)
            } else {
                self.ring(Some(name.clone()))
            };
            parts.push((part, slaves));
        }
        self.force(parts)
    }

    /// Gives the masters their orders.
    fn force(&mut self, parts: Vec<(Part, Vec<usize>)>) -> Vec<Part> {
        let targets: Vec<(String, Vec<String>)> =
            parts.iter().map(|(part, _)| (part.name.clone().unwrap_or_default(), real_steps(part))).collect();
        let mut done = Vec::new();
        for (mut part, slaves) in parts {
            for step in &mut part.steps {
                for slave in &slaves {
                    if self.rng.chance(60) {
                        let (name, steps) = &targets[*slave];
                        let order = self.order(steps);
                        step.forces.push(format!("force {name} {{{order}}};"));
                    }
                }
            }
            done.push(part);
        }
        done
    }

    fn order(&mut self, steps: &[String]) -> String {
        match self.rng.below(4) {
            0 => {
                self.note("force {}");
                String::new()
            }
            1 => {
                self.note("force {*}");
                "*".to_owned()
            }
            2 => {
                self.note("force {INIT}");
                "INIT".to_owned()
            }
            _ => {
                self.note("force {S}");
                let mut chosen = vec![self.rng.pick(steps).clone()];
                let other = self.rng.pick(steps);
                if self.rng.chance(30) && !chosen.contains(other) {
                    chosen.push(other.clone());
                }
                chosen.join(", ")
            }
        }
    }

    /// Many steps, most of which end on one condition, not declared in their order.
    fn sequence(&mut self) -> Part {
        self.note("long sequence");
        let mut part = Part::default();
        let count = self.rng.between(20, 40);
        let steps: Vec<String> = (0..count).map(|_| self.plain(&mut part, "")).collect();
        part.steps[0].words.push_str("initial ");
        let conditions: &[&str] =
            if self.rng.chance(50) { &["a", "b", "!a", "!b"] } else { &["a", "b", "!a", "!b", "a && b", "a || !b"] };
        for (index, step) in steps.iter().enumerate() {
            let condition = *self.rng.pick(conditions);
            part.arrow(&[step], &[&steps[(index + 1) % count]], Some(condition.to_owned()));
        }
        part.arrows.iter_mut().for_each(|arrow| arrow.whole = true);
        if self.rng.chance(50) {
            self.branch(&mut part, &steps);
        }
        for _ in 0..self.rng.between(0, 4) {
            let (one, other) = (self.rng.below(count), self.rng.below(count));
            part.steps.swap(one, other);
        }
        part
    }

    /// A few steps of a sequence get a second way out.
    fn branch(&mut self, part: &mut Part, steps: &[String]) {
        self.note("long sequence with branches");
        for _ in 0..self.rng.between(1, 6) {
            let from = self.rng.below(steps.len());
            if part.arrows[from].guard.as_deref() != Some("a") {
                continue;
            }
            let to = self.rng.pick(steps).clone();
            part.arrow(&[&steps[from]], &[&to], Some("!a".to_owned()));
        }
    }

    /// One token that goes round.
    fn ring(&mut self, name: Option<String>) -> Part {
        let mut part = Part { name, ..Part::default() };
        let count = self.rng.between(2, 4);
        let steps: Vec<String> = (0..count).map(|_| self.plain(&mut part, "")).collect();
        part.steps[0].words.push_str("initial ");
        for (index, step) in steps.iter().enumerate() {
            let next = steps[(index + 1) % count].clone();
            part.arrow(&[&step], &[next], None);
        }
        part
    }

    /// A partial grafcet with everything in it.
    fn partial(&mut self, name: Option<String>, steps: usize) -> Part {
        let mut part = Part { name, ..Part::default() };
        let mut room = Room { steps, depth: usize::from(self.grafcet) * 2 };
        let first = self.node(&mut part, &mut room);
        self.body(&mut part, &first, &mut room);
        let initial = |step: &mut Step| step.words.insert_str(0, "initial ");
        initial(&mut part.steps[0]);
        if self.rng.chance(if self.grafcet { 20 } else { 4 }) && part.steps.len() > 2 {
            self.note("several initial steps");
            let other = self.rng.between(1, part.steps.len() - 1);
            initial(&mut part.steps[other]);
        }
        self.ends(&mut part);
        part
    }

    /// From `first` around and back, and jumps.
    pub(super) fn body(&mut self, part: &mut Part, first: &str, room: &mut Room) {
        let mut last = first.to_owned();
        while room.steps > 0 {
            last = self.grow(part, last, room);
        }
        if last == first {
            last = self.plain(part, "");
            part.arrow(&[first], &[&last], None);
        }
        part.arrow(&[&*last], &[first], None);
        if self.rng.chance(35) {
            self.note("jump");
            for _ in 0..self.rng.between(1, 2) {
                let (from, to) = (self.rng.maybe(&part.open()).cloned(), self.rng.pick(&part.names()).clone());
                if let Some(from) = from {
                    part.arrow(&[from], &[to], None);
                }
            }
        }
    }

    /// Source and sink transitions, in `grafcet`.
    pub(super) fn ends(&mut self, part: &mut Part) {
        if !self.grafcet {
            return;
        }
        if self.rng.chance(15) {
            self.note("source transition");
            let to = self.rng.pick(&part.names()).clone();
            part.arrow(&[""; 0], &[to], None);
        }
        if self.rng.chance(15) {
            self.note("sink transition");
            if let Some(from) = self.rng.maybe(&part.open()).cloned() {
                part.arrow(&[from], &[""; 0], None);
            }
        }
    }

    /// Goes on from a step; the new last step.
    pub(super) fn grow(&mut self, part: &mut Part, from: String, room: &mut Room) -> String {
        match self.rng.below(10) {
            0..=3 => {
                let to = self.node(part, room);
                part.arrow(&[from], &[&to], None);
                to
            }
            4..=6 => self.selection(part, &from, room),
            7 | 8 => self.parallel(part, from, room),
            _ => {
                self.note("self-loop");
                part.arrow(&[&from], &[&from], None);
                let to = self.node(part, room);
                part.arrow(&[from], &[&to], None);
                to
            }
        }
    }

    fn selection(&mut self, part: &mut Part, from: &str, room: &mut Room) -> String {
        let exclusive = self.rng.chance(50);
        self.note(if exclusive { "OR-divergence, exclusive" } else { "OR-divergence, overlapping" });
        let mut guards = if self.rng.chance(60) { vec!["a", "!a"] } else { vec!["b", "!b && a", "!b && !a"] };
        if let Some(last) = guards.last_mut().filter(|_| self.rng.chance(30)) {
            self.note("else");
            *last = "else";
        }
        let mut ends = Vec::new();
        for guard in &guards {
            let step = self.node(part, room);
            part.arrow(&[from], &[&step], (exclusive || *guard == "else").then(|| (*guard).to_owned()));
            part.arrows.iter_mut().rev().take(1).for_each(|arrow| arrow.whole = *guard == "else");
            let end = if room.steps > 1 && self.rng.chance(30) { self.grow(part, step, room) } else { step };
            ends.push(end);
        }
        let join = self.node(part, room);
        for end in &ends {
            part.arrow(&[end], &[&join], None);
        }
        join
    }

    fn parallel(&mut self, part: &mut Part, from: String, room: &mut Room) -> String {
        self.note("AND-divergence");
        let count = self.rng.between(2, 3);
        let starts: Vec<String> = (0..count).map(|_| self.node(part, room)).collect();
        part.arrow(&[from], &starts, None);
        let mut ends = Vec::new();
        for start in starts {
            let mut end = start;
            for _ in 0..self.rng.below(3) {
                if room.steps > 0 {
                    end = self.grow(part, end, room);
                }
            }
            ends.push(end);
        }
        if self.rng.chance(20) {
            self.note("AND-convergence into AND-divergence");
            let again: Vec<String> = (0..2).map(|_| self.node(part, room)).collect();
            part.arrow(&ends, &again, None);
            ends = again;
        }
        let join = self.node(part, room);
        if self.rng.chance(30) {
            self.note("AND-convergence with alternatives");
            let other = self.node(part, room);
            part.arrow(&ends, &[&join], None);
            part.arrow(&ends, &[&other], None);
            part.arrow(&[other], &[&join], None);
        } else {
            part.arrow(&ends, &[&join], None);
        }
        join
    }

    /// A new step of any kind.
    fn node(&mut self, part: &mut Part, room: &mut Room) -> String {
        room.steps = room.steps.saturating_sub(1);
        match self.rng.below(100) {
            0..=9 if room.depth > 0 => self.macro_step(part, room),
            10..=21 if room.depth > 0 => self.enclosing(part, room),
            _ => self.plain(part, ""),
        }
    }

    pub(super) fn plain(&mut self, part: &mut Part, words: &str) -> String {
        let name = self.fresh('S');
        part.steps.push(Step {
            words: words.to_owned(),
            name: name.clone(),
            inner: Inner::Nothing,
            forces: Vec::new(),
        });
        name
    }

    pub(super) fn fresh(&mut self, letter: char) -> String {
        self.count += 1;
        format!("{letter}{}", self.count)
    }
}

/// The steps that can stand in a forcing order.
fn real_steps(part: &Part) -> Vec<String> {
    let mut steps = Vec::new();
    for step in &part.steps {
        match &step.inner {
            Inner::Macro(body) => steps.extend(real_steps(body)),
            Inner::Nothing | Inner::Enclosed(_) => steps.push(step.name.clone()),
        }
    }
    steps
}
