//! A chart as data: what is drawn of it, for whoever wants to show it.

#[doc(hidden)]
pub mod table;

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
    /// The named conditions, which the texts use by their names.
    pub lets: &'a [Let<'a>],
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
    /// What its doc comment says first, up to an empty line.
    pub doc: &'a str,
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
    /// What its doc comment says first, up to an empty line.
    pub doc: &'a str,
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
    /// How long it may be active before it is late, `10s`; empty where nothing is said.
    pub within: &'a str,
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
    /// The condition after `if`, or the event of `on`.
    pub condition: &'a str,
    /// `relay`, `heat(80)`, `count = count + 1`
    pub text: &'a str,
}

/// A transition.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Transition<'a> {
    /// Empty where it has none.
    pub name: &'a str,
    /// The steps before it, which are all active where it clears; none for a source transition, and for an `any`.
    pub sources: &'a [usize],
    /// What an `any` leaves; none for all other transitions.
    pub any: Option<Any<'a>>,
    /// The steps after it; none for a sink transition.
    pub targets: &'a [usize],
    /// The transition condition as it stands in the source.
    pub condition: &'a str,
    /// What is done when it clears, in source order.
    pub clearing: &'a [&'a str],
}

/// What a transition leaves that is written as `any`: those of many steps that are active.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Any<'a> {
    /// The steps of its net that it leaves: all but its targets and what is left out.
    pub steps: &'a [usize],
    /// What is left out, as it is written: the names of steps and macro-steps.
    pub except: &'a [&'a str],
}

/// A named condition, `let go = auto || rising(next);`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Let<'a> {
    /// `go`
    pub name: &'a str,
    /// `auto || rising(next)`
    pub text: &'a str,
    /// What its doc comment says first, up to an empty line.
    pub doc: &'a str,
}

impl<'a> Partial<'a> {
    /// One that is no enclosure.
    #[must_use]
    pub const fn new(name: &'a str) -> Self {
        Self { name, enclosed_by: None, doc: "" }
    }

    /// The same as an enclosure of the step of this number.
    #[must_use]
    pub const fn enclosed_by(self, step: usize) -> Self {
        Self { enclosed_by: Some(step), ..self }
    }

    /// The same with a doc comment.
    #[must_use]
    pub const fn documented(self, doc: &'a str) -> Self {
        Self { doc, ..self }
    }
}

impl<'a> MacroStep<'a> {
    /// One that stands in no expansion.
    #[must_use]
    pub const fn new(name: &'a str, entry: usize, exit: usize) -> Self {
        Self { name, outer: None, entry, exit, doc: "" }
    }

    /// The same in the expansion of the macro-step of this number.
    #[must_use]
    pub const fn inside(self, outer: usize) -> Self {
        Self { outer: Some(outer), ..self }
    }

    /// The same with a doc comment.
    #[must_use]
    pub const fn documented(self, doc: &'a str) -> Self {
        Self { doc, ..self }
    }
}

impl<'a> Step<'a> {
    /// One that is neither initial nor linked, and stands in no expansion.
    #[must_use]
    pub const fn new(name: &'a str, partial: usize, actions: &'a [Action<'a>], forces: &'a [&'a str]) -> Self {
        Self { name, initial: false, linked: false, partial, expansion: None, actions, within: "", forces }
    }

    /// The same with a time after which it is late.
    #[must_use]
    pub const fn within(self, within: &'a str) -> Self {
        Self { within, ..self }
    }

    /// The same as an initial step.
    #[must_use]
    pub const fn initial(self) -> Self {
        Self { initial: true, ..self }
    }

    /// The same with the activation link of its enclosure.
    #[must_use]
    pub const fn linked(self) -> Self {
        Self { linked: true, ..self }
    }

    /// The same in the expansion of the macro-step of this number.
    #[must_use]
    pub const fn inside(self, expansion: usize) -> Self {
        Self { expansion: Some(expansion), ..self }
    }
}

impl<'a> Action<'a> {
    /// All of an association, in the order of its fields.
    #[must_use]
    pub const fn new(qualifier: &'a str, time: &'a str, condition: &'a str, text: &'a str) -> Self {
        Self { qualifier, time, condition, text }
    }
}

impl<'a> Transition<'a> {
    /// All of a transition, in the order of its fields.
    #[must_use]
    pub const fn new(
        name: &'a str,
        sources: &'a [usize],
        targets: &'a [usize],
        condition: &'a str,
        clearing: &'a [&'a str],
    ) -> Self {
        Self { name, sources, any: None, targets, condition, clearing }
    }

    /// The same as one that leaves whatever is active of these steps: all of its net but its targets and what `except` names.
    #[must_use]
    pub const fn from_any(self, steps: &'a [usize], except: &'a [&'a str]) -> Self {
        Self { any: Some(Any { steps, except }), ..self }
    }
}

impl<'a> Let<'a> {
    /// A name for a condition.
    #[must_use]
    pub const fn new(name: &'a str, text: &'a str) -> Self {
        Self { name, text, doc: "" }
    }

    /// The same with a doc comment.
    #[must_use]
    pub const fn documented(self, doc: &'a str) -> Self {
        Self { doc, ..self }
    }
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
