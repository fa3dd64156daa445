//! Both versions in one drawing: the new one, and what is gone from the old one.

use grafcet_core::description::{Action, Any, Description, MacroStep, Partial, Step, Transition};
use grafcet_draw::{Change, Difference, Part};

use super::changes::{ends, missing, pairs, share};
use super::words::{Text, Transition as Said, Words};

/// A version as it is drawn and in words. Steps and transitions of both have the same numbers.
#[derive(Clone, Copy)]
pub(super) struct Version<'v> {
    pub(super) chart: &'v Description<'v>,
    pub(super) words: &'v Words,
}

/// Steps that have another name than in the old version.
pub(super) type Renamed<'r> = &'r [String];

/// Calls `then` with the description of both, and with what differs in it.
pub(super) fn with_both<R>(
    old: Version<'_>,
    new: Version<'_>,
    renamed: Renamed<'_>,
    then: impl FnOnce(&Description<'_>, &[Difference]) -> R,
) -> R {
    let mut both = Both::of(old, new, renamed);
    both.steps();
    both.transitions();
    both.priorities();
    both.called(then)
}

/// A transition with its steps before and after, those that an `any` leaves, and what it does.
type Arc<'v> = (Transition<'v>, [Vec<usize>; 3], Vec<&'v str>);

struct Both<'v> {
    old: Version<'v>,
    new: Version<'v>,
    renamed: Renamed<'v>,
    /// By number of the old version, that in the drawing.
    places: Vec<usize>,
    partials: Vec<Partial<'v>>,
    macros: Vec<MacroStep<'v>>,
    steps: Vec<(Step<'v>, Vec<Action<'v>>, Vec<&'v str>)>,
    transitions: Vec<Arc<'v>>,
    pairs: Vec<(usize, usize)>,
    differences: Vec<Difference>,
}

impl<'v> Both<'v> {
    fn of(old: Version<'v>, new: Version<'v>, renamed: Renamed<'v>) -> Self {
        let mut next = new.words.steps.len();
        let places = old.words.steps.iter().map(|step| {
            let found = new.words.steps.iter().position(|other| other.name == step.name);
            found.unwrap_or_else(|| {
                next += 1;
                next - 1
            })
        });
        Self {
            old,
            new,
            renamed,
            places: places.collect(),
            partials: new.chart.partials.to_vec(),
            macros: new.chart.macros.to_vec(),
            steps: Vec::new(),
            transitions: Vec::new(),
            pairs: matched(&old.words.transitions, &new.words.transitions),
            differences: Vec::new(),
        }
    }

    fn differs(&mut self, part: Part, change: Change, was: &str) {
        self.differences.push(Difference { part, change, was: was.to_owned() });
    }

    fn steps(&mut self) {
        let (old, new) = (self.old, self.new);
        for (number, (step, words)) in new.chart.steps.iter().zip(&new.words.steps).enumerate() {
            self.steps.push((*step, step.actions.to_vec(), step.forces.to_vec()));
            let Some(before) = old.words.steps.iter().position(|other| other.name == words.name) else {
                self.differs(Part::Step(number), Change::New, "");
                continue;
            };
            if old.words.steps[before].traits != words.traits || self.renamed.contains(&words.name) {
                self.differs(Part::Step(number), Change::Other, "");
            }
            self.actions(number, before);
        }
        for (step, place) in old.chart.steps.iter().zip(self.places.clone()) {
            if place >= new.words.steps.len() {
                let partial = self.partial(step.partial);
                let expansion = step.expansion.and_then(|id| {
                    let name = old.chart.macros[id].name;
                    new.chart.macros.iter().position(|one| one.name == name)
                });
                self.steps.push((Step { partial, expansion, ..*step }, step.actions.to_vec(), step.forces.to_vec()));
                self.differs(Part::Step(place), Change::Gone, "");
            }
        }
    }

    /// The partial grafcet of an old one's name; one that is gone is drawn, too.
    fn partial(&mut self, number: usize) -> usize {
        let partial = self.old.chart.partials[number];
        if let Some(found) = self.partials.iter().position(|one| one.name == partial.name) {
            return found;
        }
        self.partials.push(Partial { enclosed_by: partial.enclosed_by.map(|step| self.places[step]), ..partial });
        self.partials.len() - 1
    }

    /// Those of a step of the new version; what is gone stands after them.
    fn actions(&mut self, number: usize, before: usize) {
        let (was, is) = (&self.old.words.steps[before].actions, &self.new.words.steps[number].actions);
        let (gone, fresh) = (missing(was, is), missing(is, was));
        let is_moved = gone.is_empty() && fresh.is_empty() && was != is;
        let mut news = fresh.clone();
        let (actions, forces) = (self.new.chart.steps[number].actions.len(), self.new.chart.steps[number].forces.len());
        let mut lost = Vec::new();
        let mut left: Vec<&Text> = gone;
        for (place, text) in was.iter().enumerate() {
            if let Some(found) = left.iter().position(|other| *other == text) {
                left.remove(found);
                lost.push(place);
            }
        }
        let of = &self.old.chart.steps[before];
        let (gone_actions, gone_forces): (Vec<usize>, Vec<usize>) =
            lost.into_iter().partition(|place| *place < of.actions.len());
        for (place, text) in is.iter().enumerate() {
            // Forcing orders stand after all actions, also those that are gone.
            let part = Part::Action(number, if place < actions { place } else { place + gone_actions.len() });
            if let Some(found) = news.iter().position(|other| *other == text) {
                news.remove(found);
                self.differs(part, Change::New, "");
            } else if is_moved {
                self.differs(part, Change::Moved, "");
            }
        }
        for (offset, place) in gone_actions.iter().enumerate() {
            self.steps[number].1.push(of.actions[*place]);
            self.differs(Part::Action(number, actions + offset), Change::Gone, "");
        }
        for (offset, place) in gone_forces.iter().enumerate() {
            self.steps[number].2.push(of.forces[*place - of.actions.len()]);
            self.differs(Part::Action(number, actions + gone_actions.len() + forces + offset), Change::Gone, "");
        }
    }

    fn transitions(&mut self) {
        let (old, new) = (self.old, self.new);
        for (number, (one, words)) in new.chart.transitions.iter().zip(&new.words.transitions).enumerate() {
            let left = one.any.map_or(Vec::new(), |any| any.steps.to_vec());
            let ends = [one.sources.to_vec(), one.targets.to_vec(), left];
            let mut clearing = one.clearing.to_vec();
            match self.pairs.iter().find(|pair| pair.1 == number).map(|pair| pair.0) {
                None => self.differs(Part::Transition(number), Change::New, ""),
                Some(before) => {
                    let was = &old.words.transitions[before];
                    if was.condition != words.condition {
                        self.differs(Part::Transition(number), Change::Other, &was.condition.shown);
                    } else if was.name != words.name || was.clearing != words.clearing {
                        self.differs(Part::Transition(number), Change::Other, "");
                    }
                    for place in places(&words.clearing, &missing(&words.clearing, &was.clearing)) {
                        self.differs(Part::Clearing(number, place), Change::New, "");
                    }
                    for place in places(&was.clearing, &missing(&was.clearing, &words.clearing)) {
                        self.differs(Part::Clearing(number, clearing.len()), Change::Gone, "");
                        clearing.push(old.chart.transitions[before].clearing[place]);
                    }
                }
            }
            self.transitions.push((*one, ends, clearing));
        }
        for (number, one) in old.chart.transitions.iter().enumerate() {
            if self.pairs.iter().all(|pair| pair.0 != number) {
                let here = |steps: &[usize]| steps.iter().map(|step| self.places[*step]).collect::<Vec<_>>();
                let ends = [here(one.sources), here(one.targets), one.any.map_or(Vec::new(), |any| here(any.steps))];
                let place = self.transitions.len();
                self.transitions.push((*one, ends, one.clearing.to_vec()));
                self.differs(Part::Transition(place), Change::Gone, "");
            }
        }
    }

    /// Of transitions that leave one step in an `sfc` the order is their priority.
    fn priorities(&mut self) {
        if self.new.words.is_grafcet {
            return;
        }
        let (before, after) = (&self.old.words.transitions, &self.new.words.transitions);
        let mut moved = Vec::new();
        for (a, b) in self.pairs.iter().flat_map(|a| self.pairs.iter().map(move |b| (a, b))) {
            let shared = share(&after[a.1], &after[b.1]) && share(&before[a.0], &before[b.0]);
            if shared && a.1 < b.1 && a.0 > b.0 {
                moved.extend([a.1, b.1]);
            }
        }
        moved.sort_unstable();
        moved.dedup();
        for number in moved {
            self.differs(Part::Transition(number), Change::Moved, "");
        }
    }

    fn called<R>(self, then: impl FnOnce(&Description<'_>, &[Difference]) -> R) -> R {
        let steps = self.steps.iter().map(|(step, actions, forces)| Step { actions, forces, ..*step });
        let transitions = self.transitions.iter().map(|(one, [sources, targets, left], clearing)| Transition {
            sources,
            targets,
            clearing,
            any: one.any.map(|any| Any { steps: left, ..any }),
            ..*one
        });
        let (steps, transitions) = (steps.collect::<Vec<_>>(), transitions.collect::<Vec<_>>());
        let chart = Description {
            partials: &self.partials,
            macros: &self.macros,
            steps: &steps,
            transitions: &transitions,
            ..*self.new.chart
        };
        then(&chart, &self.differences)
    }
}

/// Which transition of the old version is which of the new one, where both lead from the same steps to the same.
fn matched(old: &[Said], new: &[Said]) -> Vec<(usize, usize)> {
    let mut pairs = pairs(old, new);
    // One that leads elsewhere is drawn as one that is gone and one that is new.
    pairs.retain(|(before, after)| ends(&old[*before], &new[*after]));
    pairs
}

/// Where these texts stand.
fn places(all: &[Text], these: &[&Text]) -> Vec<usize> {
    let mut left = these.to_vec();
    let mut places = Vec::new();
    for (place, text) in all.iter().enumerate() {
        if let Some(found) = left.iter().position(|other| *other == text) {
            left.remove(found);
            places.push(place);
        }
    }
    places
}
