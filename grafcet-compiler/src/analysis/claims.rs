//! Whether what a chart claims of itself is so.
//!
//! What follows from the steps that exclude each other is proved without looking at situations; the rest on all of them.

use super::combinational::written_out;
use super::explore::{Answer, Doubt, Exploration, Limits, Path, Stay, alone};
use super::{Facts, Logic, visible};
use crate::list::{List, PushAll};
use crate::model::{Claim, Effect, Expr, Model, Name, Place, Property, Read, StepId, TransitionId, Tree, Ty};
use crate::sorted::Set;

/// Who decides what the exploration leaves open, such as a solver: an answer for each question.
pub type Prover = dyn Fn(&Model, &Facts<'_>, &[Question]) -> Vec<Ruling>;

/// What a prover is asked.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Question {
    /// Whether the property with this number holds.
    Holds(usize),
    /// Whether what it is about never happens.
    NeverHappens(usize),
    /// Whether the assumptions leave no cycle.
    NoCycle,
    /// Whether what is assumed to come again and again, with this number, never comes.
    NeverComes(usize),
    /// Whether what is assumed to come one after the other, with this number, is asked for at no time.
    SaysNothing(usize),
    /// Whether the plant with this number stays in its initial situation, whatever the chart does.
    StandsStill(usize),
    /// `grafcet`: whether these two never happen in one evolution, but for the activation of the initial situation.
    Apart(Change, Change),
    /// `grafcet`: whether every search for stability comes to its end.
    Settles,
}

impl Question {
    /// What can be asked of what a chart assumes, by itself and by its plants.
    #[must_use]
    pub fn of_assumptions(model: &Model) -> Vec<Self> {
        let mut all = Vec::new();
        let assumes = |model: &Model| !model.assumptions.is_empty() || !model.orders.is_empty();
        if assumes(model) || model.plants.list.iter().any(|plant| assumes(&plant.model)) {
            all.push(Self::NoCycle);
        }
        all.push_all((0..model.often.len()).map(Self::NeverComes));
        all.push_all((0..model.orders.len()).map(Self::SaysNothing));
        for (number, plant) in model.plants.list.iter().enumerate() {
            // What has no transition shows something at once.
            if !plant.model.transitions.is_empty() {
                all.push(Self::StandsStill(number));
            }
        }
        all
    }
}

/// What an evolution does.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Change {
    /// A transition clears.
    Clears(TransitionId),
    /// A step is active after it and was not before.
    Activates(StepId),
    /// It is the other way round.
    Deactivates(StepId),
}

/// What it says.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Ruling {
    /// It is so at the end of every cycle.
    Holds,
    /// It is not.
    Broken {
        /// So many cycles lead there, and fewer do not.
        cycles: usize,
        /// The first of the cycles that go on for ever, where what has to come never does.
        again: Option<usize>,
        /// These, as a table.
        way: String,
    },
    /// It is not decided, and why.
    Open(String),
}

/// What is answered of properties: whether they can be violated, or what they are about happens.
type Answers<'m> = Vec<(&'m Property, Answer)>;

/// What is looked for, of properties.
type Sought<'m> = Vec<(&'m Property, Tree)>;

/// The properties of a chart that are not proved.
pub(crate) struct Claims<'m> {
    model: &'m Model,
    limits: Limits,
    facts: &'m Facts<'m>,
    /// Of the chart, for all rules.
    pub(crate) exploration: Exploration,
    /// What can be violated, or is not decided.
    pub(crate) open: Answers<'m>,
    /// The same of ways home.
    pub(crate) away: Answers<'m>,
    /// Of the properties that are about something, whether that happens.
    pub(crate) triggers: Answers<'m>,
}

