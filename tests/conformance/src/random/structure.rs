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
}

/// How much may still be drawn.
struct Room {
    steps: usize,
    /// How deep hierarchy may go.
    depth: usize,
}

impl Part {
    fn arrow(&mut self, from: &[String], to: &[String], guard: Option<String>) {
        self.arrows.push(Arrow { from: from.to_vec(), to: to.to_vec(), guard });
    }

    fn names(&self) -> Vec<String> {
        self.steps.iter().map(|step| step.name.clone()).collect()
    }
}

impl Gen {
    /// The partial grafcets of the chart; the first has no name where it is the whole chart.
    pub(super) fn structure(&mut self) -> Vec<Part> {
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
        let steps: Vec<Vec<String>> = parts.iter().map(|(part, _)| real_steps(part)).collect();
        let names: Vec<String> = parts.iter().map(|(part, _)| part.name.clone().unwrap_or_default()).collect();
        let mut parts = parts;
        for (part, slaves) in &mut parts {
            for (step, slave) in part.steps.iter_mut().flat_map(|s| slaves.iter().map(move |slave| (s as *mut Step, *slave))).map(|(s, slave)| (s, slave)).collect::<Vec<_>>() {
                let _ = (step, slave);
            }
        }
        let _ = (steps, names);
        parts.into_iter().map(|(part, _)| part).collect()
    }
}
