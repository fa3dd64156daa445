//! The actions of one cycle, and the outputs they lead to.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::bind::Moment;
use super::{Cx, names};
use crate::model::{Association, Dialect, Effect, Id, OutputId, Place, Qualifier, StepId};
use crate::plan::RegionId;

/// The part of a cycle in which an association acts.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    /// P0, when the step is left.
    Deactivation,
    /// P1 and P, when the step is entered; in a `grafcet` also S and R.
    Activation,
    /// While the step is active.
    Activity,
}

impl Cx<'_> {
    /// The actions of an `sfc`: deactivations, then activations, then the rest (A29).
    pub(super) fn sfc_actions(&self) -> TokenStream {
        let last = self.keep_last_outputs();
        let locals = self.output_locals();
        let left = self.on_leaving(Moment::Action);
        let active = if self.plan.regions.all().len() == 1 {
            self.while_active(&[Part::Activation, Part::Activity], Moment::Action)
        } else {
            let entered = self.while_active(&[Part::Activation], Moment::Action);
            let rest = self.while_active(&[Part::Activity], Moment::Action);
            quote!(#entered #rest)
        };
        let resets = self.apply_resets();
        quote!(#last #locals #left #active #resets)
    }

    /// The stored actions of one evolution of a `grafcet`.
    pub(super) fn stored_actions(&self) -> TokenStream {
        let last = self.keep_last_outputs();
        let left = self.on_leaving(Moment::Stored);
        let entered = self.while_active(&[Part::Activation], Moment::Stored);
        let resets = self.apply_resets();
        if left.is_empty() && entered.is_empty() {
            return TokenStream::new();
        }
        let flags = self.reset_locals();
        quote!(#last #flags #left #entered #resets)
    }

    /// The stored actions on the activation of the initial situation (A37).
    pub(super) fn initial_stored_actions(&self) -> TokenStream {
        let initial = self.plan.regions.all().iter().filter_map(|region| region.initial);
        let mut steps: Vec<_> = initial.collect();
        steps.sort_unstable();
        let effects = steps.iter().map(|step| self.effects(*step, Part::Activation, Moment::Start));
        let effects: TokenStream = effects.collect();
        if effects.is_empty() {
            return effects;
        }
        let (flags, resets) = (self.reset_locals(), self.apply_resets());
        quote!(#flags #effects #resets)
    }

    /// The continuous actions of a `grafcet`, on the stable situation (A9).
    pub(super) fn continuous_actions(&self) -> TokenStream {
        let locals = self.output_locals();
        let active = self.while_active(&[Part::Activity], Moment::Stable);
        let states = (0..self.plan.regions.all().len()).map(|region| {
            let (after, field) = (names::after(region, self.plan), names::region_field(region, self.plan));
            quote!(let #after = self.#field;)
        });
        if active.is_empty() { locals } else { quote!(#locals #(#states)* #active) }
    }

    /// `match before { Off => if after != Off { … } }`
    fn on_leaving(&self, moment: Moment) -> TokenStream {
        self.by_segments(names::before, |step, region| {
            let effects = self.effects(step, Part::Deactivation, moment);
            let (after, variant) = (names::after(region, self.plan), self.variant(step));
            let again = self.again(region);
            (!effects.is_empty()).then(|| quote!(if #after != #variant #again { #effects }))
        })
    }

    /// `match after { On => { if before != On { … } … } }`
    fn while_active(&self, parts: &[Part], moment: Moment) -> TokenStream {
        self.by_segments(names::after, |step, region| {
            let mut body = TokenStream::new();
            for part in parts {
                let effects = self.effects(step, *part, moment);
                if effects.is_empty() {
                    continue;
                }
                body.extend(match part {
                    Part::Activation => {
                        let (before, variant) = (names::before(region, self.plan), self.variant(step));
                        let again = self.again(region);
                        quote!(if #before != #variant #again { #effects })
                    }
                    Part::Activity | Part::Deactivation => effects,
                });
            }
            (!body.is_empty()).then_some(body)
        })
    }

    /// `|| again`, where a step of the region can be left and entered in one evolution. In a `grafcet` it then stays
    /// active (A4g).
    fn again(&self, region: RegionId) -> Option<TokenStream> {
        self.plan.sees_reentry[region].then(|| {
            let again = names::again(region, self.plan);
            quote!(|| #again)
        })
    }

    /// One `match` for each run of steps, in source order, that share a region: the source order of the actions is
    /// kept, and a step that is not active costs nothing.
    fn by_segments(
        &self,
        state: fn(RegionId, &crate::plan::Plan) -> Ident,
        body: impl Fn(StepId, RegionId) -> Option<TokenStream>,
    ) -> TokenStream {
        let mut segments: Vec<(RegionId, TokenStream, usize)> = Vec::new();
        for step in self.model.steps.ids() {
            let region = self.plan.regions.of_step(step);
            let Some(body) = body(step, region) else { continue };
            let variant = self.variant(step);
            let arm = quote!(#variant => { #body });
            match segments.last_mut() {
                Some((last, arms, count)) if *last == region => {
                    arms.extend(arm);
                    *count += 1;
                }
                _ => segments.push((region, arm, 1)),
            }
        }
        let one = |(region, arms, count): (RegionId, TokenStream, usize)| {
            let state = state(region, self.plan);
            let rest = (count < self.states(region)).then(|| quote!(_ => {}));
            quote!(match #state { #arms #rest })
        };
        segments.into_iter().map(one).collect()
    }

    /// How many states a region has.
    pub(super) fn states(&self, region: RegionId) -> usize {
        let steps = &self.plan.regions.all()[region];
        steps.steps.len() + usize::from(steps.may_be_empty) + usize::from(self.has_start_variant(region))
    }

    /// What the associations of a step do in one part of the cycle, in source order.
    fn effects(&self, step: StepId, part: Part, moment: Moment) -> TokenStream {
        let associations = self.model.steps[step].associations.iter().map(|id| &self.model.associations[*id]);
        associations.filter(|association| self.part(association) == part).map(|a| self.effect(a, moment)).collect()
    }

    fn part(&self, association: &Association) -> Part {
        match association.qualifier {
            Qualifier::P0 => Part::Deactivation,
            Qualifier::P1 | Qualifier::P => Part::Activation,
            Qualifier::S | Qualifier::R if self.model.dialect == Dialect::Grafcet => Part::Activation,
            _ => Part::Activity,
        }
    }

    fn effect(&self, association: &Association, moment: Moment) -> TokenStream {
        let act = match &association.effect {
            Effect::Control(Place::Output(output)) => self.control(*output, association.qualifier),
            Effect::Assign(Place::Output(output), value) => {
                let value = self.value(value, moment);
                if association.qualifier == Qualifier::N {
                    let local = names::output_local(self.model, *output);
                    quote!(#local = #value;)
                } else {
                    let field = names::output_field(self.model, *output);
                    quote!(self.#field = #value;)
                }
            }
            // The gate in front of codegen refuses what is not compiled yet.
            Effect::Control(Place::Var(_)) | Effect::Assign(Place::Var(_), _) | Effect::Call(..) | Effect::Block(_) => {
                TokenStream::new()
            }
        };
        match &association.condition {
            Some(condition) => {
                let condition = self.value(condition, moment);
                quote!(if #condition { #act })
            }
            None => act,
        }
    }

    /// A boolean output under a qualifier.
    fn control(&self, output: OutputId, qualifier: Qualifier) -> TokenStream {
        let field = names::output_field(self.model, output);
        match qualifier {
            Qualifier::S => quote!(self.#field = true;),
            Qualifier::R if self.plan.drives[output.index()].reset_flag => {
                let reset = names::output_reset(self.model, output);
                quote!(#reset = true;)
            }
            Qualifier::R => quote!(self.#field = false;),
            _ => {
                let local = names::output_local(self.model, output);
                quote!(#local = true;)
            }
        }
    }

    /// The outputs of the cycle before, where an action reads them.
    fn keep_last_outputs(&self) -> TokenStream {
        let read = self.model.outputs.ids().filter(|id| self.plan.drives[id.index()].read_by_actions);
        read.map(|id| {
            let (last, field) = (names::output_last(self.model, id), names::output_field(self.model, id));
            quote!(let #last = self.#field;)
        })
        .collect()
    }

    /// The locals that collect what is true in this cycle only.
    fn output_locals(&self) -> TokenStream {
        let continuous = self.model.outputs.ids().filter(|id| self.plan.drives[id.index()].continuous);
        let locals = continuous.map(|id| {
            let (local, initial) = (names::output_local(self.model, id), self.initial_output(id));
            quote!(let mut #local = #initial;)
        });
        let locals: TokenStream = locals.collect();
        let flags = (self.model.dialect == Dialect::Sfc).then(|| self.reset_locals());
        quote!(#locals #flags)
    }

    fn reset_locals(&self) -> TokenStream {
        let flagged = self.model.outputs.ids().filter(|id| self.plan.drives[id.index()].reset_flag);
        flagged.map(|id| names::output_reset(self.model, id)).map(|reset| quote!(let mut #reset = false;)).collect()
    }

    /// Reset dominates: it comes behind everything that sets.
    fn apply_resets(&self) -> TokenStream {
        let flagged = self.model.outputs.ids().filter(|id| self.plan.drives[id.index()].reset_flag);
        flagged
            .map(|id| {
                let drive = &self.plan.drives[id.index()];
                let reset = names::output_reset(self.model, id);
                let field = names::output_field(self.model, id);
                let local = names::output_local(self.model, id);
                let stored = drive.stored.then(|| quote!(self.#field = false;));
                let continuous = drive.continuous.then(|| quote!(#local = false;));
                quote!(if #reset { #stored #continuous })
            })
            .collect()
    }

    fn initial_output(&self, output: OutputId) -> TokenStream {
        super::types::initial_output(self.model, output, &self.p)
    }

    /// The outputs `cycle` returns.
    pub(super) fn result(&self) -> TokenStream {
        let outputs = &self.names.outputs;
        let fields = self.model.outputs.iter().map(|(id, output)| {
            let name = &output.name;
            let drive = &self.plan.drives[id.index()];
            let (local, field) = (names::output_local(self.model, id), names::output_field(self.model, id));
            let value = match (drive.continuous, drive.stored) {
                (true, true) => quote!(#local || self.#field),
                (true, false) => quote!(#local),
                (false, true) => quote!(self.#field),
                (false, false) => self.initial_output(id),
            };
            quote!(#name: #value,)
        });
        let result = quote!(#outputs { #(#fields)* });
        if self.plan.last.is_empty() {
            return result;
        }
        let remember = self.plan.last.iter().map(|id| {
            let (field, name) = (names::output_field(self.model, *id), &self.model.outputs[*id].name);
            quote!(self.#field = outputs.#name;)
        });
        quote!(let outputs = #result; #(#remember)* outputs)
    }
}
