//! Actions in their order, as few `match`es as that allows.

use std::collections::BTreeMap;

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};

use super::{Cx, names};
use crate::model::StepId;
use crate::plan::RegionId;

/// Something that happens in a cycle.
pub(super) enum Item {
    /// While a step is active before the evolution.
    Before(StepId, TokenStream),
    /// While a step is active after it.
    After(StepId, TokenStream),
    /// In every cycle.
    Always(TokenStream),
}

/// A `match` under construction.
struct Segment {
    before: bool,
    region: RegionId,
    arms: Vec<(StepId, TokenStream)>,
    /// Where each step's arm stands.
    places: BTreeMap<StepId, usize>,
}

impl Cx<'_> {
    /// One `match` for each run of items that look at the same region: their order is kept, since of a region's steps
    /// only one is active, and a step that is not active costs nothing.
    pub(super) fn in_order(&self, items: impl IntoIterator<Item = Item>) -> TokenStream {
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
                Some(segment) if segment.before == before && segment.region == region => {
                    let arms = &mut segment.arms;
                    let place = *segment.places.entry(step).or_insert_with(|| {
                        arms.push((step, TokenStream::new()));
                        arms.len() - 1
                    });
                    arms[place].1.extend(body);
                }
                _ => {
                    tokens.extend(open.take().map(|segment| self.segment(segment)));
                    open =
                        Some(Segment { before, region, arms: vec![(step, body)], places: BTreeMap::from([(step, 0)]) });
                }
            }
        }
        tokens.extend(open.map(|segment| self.segment(segment)));
        tokens
    }

    /// `local` is true while `step` is active. With two steps that is a comparison and no jump.
    pub(super) fn while_active(&self, step: StepId, local: &TokenStream) -> Item {
        if self.is_one_match() && self.model.steps.len() == 2 {
            let (after, variant) = (names::after(0, self.plan), self.variant(step));
            return Item::Always(quote!(#local |= #after == #variant;));
        }
        Item::After(step, quote!(#local = true;))
    }

    fn segment(&self, segment: Segment) -> TokenStream {
        let Segment { before, region, arms, .. } = segment;
        let state = match before {
            true => names::before(region, self.plan).to_token_stream(),
            // Read where it is used, not held in a register until then.
            false if self.in_place() => self.plain_state(region),
            false => names::after(region, self.plan).to_token_stream(),
        };
        let rest = (arms.len() < self.states(region)).then(|| self.other_states(region, &arms));
        let arms = arms.iter().map(|(step, body)| {
            let variant = self.variant(*step);
            quote!(#variant => { #body })
        });
        quote!(match #state { #(#arms)* #rest })
    }

    /// The arm for the states that `arms` leave out.
    fn other_states(&self, region: RegionId, arms: &[(StepId, TokenStream)]) -> TokenStream {
        if !self.is_wide() || self.has_start_variant(region) || self.states(region).is_power_of_two() {
            return quote!(_ => {});
        }
        let steps = self.plan.regions.all()[region].steps.iter();
        let others = steps.filter(|step| arms.iter().all(|(other, _)| other != *step)).map(|step| self.variant(*step));
        quote!(#(#others)|* => {})
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
        let region = self.plan.regions.of_step(step);
        let (after, variant, again) = (names::after(region, self.plan), self.variant(step), self.or_again(region));
        let nothing = body.is_empty();
        Item::Before(step, if nothing { TokenStream::new() } else { quote!(if #after != #variant #again { #body }) })
    }

    /// `body`, if the step has been entered.
    pub(super) fn if_entered(&self, step: StepId, body: &TokenStream) -> Item {
        if self.always_moves() {
            return Item::After(step, body.clone());
        }
        let region = self.plan.regions.of_step(step);
        let (before, variant, again) = (names::before(region, self.plan), self.variant(step), self.or_again(region));
        let nothing = body.is_empty();
        Item::After(step, if nothing { TokenStream::new() } else { quote!(if #before != #variant #again { #body }) })
    }

    /// In the search of a chart with one region, an evolution that changes anything goes from one step to another.
    fn always_moves(&self) -> bool {
        self.model.is_grafcet() && self.plan.regions.all().len() == 1 && self.only_situation
    }

    /// `|| again`, where a step of the region can be left and entered in one evolution.
    pub(super) fn or_again(&self, region: RegionId) -> Option<TokenStream> {
        self.plan.sees_reentry[region].then(|| {
            let again = names::again(region, self.plan);
            quote!(|| #again)
        })
    }
}
