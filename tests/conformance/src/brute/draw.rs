//! Steps and arrows: well nested ones with a mistake or two, and quite random ones.

use super::make::Maker;

/// A transition without its condition.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Arrow {
    pub(super) from: Vec<String>,
    pub(super) to: Vec<String>,
}

impl Maker {
    /// Arrows between steps, the first of which is where it starts.
    pub(super) fn draw(&mut self, steps: &[String]) -> Vec<Arrow> {
        let mut arrows = Vec::new();
        if self.rng.chance(15) {
            self.scatter(steps, &mut arrows);
        } else {
            let mut rest = &steps[1..];
            let mut last = steps[0].clone();
            while !rest.is_empty() {
                last = self.block(&last, &mut rest, 3, &mut arrows);
            }
            if self.rng.chance(90) {
                arrow(&[&last], &[&steps[0]], &mut arrows);
            }
            for _ in 0..*self.rng.pick(&[0, 0, 0, 0, 1, 2]) {
                self.spoil(steps, &mut arrows);
            }
        }
        self.touch(steps, &mut arrows);
        arrows
    }

    /// From `from` through some of `rest`, well nested; the last step.
    fn block(&mut self, from: &str, rest: &mut &[String], depth: usize, arrows: &mut Vec<Arrow>) -> String {
        let mut last = from.to_owned();
        for _ in 0..self.rng.between(1, 3) {
            last = match self.rng.below(10) {
                0..=3 if depth > 0 && rest.len() >= 3 => self.fork(&last, rest, depth, true, arrows),
                4..=6 if depth > 0 && rest.len() >= 3 => self.fork(&last, rest, depth, false, arrows),
                _ => {
                    let Some(next) = take(rest) else { break };
                    arrow(&[&last], &[&next], arrows);
                    next
                }
            };
        }
        last
    }

    /// Two branches and where they come together.
    fn fork(&mut self, from: &str, rest: &mut &[String], depth: usize, and: bool, arrows: &mut Vec<Arrow>) -> String {
        let Some(join) = take(rest) else { return from.to_owned() };
        let starts: Vec<String> = (0..2).filter_map(|_| take(rest)).collect();
        let starts: Vec<&str> = starts.iter().map(String::as_str).collect();
        let arms = |this: &mut Self, rest: &mut &[String], arrows: &mut Vec<Arrow>| -> Vec<String> {
            let mut arm = |start: &&str| {
                if this.rng.chance(40) { this.block(start, rest, depth - 1, arrows) } else { (*start).to_owned() }
            };
            starts.iter().map(&mut arm).collect()
        };
        if and {
            arrow(&[from], &starts, arrows);
            let ends = arms(self, rest, arrows);
            let ends: Vec<&str> = ends.iter().map(String::as_str).collect();
            arrow(&ends, &[&join], arrows);
        } else {
            for start in &starts {
                arrow(&[from], &[start], arrows);
            }
            for end in arms(self, rest, arrows) {
                arrow(&[&end], &[&join], arrows);
            }
        }
        join
    }

    /// Arrows from anywhere to anywhere.
    fn scatter(&mut self, steps: &[String], arrows: &mut Vec<Arrow>) {
        for _ in 0..self.rng.between(steps.len(), steps.len() + 3) {
            let made = Arrow { from: self.some(steps), to: self.some(steps) };
            arrows.push(made);
        }
    }

    fn some(&mut self, steps: &[String]) -> Vec<String> {
        let mut some = vec![self.rng.pick(steps).clone()];
        let other = self.rng.pick(steps);
        if self.rng.chance(25) && !some.contains(other) {
            some.push(other.clone());
        }
        some
    }

    /// One mistake, or one jump.
    fn spoil(&mut self, steps: &[String], arrows: &mut Vec<Arrow>) {
        let index = self.rng.below(arrows.len());
        let (one, other) = (self.rng.pick(steps).clone(), self.rng.pick(steps).clone());
        let chosen = arrows[index].clone();
        match self.rng.below(8) {
            // A divergence or convergence of the wrong kind, if it is one.
            0..=2 if chosen.from.len() + chosen.to.len() > 2 => {
                arrows.remove(index);
                for from in &chosen.from {
                    chosen.to.iter().for_each(|to| arrow(&[from], &[to], arrows));
                }
            }
            3 => arrows[index].to = vec![one],
            4 if arrows.len() > 2 => drop(arrows.remove(index)),
            5 if !chosen.from.contains(&one) => arrows[index].from.push(one),
            6 if !chosen.to.contains(&one) => arrows[index].to.push(one),
            _ => arrow(&[&one], &[&other], arrows),
        }
    }

    /// No step stands alone: that is a rule of its own.
    fn touch(&mut self, steps: &[String], arrows: &mut Vec<Arrow>) {
        for step in steps {
            if !arrows.iter().any(|arrow| arrow.from.contains(step) || arrow.to.contains(step)) {
                let other = self.rng.pick(steps).clone();
                if self.rng.chance(50) {
                    arrow(&[step], &[&other], arrows);
                } else {
                    arrow(&[&other], &[step], arrows);
                }
            }
        }
    }
}

fn arrow(from: &[&str], to: &[&str], arrows: &mut Vec<Arrow>) {
    let owned = |steps: &[&str]| steps.iter().map(|step| (*step).to_owned()).collect();
    arrows.push(Arrow { from: owned(from), to: owned(to) });
}

fn take(rest: &mut &[String]) -> Option<String> {
    let (first, others) = rest.split_first()?;
    *rest = others;
    Some(first.clone())
}
