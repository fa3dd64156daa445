//! Ways through a chart, as the verdicts show them.

use crate::analysis::numbers::{Float, float};
use crate::list::List;
use crate::model::{Binary, Model, PartialId, Read, StepId, TransitionId, Tree};

/// A sequence of cycles from the initial situation on.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Path {
    /// Active before the first of the cycles.
    pub start: Vec<StepId>,
    /// In their order.
    pub cycles: Vec<PathCycle>,
    /// The very first cycle of the chart is left out, because nothing can happen in it.
    pub skips_first: bool,
    /// What it takes for granted of values that are not followed: whether the way exists depends on them.
    pub granted: Vec<Tree>,
}

/// One cycle.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct PathCycle {
    /// What must be so in this cycle for it to go this way.
    pub given: Vec<Given>,
    /// The transitions cleared, in the order of the evolutions.
    pub cleared: Vec<TransitionId>,
    /// The active steps at its end.
    pub active: Vec<StepId>,
}

/// A demand on something that conditions read: an input, a number, a time.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Given {
    /// What.
    pub what: Tree,
    /// What is demanded of it.
    pub demand: Demand,
}

/// What is demanded.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Demand {
    /// A boolean value.
    Is(bool),
    /// From the first to the last, where these are bounds.
    Within(Option<i128>, Option<i128>),
}

/// A step activated while it is active.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Activation {
    /// Its last cycle activates the step.
    pub path: Path,
    /// The transition that activates it.
    pub by: TransitionId,
}

/// A situation without a way on.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Deadlock {
    /// The partial grafcet that does not go on.
    pub partial: PartialId,
    /// Its active steps.
    pub steps: Vec<StepId>,
    /// How one gets there.
    pub path: Path,
}

/// An AND-convergence that waits forever.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct StuckJoin {
    /// The convergence.
    pub join: TransitionId,
    /// The source that is active.
    pub waiting: StepId,
    /// The transition by which the branch that is missing was left, or by which it was never entered.
    pub culprit: Option<TransitionId>,
    /// How one gets there.
    pub path: Path,
}

impl Path {
    /// `Start → Fill → Heat`, several steps as `(A, B)`; of a long way the beginning and the end.
    #[must_use]
    pub fn text(&self, model: &Model) -> String {
        const SHOWN: usize = 8;
        let mut situations: Vec<&Vec<StepId>> = std::iter::once(&self.start).and(self.situations()).list();
        situations.dedup();
        let befores = std::iter::once(&[][..]).and(situations.iter().map(|steps| &steps[..]));
        let mut names: Vec<String> =
            situations.iter().zip(befores).map(|(steps, before)| in_short(model, steps, before)).list();
        if names.len() > SHOWN {
            names.splice(2..=names.len() - SHOWN + 2, ["…".to_owned()]);
        }
        names.join(" → ")
    }

    fn situations(&self) -> impl Iterator<Item = &Vec<StepId>> {
        self.cycles.iter().map(|cycle| &cycle.active)
    }

    /// The active steps at its end.
    #[must_use]
    pub fn end(&self) -> &[StepId] {
        self.cycles.last().map_or(&self.start, |cycle| &cycle.active)
    }
}

/// A situation on a way; of many steps a few of those that were entered with it.
fn in_short(model: &Model, steps: &[StepId], before: &[StepId]) -> String {
    const SHOWN: usize = 8;
    if steps.len() <= SHOWN {
        return model.steps_text(steps);
    }
    let entered: Vec<StepId> = steps.iter().filter(|step| !before.contains(step)).copied().list();
    let shown = if entered.is_empty() { steps } else { &entered[..] };
    let names: Vec<String> = shown.iter().take(SHOWN / 2).map(|step| model.steps[*step].name.to_string()).list();
    format!("({}, and {} more)", names.join(", "), steps.len() - names.len())
}

