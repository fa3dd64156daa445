//! Actions in their order, as few `match`es as that allows.

use proc_macro2::TokenStream;
use quote::ToTokens;

use super::situation::At;
use super::{Cx, names};
use crate::list::List;
use crate::model::{Association, Effect, Expr, StepId};
use crate::place::quote;
use crate::plan::{RegionId, is_stored};
use crate::sorted::{Map, sort_by_key};

/// Something that happens in a cycle.
pub(super) enum Item {
    /// While a step is active before the evolution.
    Before(StepId, TokenStream),
    /// While a step is active after it.
    After(StepId, TokenStream),
    /// In every cycle.
    Always(TokenStream),
}

impl Item {
    fn is_empty(&self) -> bool {
        let (Self::Before(_, body) | Self::After(_, body) | Self::Always(body)) = self;
        body.is_empty()
    }

    /// What happens.
    pub(super) fn into_body(self) -> TokenStream {
        let (Self::Before(_, body) | Self::After(_, body) | Self::Always(body)) = self;
        body
    }
}

/// A `match` under construction.
struct Segment {
    before: bool,
    region: RegionId,
    arms: Vec<(StepId, TokenStream)>,
    /// Where each step's arm stands.
    places: Map<StepId, usize>,
}

impl Cx<'_> {
    /// One `match` for each run of items that look at the same region: their order is kept, since of a region's steps
    /// only one is active, and a step that is not active costs nothing.
    pub(super) fn in_order(&self, items: impl IntoIterator<Item = Item>) -> TokenStream {
        self.all_in_order(items.into_iter().list())
    }

    fn all_in_order(&self, items: Vec<Item>) -> TokenStream {
        let mut tokens = TokenStream::new();
        let mut open: Option<Segment> = None;
        for item in items {
            let (before, step, body) = match item {
                Item::Before(step, body) => (true, step, body),
                Item::After(step, body) => (false, step, body),
                Item::Always(body) => {
                    tokens.extend(open.take().map(|segment| self.segment(segment)));
                    tokens.extend(body);
                    continue;
                }
            };
            if body.is_empty() {
                continue;
            }
            let region = self.plan.regions.of_step(step);
            match &mut open {
                Some(segment) if segment.before == before && self.joins(segment, region) => {
                    let arms = &mut segment.arms;
                    let place = *segment.places.or_insert_with(step, || {
                        arms.push((step, TokenStream::new()));
                        arms.len() - 1
                    });
                    arms[place].1.extend(body);
                }
                _ => {
                    tokens.extend(open.take().map(|segment| self.segment(segment)));
                    open = Some(Segment { before, region, arms: vec![(step, body)], places: Map::from([(step, 0)]) });
                }
            }
        }
        tokens.extend(open.map(|segment| self.segment(segment)));
        tokens
    }

    /// One `match` for each region, for items of which none sees what another one does. Where conditions or values call
    /// functions of the user, those keep their order.
    pub(super) fn in_any_order(&self, items: impl IntoIterator<Item = Item>) -> TokenStream {
        self.all_in_any_order(items.into_iter().filter(|item| !item.is_empty()).list())
    }

    fn all_in_any_order(&self, mut items: Vec<Item>) -> TokenStream {
        let opaque = |expr: &Expr| expr.tree.is_opaque();
        let continuous = |association: &&Association| !self.model.is_grafcet() || !is_stored(association);
        let mut associations = self.model.associations.values().filter(continuous);
        let calls = associations.any(|association| {
            let value = match &association.effect {
                Effect::Assign(_, value) => Some(value),
                _ => None,
            };
            association.condition.iter().and(value).any(opaque)
        });
        if !calls && !self.plan.shape.is_flags() {
            let mut regions = Vec::new();
            for region in items.iter().map(|item| self.region_of(item)) {
                if !regions.contains(&region) {
                    regions.push(region);
                }
            }
            sort_by_key(&mut items, |item| regions.iter().position(|region| *region == self.region_of(item)));
            let groups = self.plan.groups.as_ref().filter(|_| items.iter().all(|item| matches!(item, Item::After(..))));
            if let Some(groups) = groups {
                return self.side_by_side(groups, items);
            }
        }
        self.all_in_order(items)
    }

    /// Whose state the item looks at, and when.
    pub(super) fn region_of(&self, item: &Item) -> Option<(bool, RegionId)> {
        match item {
            Item::Before(step, _) => Some((true, self.plan.regions.of_step(*step))),
            Item::After(step, _) => Some((false, self.plan.regions.of_step(*step))),
            Item::Always(_) => None,
        }
    }

    /// Whether an item of this region belongs into the segment. With a bit for each step that is one of a step after all
    /// of the segment, or any where only one step is active.
    fn joins(&self, segment: &Segment, region: RegionId) -> bool {
        if !self.plan.shape.is_flags() {
            return segment.region == region;
        }
        let behind = |(last, _): &(StepId, TokenStream)| self.plan.regions.of_step(*last) <= region;
        self.plan.most_active == 1 || segment.arms.last().is_some_and(behind)
    }

    fn segment(&self, segment: Segment) -> TokenStream {
        let Segment { before, region, mut arms, .. } = segment;
        if self.plan.shape.is_flags() {
            sort_by_key(&mut arms, |(step, _)| *step);
            return self.visit(if before { At::Before } else { At::After }, &arms);
        }
        let state = if before { names::before(region, self.plan).to_token_stream() } else { self.state_after(region) };
        let rest = (arms.len() < self.states(region)).then(|| quote!(_ => {}));
        let arms = arms.iter().map(|(step, body)| {
            let variant = self.variant(*step);
            quote!(#variant => { #body })
        });
        quote!(match #state { #(#arms)* #rest })
    }

    /// The state of a region after the evolution, where it happens in place not held in a register until then.
    pub(super) fn state_after(&self, region: RegionId) -> TokenStream {
        if self.plan.shape.is_in_place() {
            self.plain_state(region)
        } else {
            names::after(region, self.plan).to_token_stream()
        }
    }

    /// How many states a region has.
    pub(super) fn states(&self, region: RegionId) -> usize {
        let plan = &self.plan.regions.all()[region];
        let states = plan.steps.len() + usize::from(plan.may_be_empty);
        states + usize::from(self.has_start_variant(region))
    }

    /// `body`, if the step has been left.
    pub(super) fn if_left(&self, step: StepId, body: &TokenStream) -> Item {
        if self.always_moves() {
            return Item::Before(step, body.clone());
        }
        let (left, again) = (self.not_in_step(At::After, step), self.or_again(self.plan.regions.of_step(step)));
        let nothing = body.is_empty();
        Item::Before(step, if nothing { TokenStream::new() } else { quote!(if #left #again { #body }) })
    }

    /// `body`, if the step has been entered.
    pub(super) fn if_entered(&self, step: StepId, body: &TokenStream) -> Item {
        if self.always_moves() {
            return Item::After(step, body.clone());
        }
        let (entered, again) = (self.not_in_step(At::Before, step), self.or_again(self.plan.regions.of_step(step)));
        let nothing = body.is_empty();
        Item::After(step, if nothing { TokenStream::new() } else { quote!(if #entered #again { #body }) })
    }

    /// Where one step is active at most, an evolution of a search that changes anything goes from one step to another.
    fn always_moves(&self) -> bool {
        self.model.is_grafcet() && self.plan.most_active == 1 && self.plan.shape.only_situation
    }

    /// `|| again`, where a step of the region can be left and entered in one evolution.
    pub(super) fn or_again(&self, region: RegionId) -> Option<TokenStream> {
        self.plan.sees_reentry[region].then(|| {
            let again = names::again(region, self.plan);
            quote!(|| #again)
        })
    }
}