impl<'m> Claims<'m> {
    /// Explores the chart. Nobody can say the value of what has actions of two kinds, which is no matter of a proof.
    pub(crate) fn of(model: &'m Model, logic: &Logic<'_>, limits: Limits, facts: &'m Facts<'m>) -> Self {
        let mixed = facts.mixed(model);
        let known = |property: &&Property| !property.claim.expressions().iter().any(|expr| reads_any(expr, mixed));
        let (claimed, mut open) = claimed(model, logic, &known);
        let (triggers, sought) = sought(model, logic, &known);
        let watched: Vec<&Tree> = claimed.iter().and(&sought).map(|(_, tree)| tree).list();
        let exploration = Exploration::with(model, facts, &limits, &watched);
        let mut left = Left { limits, open: 0 };
        let mut alone =
            |tree: &Tree| left.of(|limits| alone::watched((model, facts), limits, tree, claimed.len() == 1));
        for (index, (property, violation)) in claimed.iter().enumerate() {
            let answer = exploration.watched(index);
            let asked = matches!(answer, Answer::Unknown(_)).then(|| alone(violation));
            match asked.flatten().unwrap_or(answer) {
                Answer::Never => {}
                Answer::Possible(path) => open.push((*property, possible(model, violation, path))),
                answer @ Answer::Unknown(_) => open.push((*property, answer)),
            }
        }
        let mut claims = Self { model, limits, facts, exploration, open, away: Vec::new(), triggers };
        for (index, (property, trigger)) in sought.iter().enumerate() {
            let answer = claims.exploration.watched(claimed.len() + index);
            // Where the property itself was not decided, this will not be either.
            let again = matches!(answer, Answer::Unknown(_)) && claims.is_proved(property);
            let answer = again.then(|| alone(trigger)).flatten().unwrap_or(answer);
            claims.triggers.push((*property, answer));
        }
        claims.ways_home(!watched.is_empty());
        if !watched.is_empty() && !claims.exploration.is_complete() {
            // To follow what the properties are about takes more than the rules need.
            claims.exploration = Exploration::with(model, facts, &limits, &[]);
        }
        claims
    }

    fn is_proved(&self, property: &Property) -> bool {
        !self.open.iter().any(|(open, _)| std::ptr::eq(*open, property))
    }

    fn ways_home(&mut self, has_watched: bool) {
        let model = self.model;
        let has_home = model.properties.iter().any(|property| matches!(property.claim, Claim::Home(..)));
        let nesting = if has_home { self.facts.nesting(model) } else { None };
        for property in &model.properties {
            let Claim::Home(home, _) = &property.claim else { continue };
            if nesting.is_some_and(|nesting| nesting.returns_to(model, home, &self.facts.never)) {
                continue;
            }
            match self.away_from(home, &[], has_watched) {
                Answer::Never => {}
                answer => self.away.push((property, answer)),
            }
        }
    }

    /// Whether there is a situation without a way home, nor to where the chart stays; `has_watched` where the exploration
    /// has followed other properties, too.
    pub(crate) fn away_from(&self, home: &[StepId], stays: &[Stay], has_watched: bool) -> Answer {
        let chart = (self.model, self.facts);
        let alone = |only: bool| alone::away_from(chart, &self.limits, (home, stays), only);
        // What it does not touch does not decide about it: neither other partial grafcets nor other properties.
        alone(true).unwrap_or_else(|| {
            let answer = self.exploration.away_but_for(home, stays);
            let again = matches!(answer, Answer::Unknown(_)) && has_watched;
            again.then(|| alone(false)).flatten().unwrap_or(answer)
        })
    }
}

/// So many questions alone may take all of the budget and stay open; each further one of which that is so halves what the next may take. All of
/// them together take no more than two besides.
const OPEN: u32 = 6;

/// What is left of the budget for one question alone.
struct Left {
    limits: Limits,
    open: u32,
}

impl Left {
    fn of(&mut self, ask: impl FnOnce(&Limits) -> Option<Answer>) -> Option<Answer> {
        let less = self.open.saturating_sub(OPEN);
        let work = self.limits.work.checked_shr(less).unwrap_or_default();
        let answer = ask(&Limits { work, ..self.limits });
        let is_open = matches!(answer, Some(Answer::Unknown(Doubt::Budget(_) | Doubt::Inputs { .. })));
        self.open += u32::from(is_open);
        // What less than the budget leaves open tells nothing.
        answer.filter(|_| !is_open || less == 0)
    }
}

