//! What is known of a chart, computed once: the checks and the lowering ask here.

use std::cell::OnceCell;

use super::{
    Concurrency, Nesting, Searches, Situations, Stability, combinational, exclusive, hierarchy, mixed, searches,
};
use crate::list::List;
use crate::model::{Model, PartialId, Place, StepId, Tree, VarId};
use crate::sorted::Set;

/// The facts of a chart whose drawing is in order.
pub struct Facts<'m> {
    /// The conditions that the chart says never hold.
    pub never: Vec<&'m Tree>,
    /// Which steps can be active together, whatever the plant does: what the generated code relies on.
    pub concurrency: Concurrency,
    /// The same if what the chart assumes is true, which is for the checks alone.
    pub assumed: Concurrency,
    /// The active steps of the initial situation.
    pub initial: Set<StepId>,
    /// The partial grafcets, what forces or encloses before what is forced or enclosed.
    pub top_down: Vec<PartialId>,
    /// Found out when somebody asks.
    combinational: OnceCell<Vec<VarId>>,
    mixed: OnceCell<Set<Place>>,
    nesting: OnceCell<Option<Nesting>>,
    across: OnceCell<Concurrency>,
    stability: OnceCell<Stability>,
    searches: OnceCell<Searches>,
    exclusive: OnceCell<Vec<bool>>,
    left_and_entered: OnceCell<Set<StepId>>,
    situations: OnceCell<Situations>,
}

impl<'m> Facts<'m> {
    /// Computes them.
    #[must_use]
    pub fn of(model: &'m Model) -> Self {
        let never: Vec<&Tree> = model.assumptions.iter().map(|assumption| &assumption.never.tree).list();
        let concurrency = Concurrency::of(model);
        let assumed = if never.is_empty() { concurrency.clone() } else { Concurrency::assuming(model, &never) };
        let top_down = hierarchy::top_down(model);
        Self {
            never,
            concurrency,
            assumed,
            initial: hierarchy::initial_situation_of(model, &top_down),
            top_down,
            combinational: OnceCell::new(),
            mixed: OnceCell::new(),
            nesting: OnceCell::new(),
            across: OnceCell::new(),
            stability: OnceCell::new(),
            searches: OnceCell::new(),
            exclusive: OnceCell::new(),
            left_and_entered: OnceCell::new(),
            situations: OnceCell::new(),
        }
    }

    /// The combinational variables, each after those it reads.
    #[must_use]
    pub(crate) fn combinational(&self, model: &Model) -> &[VarId] {
        self.combinational.get_or_init(|| combinational::in_order(model))
    }

    /// Places with actions of two kinds.
    #[must_use]
    pub(crate) fn mixed(&self, model: &Model) -> &Set<Place> {
        self.mixed.get_or_init(|| mixed(model))
    }

    /// What is known of a chart that is well nested.
    pub(super) fn nesting(&self, model: &Model) -> Option<&Nesting> {
        self.nesting.get_or_init(|| Nesting::starting(model, &self.initial)).as_ref()
    }

    /// Per step, whether at most one of its transitions can clear at a time: by priority in an `sfc`, by their conditions in a `grafcet`.
    #[must_use]
    pub fn exclusive(&self, model: &Model) -> &[bool] {
        self.exclusive.get_or_init(|| exclusive::exclusive(model))
    }

    /// Steps that one transition may take away while another gives them back in the same evolution.
    #[must_use]
    pub fn left_and_entered(&self, model: &Model) -> &Set<StepId> {
        let find = || exclusive::left_and_entered(model, &self.concurrency, self.exclusive(model));
        self.left_and_entered.get_or_init(find)
    }

    /// In which situations the chart can be.
    #[must_use]
    pub fn situations(&self, model: &Model) -> &Situations {
        self.situations.get_or_init(|| Situations::of(model, self))
    }

    /// Which steps can be active together where what partial grafcets do to each other counts, too, if what the chart assumes is true.
    #[must_use]
    pub fn across(&self, model: &Model) -> &Concurrency {
        self.across.get_or_init(|| self.assumed.across_partials_from(model, &self.initial, &Set::new()))
    }

    /// Whether the circles of a chart tell that each of its searches ends before its bound.
    #[must_use]
    pub fn all_end(&self, model: &Model) -> bool {
        !model.is_grafcet() || searches::are_ended(model, self.stability(model))
    }

    pub(super) fn stability(&self, model: &Model) -> &Stability {
        self.stability.get_or_init(|| Stability::of(model, &self.concurrency))
    }

    /// What is known of the searches of this model for stability.
    #[must_use]
    pub fn searches(&self, model: &Model) -> &Searches {
        self.searches.get_or_init(|| Searches::of(model, self))
    }
}
