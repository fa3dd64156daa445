//! Where there shall always be a way back to.

use std::collections::BTreeMap;

use grafcet_compiler::model::{Claim, StepId};

use super::{Env, Lowering, Refused};
use crate::aig::Lit;

/// A property that says to where there is always a way back.
#[derive(Clone, Debug)]
pub struct Home {
    /// Its number in the chart.
    pub property: usize,
    /// By region: its steps are active as they are at home.
    pub parts: Vec<Condition>,
    /// Where parallel branches meet, those of most branches first: each of the steps before the line is active. What leads home leads
    /// there, too, where the branches always begin again.
    pub meetings: Vec<Vec<Condition>>,
}

/// Branches that are fewer than these need no help.
const BRANCHES: usize = 4;

/// Something that is so or not: before a cycle, by the latches, and at its end.
#[derive(Clone, Copy, Debug)]
pub struct Condition {
    pub now: Lit,
    pub end: Lit,
}

impl Lowering<'_, '_> {
    /// Of each `home`, by the number of its property.
    pub(super) fn homes(&mut self, begin: &Env, end: &Env) -> (Vec<Home>, Vec<(usize, Refused)>) {
        let (mut homes, mut refused) = (Vec::new(), Vec::new());
        for (property, one) in self.program.model.properties.iter().enumerate() {
            let Claim::Home(steps, _) = &one.claim else { continue };
            let both = self.parts(steps, begin, end).and_then(|parts| Ok((parts, self.meetings(steps, begin, end)?)));
            match both {
                Ok((parts, meetings)) => homes.push(Home { property, parts, meetings }),
                Err(why) => refused.push((property, why)),
            }
        }
        (homes, refused)
    }

    /// Of the partial grafcets that hold these steps exactly these are active.
    fn parts(&mut self, home: &[StepId], begin: &Env, end: &Env) -> Result<Vec<Condition>, Refused> {
        let model = self.program.model;
        let is_concerned =
            |step: &StepId| home.iter().any(|one| model.steps[*one].partial == model.steps[*step].partial);
        let mut parts: BTreeMap<usize, Condition> = BTreeMap::new();
        for (region, steps) in self.program.regions.iter().enumerate() {
            for step in steps.iter().filter(|step| is_concerned(step)) {
                let is_not = !home.contains(step);
                let now = self.is_active(*step, begin)?.xor(is_not);
                let at_end = self.is_active(*step, end)?.xor(is_not);
                let part = parts.entry(region).or_insert(Condition { now: Lit::TRUE, end: Lit::TRUE });
                part.now = self.aig.and(part.now, now);
                part.end = self.aig.and(part.end, at_end);
            }
        }
        Ok(parts.into_values().collect())
    }

    fn meetings(&mut self, home: &[StepId], begin: &Env, end: &Env) -> Result<Vec<Vec<Condition>>, Refused> {
        let model = self.program.model;
        let mut all = Vec::new();
        for transition in model.transitions.values().filter(|transition| transition.sources.len() >= BRANCHES) {
            if home.iter().all(|step| model.steps[*step].partial != model.steps[transition.sources[0]].partial) {
                continue;
            }
            let mut active = Vec::new();
            for step in &transition.sources {
                active.push(Condition { now: self.is_active(*step, begin)?, end: self.is_active(*step, end)? });
            }
            all.push(active);
        }
        all.sort_by_key(|active| std::cmp::Reverse(active.len()));
        Ok(all)
    }
}
