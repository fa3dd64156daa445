//! Partial grafcets, forcing, enclosures and macro-steps of a small random chart.

use super::draw::Arrow;
use super::make::Maker;

/// A partial grafcet, the expansion of a macro-step, or the whole chart.
pub(super) struct Body {
    pub(super) name: Option<String>,
    pub(super) steps: Vec<Step>,
    pub(super) arrows: Vec<Arrow>,
}

pub(super) struct Step {
    /// `initial `, `linked enclosing ` …
    pub(super) words: String,
    pub(super) name: String,
    pub(super) forces: Vec<String>,
    pub(super) inner: Vec<Body>,
}

impl Maker {
    /// The partial grafcets of a chart; one without a name is the whole chart.
    pub(super) fn bodies(&mut self) -> Vec<Body> {
        if !self.grafcet || self.rng.chance(55) {
            let count = self.rng.between(3, 8);
            let mut body = self.body(count, "initial ");
            if self.grafcet && self.rng.chance(35) {
                self.deepen(&mut body);
            }
            if self.grafcet && self.rng.chance(12) {
                self.open(&mut body);
            }
            return vec![body];
        }
        let mut bodies: Vec<Body> = (0..2)
            .map(|_| {
                let count = self.rng.between(2, 4);
                let name = self.partial();
                Body { name: Some(name), ..self.body(count, "initial ") }
            })
            .collect();
        if self.rng.chance(50) {
            self.force(&mut bodies);
        }
        if self.rng.chance(20) {
            self.deepen(&mut bodies[0]);
        }
        bodies
    }

    fn partial(&mut self) -> String {
        self.partials += 1;
        format!("G{}", self.partials)
    }

    fn body(&mut self, count: usize, first: &str) -> Body {
        let names: Vec<String> = (0..count)
            .map(|_| {
                self.steps += 1;
                format!("S{}", self.steps)
            })
            .collect();
        let arrows = self.draw(&names);
        let mut steps: Vec<Step> = names
            .into_iter()
            .map(|name| Step { words: String::new(), name, forces: Vec::new(), inner: Vec::new() })
            .collect();
        first.clone_into(&mut steps[0].words);
        if self.rng.chance(if self.grafcet { 15 } else { 3 }) {
            let other = self.rng.between(1, count - 1);
            first.clone_into(&mut steps[other].words);
        }
        if self.rng.chance(8) {
            let last = self.rng.between(1, count - 1);
            if steps[last].words.is_empty() {
                "final ".clone_into(&mut steps[last].words);
            }
        }
        Body { name: None, steps, arrows }
    }

    /// Makes one step an enclosing step, or a macro-step.
    fn deepen(&mut self, body: &mut Body) {
        let index = self.rng.below(body.steps.len());
        let count = self.rng.between(2, 3);
        if self.rng.chance(60) {
            let mut inner = self.body(count, "linked ");
            inner.name = Some(self.partial());
            if self.rng.chance(30) {
                let initial = self.rng.below(count);
                inner.steps[initial].words.insert_str(0, "initial ");
            }
            if body.steps[index].words == "initial " && !inner.steps.iter().any(|s| s.words.contains("initial")) {
                inner.steps[0].words.insert_str(0, "initial ");
            }
            body.steps[index].words.push_str("enclosing ");
            body.steps[index].inner.push(inner);
        } else if !body.steps[index].words.contains("final") {
            let mut inner = self.body(count, "entry ");
            inner.steps.iter_mut().skip(1).for_each(|step| step.words.clear());
            inner.steps[count - 1].words.push_str("exit ");
            body.steps[index].words.push_str("macro ");
            body.steps[index].name = body.steps[index].name.replace('S', "M");
            let (new, old) = (body.steps[index].name.clone(), body.steps[index].name.replace('M', "S"));
            for arrow in &mut body.arrows {
                arrow
                    .from
                    .iter_mut()
                    .chain(&mut arrow.to)
                    .filter(|name| **name == old)
                    .for_each(|n| n.clone_from(&new));
            }
            body.steps[index].inner.push(inner);
        }
    }

    /// Source and sink transitions.
    fn open(&mut self, body: &mut Body) {
        let name = |this: &mut Self| this.rng.pick(&body.steps).name.clone();
        let (source, sink) = (name(self), name(self));
        if self.rng.chance(70) {
            body.arrows.push(Arrow { from: Vec::new(), to: vec![source] });
        }
        body.arrows.push(Arrow { from: vec![sink], to: Vec::new() });
    }

    /// Steps of the first force the second.
    fn force(&mut self, bodies: &mut [Body]) {
        let [master, slave] = bodies else { return };
        let target = slave.name.clone().unwrap_or_default();
        for step in &mut master.steps {
            if self.rng.chance(40) {
                let order = match self.rng.below(4) {
                    0 => String::new(),
                    1 => "*".to_owned(),
                    2 => "INIT".to_owned(),
                    _ => self.rng.pick(&slave.steps).name.clone(),
                };
                step.forces.push(format!("force {target} {{{order}}};"));
            }
        }
    }
}
