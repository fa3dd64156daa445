//! The fields of a chart's struct: what its regions, places, times, edges and actions keep from cycle to cycle.

use proc_macro2::Literal;

use super::control::set_by;
use super::machine::Field;
use super::{Cx, names, types};
use crate::list::{List, PushAll};
use crate::model::{Place, Qualifier};
use crate::place::quote;
use crate::plan::{Target, What};

impl Cx<'_> {
    /// All of them, in the order in which the struct has them.
    pub(super) fn fields(&self) -> Vec<Field> {
        let mut fields = self.region_fields();
        fields.push_all(self.place_fields());
        fields.push_all(self.time_fields());
        fields.push_all(self.control_fields());
        fields.push_all(self.call_fields());
        fields
    }

    fn flag(&self, name: &str, initial: bool) -> Field {
        let p = &self.p;
        Field { name: names::own(name), ty: quote!(#p::bool), initial: quote!(#initial) }
    }

    fn region_fields(&self) -> Vec<Field> {
        if self.plan.shape.is_flags() {
            let (p, bytes) = (&self.p, Literal::usize_suffixed(self.flag_bytes()));
            return vec![Field {
                name: names::own("situation"),
                ty: quote!([#p::u8; #bytes]),
                initial: self.first_flags(),
            }];
        }
        let one = |region| Field {
            name: names::region_field(region, self.plan),
            ty: {
                let marked = self.is_marked(region).then(|| self.names.marked(self.plan));
                let name = marked.unwrap_or_else(|| self.names.region(region, self.plan));
                quote!(#name)
            },
            initial: {
                let start = self.has_start_variant(region);
                self.held(region, &if start { self.start() } else { self.initial(region) })
            },
        };
        (0..self.plan.regions.all().len()).map(one).list()
    }

    /// Remembered outputs, variables and the values that edges compare with.
    fn place_fields(&self) -> Vec<Field> {
        let output = |id, name| Field {
            name,
            ty: types::rust_type(&self.model.outputs[id].ty, &self.p),
            initial: types::initial_output(self.model, id, &self.p),
        };
        let stored = self.plan.memory.stored.iter().map(|id| output(*id, names::output_field(self.model, *id)));
        let last = self.plan.memory.last.iter().map(|id| output(*id, names::output_last_field(self.model, *id)));
        let mut fields: Vec<_> = stored.and(last).list();
        fields.push_all(self.plan.memory.vars.iter().map(|id| {
            let var = &self.model.vars[*id];
            Field {
                name: names::var_field(self.model, *id),
                ty: types::rust_type(&var.ty, &self.p),
                initial: types::initial_value(var.init.as_ref(), &var.ty, &self.p),
            }
        }));
        // After a value that was true no edge rises: there is none in the first cycle (A26).
        let edges = self.plan.memory.edges.iter();
        fields.push_all(
            edges.map(|(id, rising, falling)| self.flag(&names::edge_field(*id).to_string(), *rising && !falling)),
        );
        fields.push_all(
            self.plan
                .memory
                .late_edges
                .iter()
                .map(|(id, rising, falling)| self.flag(&names::late_edge(*id, None).to_string(), *rising && !falling)),
        );
        fields
    }

    fn time_fields(&self) -> Vec<Field> {
        if !self.plan.memory.time {
            return Vec::new();
        }
        let p = &self.p;
        let ticks = |name| Field { name, ty: quote!(#p::Ticks), initial: quote!(#p::Ticks::ZERO) };
        let mut fields = vec![ticks(names::own("now"))];
        fields.push_all(self.left_over_field().map(|(name, ty, initial)| Field { name, ty, initial }));
        fields.push_all(self.timed_regions().map(|region| {
            let (name, time) = (names::step_time(region, self.plan), self.time_type(region));
            Field { name, initial: quote!(#time::ZERO), ty: time }
        }));
        fields.push_all(self.plan.memory.macro_times.iter().map(|id| ticks(names::macro_time(*id))));
        fields.push_all((0..self.plan.memory.phases.len()).map(|index| ticks(names::phase(index))));
        fields.push_all(self.model.delays.ids().map(|id| Field {
            name: names::delay_field(id),
            ty: quote!(#p::Delay),
            initial: quote!(#p::Delay::new()),
        }));
        fields
    }

    /// The flip-flops, timers and memories of the action control, as far as a target needs them.
    fn control_fields(&self) -> Vec<Field> {
        let targets = self.plan.control.targets.iter().enumerate();
        targets.flat(|(index, target)| self.target_fields(index, target)).list()
    }

    fn target_fields(&self, index: usize, target: &Target) -> Vec<Field> {
        let p = &self.p;
        let name = |prefix: &str| names::target(prefix, self.model, index, target);
        let mut fields = Vec::new();
        for qualifier in
            Qualifier::ALL.into_iter().filter(|qualifier| qualifier.has_flip_flop() || qualifier.has_time())
        {
            if !target.has(self.model, qualifier) {
                continue;
            }
            let flag = names::flag(qualifier);
            if qualifier.has_flip_flop() {
                let initial = qualifier == Qualifier::S && self.starts_set(target);
                fields.push(self.flag(&name(&format!("memory_{flag}")).to_string(), initial));
            }
            if qualifier.has_time() {
                let (ty, initial) = (quote!(#p::OnDelay), quote!(#p::OnDelay::new()));
                fields.push(Field { name: name(&format!("timer_{flag}")), ty, initial });
            }
            if target.remembers_time(self.model, qualifier) {
                let ty = names::number_type(target.associations.len(), p);
                fields.push(Field { name: name(&format!("time_{flag}")), ty, initial: quote!(0) });
            }
            if qualifier.has_flip_flop() && target.chooses_under(self.model, qualifier) {
                let ty = names::number_type(target.associations.len(), p);
                fields.push(Field { name: name(&set_by(qualifier)), ty, initial: quote!(0) });
            }
        }
        if target.remembers_q && target.remembers_terms(self.model) {
            for qualifier in target.leavable(self.model) {
                fields.push(self.flag(&name(&format!("kept_{}", names::flag(qualifier))).to_string(), false));
            }
        }
        for id in &target.remembers_held {
            fields.push(self.flag(&name(&names::held(target, *id)).to_string(), false));
        }
        if target.remembers_q {
            fields.push(self.flag(&name("kept_q").to_string(), false));
        }
        if target.remembers_association {
            fields.push(Field {
                name: name("association"),
                ty: names::number_type(target.associations.len(), p),
                initial: quote!(0),
            });
        }
        fields
    }

    /// A boolean that only S and R control starts with its initial value.
    fn starts_set(&self, target: &Target) -> bool {
        let only = target.associations.iter().all(|id| self.model.associations[*id].qualifier.sets_or_resets());
        let init = match target.what {
            What::Boolean(Place::Output(id)) => self.model.outputs[id].init.as_ref(),
            What::Boolean(Place::Var(id)) => self.model.vars[id].init.as_ref(),
            What::Runs => None,
        };
        only && init.is_some_and(|init| init.tree == crate::model::Tree::Bool(true))
    }

    /// `grafcet`: what the phase and the arguments of a continuous call follow from.
    fn call_fields(&self) -> Vec<Field> {
        let mut fields = Vec::new();
        if !self.model.is_grafcet() {
            return fields;
        }
        for action in self.model.actions.ids().filter(|id| !self.continuous_calls_of(*id).is_empty()) {
            fields.push(self.flag(&names::called(self.model, action).to_string(), false));
            if self.remembers_call(action) {
                let ty = names::number_type(self.continuous_calls_of(action).len(), &self.p);
                fields.push(Field { name: names::called_number(self.model, action), ty, initial: quote!(0) });
            }
        }
        fields
    }
}
