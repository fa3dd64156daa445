//! A chart as data: what is drawn of it, for whoever wants to show it.

/// What a chart looks like: its steps, transitions and actions as they stand in the source.
///
/// Steps, transitions, partial grafcets and macro-steps are numbered in the order of their declaration; where one names
/// another, it does so by that number. A chart `Motor` has its description as `Motor::CHART`, a constant that takes no
/// place in a program that does not use it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Description<'a> {
    /// `Motor`
    pub name: &'a str,
    /// By whose rules it evolves and is drawn.
    pub dialect: Dialect,
    /// The partial grafcets; the first is what stands directly in the chart and may be empty.
    pub partials: &'a [Partial<'a>],
    /// The macro-steps.
    pub macros: &'a [MacroStep<'a>],
    /// All steps, those of expansions and enclosures included.
    pub steps: &'a [Step<'a>],
    /// All transitions.
    pub transitions: &'a [Transition<'a>],
}

/// By whose rules a chart evolves.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Dialect {
    /// IEC 61131-3, sequential function chart.
    Sfc,
    /// IEC 60848, GRAFCET.
    Grafcet,
}

/// A partial grafcet.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Partial<'a> {
    /// Empty for what stands directly in the chart.
    pub name: &'a str,
    /// The enclosing step, for an enclosure.
    pub enclosed_by: Option<usize>,
}

/// A macro-step (IEC 60848, 4.9). Transitions to it lead to `entry`, those from it start at `exit`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct MacroStep<'a> {
    /// Its name in the source.
    pub name: &'a str,
    /// The macro-step in whose expansion it stands.
    pub outer: Option<usize>,
    /// The first step of its expansion.
    pub entry: usize,
    /// The last step of its expansion.
    pub exit: usize,
}

/// A step.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Step<'a> {
    /// Its name in the source.
    pub name: &'a str,
    /// Active in the initial situation.
    pub initial: bool,
    /// Carries the activation link of its enclosure.
    pub linked: bool,
    /// The partial grafcet it stands in.
    pub partial: usize,
    /// The macro-step in whose expansion it stands, the innermost.
    pub expansion: Option<usize>,
    /// In source order.
    pub actions: &'a [Action<'a>],
    /// Forcing orders, e.g. `Modes {INIT}`, in source order.
    pub forces: &'a [&'a str],
}

/// A step's association with an action. What is not there is an empty text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Action<'a> {
    /// `N`, `SD`; `on` for an action on event.
    pub qualifier: &'a str,
    /// The time of the qualifier: `5s`.
    pub time: &'a str,
    /// The condition behind `if`, or the event of `on`.
    pub condition: &'a str,
    /// `relay`, `heat(80)`, `count = count + 1`
    pub text: &'a str,
}

/// A transition.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Transition<'a> {
    /// Empty where it has none.
    pub name: &'a str,
    /// The steps before it; none for a source transition.
    pub sources: &'a [usize],
    /// The steps behind it; none for a sink transition.
    pub targets: &'a [usize],
    /// The transition condition as it stands in the source.
    pub condition: &'a str,
    /// What is done when it clears, in source order.
    pub clearing: &'a [&'a str],
}

/// Which steps of a chart are active, asked by the numbers of its [`Description`].
///
/// Implemented by what `situation()` returns.
pub trait ActiveSteps {
    /// Whether the step of this number is active; `false` where there is none.
    fn is_active_at(&self, step: usize) -> bool;
}

/// No step is active: the chart alone.
impl ActiveSteps for () {
    fn is_active_at(&self, _: usize) -> bool {
        false
    }
}