impl Given {
    /// `start`, `!stop`, `level >= 10`.
    #[must_use]
    pub fn text(&self, model: &Model) -> String {
        let what = model.tree_text(&self.what);
        if let (Some(float), Demand::Within(low, high)) = (float(model, &self.what), self.demand) {
            return float_text(&what, float, low, high);
        }
        if let (Tree::Binary(Binary::Lt, a, b), Demand::Within(low, high)) = (&self.what, self.demand) {
            return compared(&model.tree_text(a), &model.tree_text(b), low, high);
        }
        if let (Some(variants), Demand::Within(low, high)) = (model.variants_of_tree(&self.what), self.demand) {
            let (first, last) = variants.range();
            return format!("{what} = {}", variants.text(low.unwrap_or(first), high.unwrap_or(last)));
        }
        let number =
            |number: i128| if is_time(model, &self.what) { model.time_text(number) } else { number.to_string() };
        match self.demand {
            Demand::Is(true) | Demand::Within(None, None) => what,
            Demand::Is(false) if what.contains(' ') => format!("!({what})"),
            Demand::Is(false) => format!("!{what}"),
            Demand::Within(Some(low), Some(high)) if low == high => format!("{what} == {}", number(low)),
            Demand::Within(Some(low), Some(high)) => format!("{what} in {}..={}", number(low), number(high)),
            Demand::Within(Some(low), None) => format!("{what} >= {}", number(low)),
            Demand::Within(None, Some(high)) => format!("{what} <= {}", number(high)),
        }
    }
}

/// How two numbers compare, one of which lies this far above the other.
fn compared(a: &str, b: &str, low: Option<i128>, high: Option<i128>) -> String {
    let sign = match (low, high) {
        (Some(0), Some(0)) => "==",
        (_, Some(0)) => "<=",
        (_, Some(_)) => "<",
        (Some(0), None) => ">=",
        (_, None) => ">",
    };
    format!("{a} {sign} {b}")
}

/// What is demanded of a float, by positions among all floats. A bound that nobody would write is the one beside it,
/// excluded.
fn float_text(what: &str, float: Float, low: Option<i128>, high: Option<i128>) -> String {
    let written = |position: i128| {
        let size = f64::from_bits(u64::try_from(position.unsigned_abs()).unwrap_or(u64::MAX));
        let value = if position < 0 { -size } else { size };
        #[allow(clippy::cast_possible_truncation, reason = "looked at whether it does")]
        let short = value as f32;
        let exact = f64::from(short).to_bits() == value.to_bits();
        match float {
            Float::F32 => exact.then(|| short.to_string()),
            Float::F64 => Some(value.to_string()),
        }
    };
    let length = |text: &Option<String>| text.as_ref().map_or(usize::MAX, String::len);
    let bound = |position: i128, beside: i128, sign: &str| {
        let (own, other) = (written(position), written(beside));
        let equal = if length(&own) <= length(&other) { "=" } else { "" };
        let text = if equal.is_empty() { other } else { own };
        format!("{what} {sign}{equal} {}", text.unwrap_or_default())
    };
    let finite = |position: &i128| position.unsigned_abs() < u128::from(f64::INFINITY.to_bits());
    let (low, high) = (low.filter(finite), high.filter(finite));
    match (low, high) {
        (Some(low), Some(high)) if low == high => format!("{what} == {}", written(low).unwrap_or_default()),
        (Some(low), Some(high)) => format!("{}, {}", bound(low, low - 1, ">"), bound(high, high + 1, "<")),
        (Some(low), None) => bound(low, low - 1, ">"),
        (None, Some(high)) => bound(high, high + 1, "<"),
        (None, None) => what.to_owned(),
    }
}

fn is_time(model: &Model, tree: &Tree) -> bool {
    match tree {
        Tree::Read(Read::Since(_) | Read::MacroSince(_)) => true,
        Tree::Read(Read::Name(name)) => model.is_time(*name),
        _ => false,
    }
}