/// What the exploration can look for of what properties exclude; and what is open without it, by the reason for that. What follows from
/// the conditions is in neither.
fn claimed<'m>(model: &'m Model, logic: &Logic<'_>, known: &dyn Fn(&&Property) -> bool) -> (Sought<'m>, Answers<'m>) {
    let (mut claimed, mut open) = (Vec::new(), Vec::new());
    for property in model.properties.iter().filter(known) {
        if matches!(property.claim, Claim::LeadsTo { .. } | Claim::Before { .. }) {
            open.push((property, Answer::Unknown(Doubt::Cycles)));
        }
    }
    for property in model.properties.iter().filter(known) {
        let Some(violation) = property.claim.violation() else { continue };
        if logic.never(&logic.condition(&visible::resolved(model, &violation))) {
            continue;
        }
        // A combinational variable is what it stands for at the end of the cycle.
        let written = written_out(model, &violation);
        let unfollowed = written.as_ref().map_or_else(|| vec![violation.clone()], |tree| unfollowed(model, tree));
        if unfollowed.is_empty() {
            claimed.push((property, written.unwrap_or(violation)));
        } else {
            open.push((property, Answer::Unknown(Doubt::Unfollowed(unfollowed))));
        }
    }
    (claimed, open)
}

/// What a way to a violation says: it may be one that does not happen.
fn possible(model: &Model, violation: &Tree, path: Path) -> Answer {
    if !model.orders.is_empty() {
        return Answer::Unknown(Doubt::Cycles);
    }
    let by_time = by_time(model, violation);
    if by_time.is_empty() { Answer::Possible(path) } else { Answer::Unknown(Doubt::Unfollowed(by_time)) }
}

/// What the exploration can look for of what properties are about; and before that, what is known without it.
fn sought<'m>(model: &'m Model, logic: &Logic<'_>, known: &dyn Fn(&&Property) -> bool) -> (Answers<'m>, Sought<'m>) {
    let (mut told, mut sought) = (Vec::new(), Vec::new());
    for property in model.properties.iter().filter(known) {
        let Some(trigger) = property.claim.trigger() else { continue };
        if logic.never(&logic.condition(&visible::resolved(model, &trigger.tree))) {
            told.push((property, Answer::Never));
            continue;
        }
        match written_out(model, &trigger.tree) {
            Some(written) if unfollowed(model, &written).is_empty() => sought.push((property, written)),
            _ => told.push((property, Answer::Unknown(Doubt::Unfollowed(Vec::new())))),
        }
    }
    (told, sought)
}

/// What the exploration does not follow from cycle to cycle: numbers, enums and times.
fn unfollowed(model: &Model, violation: &Tree) -> Vec<Tree> {
    let mut all: Vec<Tree> = Vec::new();
    violation.each_read(&mut |read| {
        let followed = match read {
            Read::Name(Name::Input(_) | Name::Param(_)) | Read::Active(_) | Read::MacroActive(_) | Read::Ticks(_) => {
                true
            }
            Read::Name(name) => matches!(model.ty(name), Ty::Bool(_)),
            _ => false,
        };
        let tree = Tree::Read(read);
        if !followed && !all.contains(&tree) {
            all.push(tree);
        }
    });
    all
}

/// What limited and delayed actions act on: the exploration has them on and off at any time, so that what it finds need not come.
fn by_time(model: &Model, violation: &Tree) -> Vec<Tree> {
    let mut all: Vec<Tree> = Vec::new();
    violation.each_read(&mut |read| {
        let is_it = |place: Place| read == Read::Name(place.into());
        let acts =
            |effect: &Effect| matches!(effect, Effect::Control(place) | Effect::Assign(place, _) if is_it(*place));
        let timed = model.associations.values().any(|one| one.time.is_some() && acts(&one.effect));
        if timed && !all.contains(&Tree::Read(read)) {
            all.push(Tree::Read(read));
        }
    });
    all
}

fn reads_any(expr: &Expr, places: &Set<Place>) -> bool {
    expr.reads.iter().any(|read| match read {
        Read::Name(Name::Output(id)) => places.contains(&Place::Output(*id)),
        Read::Name(Name::Var(id)) => places.contains(&Place::Var(*id)),
        _ => false,
    })
}
