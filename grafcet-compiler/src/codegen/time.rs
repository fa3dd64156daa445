//! What happens to times, edges and delays at the begin of a cycle and at the end of an evolution.

use proc_macro2::{Ident, TokenStream};

use super::bind::Moment;
use super::situation::At;
use super::{Cx, names};
use crate::analysis::combinational::asserted;
use crate::list::{List, PushAll};
use crate::model::{DelayId, EdgeId, Expr, Name, Read, StepId, Transition, VarId};
use crate::place::quote;
use crate::plan::{Counted, Phase, RegionId};

/// Something that is sampled at the begin of a cycle or an evolution.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Sample {
    Edge(EdgeId),
    Delay(DelayId),
    Combinational(VarId),
}

impl Cx<'_> {
    /// The time since the cycle before, added to every time that is counted. The first cycle has none.
    pub(super) fn pass_time(&self) -> TokenStream {
        if !self.plan.memory.time {
            return TokenStream::new();
        }
        let p = &self.p;
        let regions = self.timed_regions().map(|region| {
            let since = names::step_time(region, self.plan);
            quote!(self.#since = self.#since + elapsed_;)
        });
        let macros = self.plan.memory.macro_times.iter().map(|id| {
            let since = names::macro_time(*id);
            quote!(self.#since = self.#since + elapsed_;)
        });
        let phases = self.plan.memory.phases.iter().enumerate().map(|(index, phase)| {
            let (field, period) = (names::phase(index), phase.period);
            quote!(self.#field = #p::phase(self.#field, elapsed_, #p::Ticks::new(#period));)
        });
        let since = quote!(now_.since(self.now));
        let elapsed = if self.counts_in_first() {
            let first = self.first();
            quote!(if #first { #p::Ticks::ZERO } else { #since })
        } else {
            since
        };
        quote! {
            let elapsed_ = #elapsed;
            self.now = now_;
            #(#regions)* #(#macros)* #(#phases)*
        }
    }

    /// Whether something that is not a step counts time, also in the first cycle, which has none. The times of the initial steps
    /// begin in it.
    fn counts_in_first(&self) -> bool {
        let memory = &self.plan.memory;
        let of_macro = |phase: &Phase| matches!(phase.of, Counted::Macro(_));
        !memory.macro_times.is_empty() || !self.model.delays.is_empty() || memory.phases.iter().any(of_macro)
    }

    /// What blinks since the activation of this.
    fn phases_of(&self, of: Counted) -> Vec<Ident> {
        let phases = self.plan.memory.phases.iter().enumerate();
        phases.filter(|(_, phase)| phase.of == of).map(|(index, _)| names::phase(index)).list()
    }

    /// Everything that counts since the activation of a region's active step.
    pub(super) fn counters_of(&self, region: RegionId) -> Vec<Ident> {
        let since = self.plan.memory.step_times[region].then(|| names::step_time(region, self.plan));
        since.into_iter().and(self.phases_of(Counted::Region(region))).list()
    }

    /// Regions of which something is counted since the activation of their active step.
    pub(super) fn counted_regions(&self) -> impl Iterator<Item = RegionId> + '_ {
        (0..self.plan.regions.all().len()).filter(|region| !self.counters_of(*region).is_empty())
    }

    /// Regions whose active step's time is counted.
    pub(super) fn timed_regions(&self) -> impl Iterator<Item = usize> + '_ {
        self.plan.memory.step_times.iter().enumerate().filter(|(_, timed)| **timed).map(|(region, _)| region)
    }

    /// A step that has been entered begins its time; one that stays (A4g) goes on.
    pub(super) fn restart_times(&self) -> TokenStream {
        let p = &self.p;
        let regions = self.counted_regions().filter(|_| !self.plan.shape.begins_on_entry).map(|region| {
            let (changed, again, begin) = (self.is_changed(region), self.or_again(region), self.begin_region(region));
            quote!(if #changed #again { #begin })
        });
        let macros = self.model.macros.ids().filter_map(|id| {
            let timed = self.plan.memory.macro_times.contains(&id).then(|| names::macro_time(id));
            let counters: Vec<_> = timed.into_iter().and(self.phases_of(Counted::Macro(id))).list();
            if counters.is_empty() {
                return None;
            }
            let (was, is) = (self.macro_active(id, Moment::Condition), self.macro_active(id, Moment::Stable));
            Some(quote!(if #is && !#was { #(self.#counters = #p::Ticks::ZERO;)* }))
        });
        quote!(#(#regions)* #(#macros)*)
    }

    /// The type in which the time of a region's active step is counted.
    pub(super) fn time_type(&self, region: RegionId) -> TokenStream {
        let p = &self.p;
        if self.plan.memory.short_times[region] { quote!(#p::ShortTime) } else { quote!(#p::Ticks) }
    }

    /// The time of a region's active step.
    pub(super) fn counted(&self, region: RegionId) -> TokenStream {
        let since = names::step_time(region, self.plan);
        let ticks = self.plan.memory.short_times[region].then(|| quote!(.ticks()));
        quote!(self.#since #ticks)
    }

    /// A step that is entered begins its time. One that is left at once goes on with it in a `grafcet` (A4g), but not in an `sfc`
    /// (A4s).
    pub(super) fn begin_time(&self, step: StepId, transition: &Transition) -> Option<TokenStream> {
        let stays = self.model.is_grafcet() && transition.sources.contains(&step);
        let begins = self.plan.shape.begins_on_entry && self.is_counted(step) && !stays;
        begins.then(|| self.begin_region(self.plan.regions.of_step(step)))
    }

    /// The times of the initial steps begin in the first cycle.
    pub(super) fn begin_initial(&self) -> TokenStream {
        let counted = self.plan.initial.iter().filter(|step| self.is_counted(**step));
        counted.map(|step| self.begin_region(self.plan.regions.of_step(*step))).tokens()
    }

    /// Whether something is counted since the activation of the step.
    fn is_counted(&self, step: StepId) -> bool {
        self.plan.memory.timed.contains(&step) || self.plan.memory.blinking.contains(&step)
    }

    fn begin_region(&self, region: RegionId) -> TokenStream {
        let since = self.plan.memory.step_times[region].then(|| {
            let (since, time) = (names::step_time(region, self.plan), self.time_type(region));
            quote!(self.#since = #time::ZERO;)
        });
        let (phases, p) = (self.phases_of(Counted::Region(region)), &self.p);
        quote!(#since #(self.#phases = #p::Ticks::ZERO;)*)
    }

    /// The time the active steps had reached, for the actions on leaving them (A34).
    pub(super) fn keep_times(&self) -> TokenStream {
        let regions = self.timed_regions().map(|region| {
            let (reached, since) = (names::step_time_before(region, self.plan), self.counted(region));
            quote!(let #reached = #since;)
        });
        let phases = self.plan.memory.phases.iter().enumerate().map(|(index, _)| {
            let (reached, phase) = (names::phase_before(index), names::phase(index));
            quote!(let #reached = self.#phase;)
        });
        quote!(#(#regions)* #(#phases)*)
    }

    /// The general delays of a `grafcet`, sampled once per cycle on the situation it starts from (A36), with the edges
    /// and combinational variables they look at.
    pub(super) fn sample_delays(&self, none: &TokenStream) -> TokenStream {
        let samples = self.samples();
        let declare = samples.iter().filter_map(|sample| match sample {
            Sample::Edge(id) => Some(*id),
            Sample::Delay(_) | Sample::Combinational(_) => None,
        });
        let declare: Vec<_> = declare.filter(|id| self.feeds_a_delay(*id)).list();
        let locals = self.edge_locals(&declare);
        let samples = samples.into_iter().map(|sample| match sample {
            Sample::Delay(id) => self.sample_delay(id),
            Sample::Edge(id) if declare.contains(&id) => self.look_at_edge(id, none),
            Sample::Edge(_) => TokenStream::new(),
            Sample::Combinational(var) => self.combinational(var, Moment::Sample),
        });
        quote!(#locals #(#samples)*)
    }

    /// The delays and edges of an `sfc`, each after those it looks at.
    pub(super) fn sample_all(&self, none: &TokenStream) -> TokenStream {
        let samples = self.samples().into_iter().map(|sample| match sample {
            Sample::Delay(id) => self.sample_delay(id),
            Sample::Edge(id) if self.plan.memory.edges.iter().any(|(early, ..)| *early == id) => {
                self.sample_edge(id, none)
            }
            Sample::Edge(_) | Sample::Combinational(_) => TokenStream::new(),
        });
        samples.tokens()
    }

    /// `sfc`: the edges that compare what two evolutions have led to.
    pub(super) fn sample_late(&self) -> TokenStream {
        let (late, p) = (&self.plan.memory.late_edges, &self.p);
        if late.is_empty() {
            return TokenStream::new();
        }
        let sampled = self.samples().into_iter().filter_map(|sample| {
            let (id, rising, falling) = *late.iter().find(|(id, ..)| sample == Sample::Edge(*id))?;
            let (field, value) = (names::late_edge(id, None), self.value(&self.model.edges[id].of, Moment::Late));
            let none = (rising && falling).then(|| quote!(&&!first_));
            let [up, down] = [true, false].map(|side| names::late_edge(id, Some(side)));
            let up = rising.then(|| quote!(let #up = value_ && !self.#field #none;));
            let down = falling.then(|| quote!(let #down = !value_ && self.#field #none;));
            Some(quote!(let value_: #p::bool = #value; #up #down self.#field = value_;))
        });
        let sampled: TokenStream = sampled.tokens();
        let sides = late.iter().flat(|(id, rising, falling)| [(*id, *rising, true), (*id, *falling, false)]);
        let locals = sides.filter(|(_, used, _)| *used).map(|(id, _, side)| names::late_edge(id, Some(side)));
        let locals: Vec<_> = locals.list();
        let settled = self.unsettle_if(&quote!(#(#locals)||*));
        quote!(#sampled #settled)
    }

    /// The local that holds an edge, to what reads it at a moment.
    pub(super) fn edge(&self, id: EdgeId, rising: bool, moment: Moment) -> Ident {
        let acts = matches!(moment, Moment::Action | Moment::Late | Moment::Leaving);
        let late = acts && self.plan.memory.late_edges.iter().any(|(late, ..)| *late == id);
        if late { names::late_edge(id, Some(rising)) } else { names::edge_local(id, rising) }
    }

    /// The edges of this evolution, or those that are the same in each: `none` says that there are none (A26).
    pub(super) fn sample_edges(&self, still: bool, none: &TokenStream) -> TokenStream {
        let edges = self.plan.memory.edges.iter().filter(|(id, ..)| self.is_still(*id) == still);
        edges.map(|(id, ..)| self.sample_edge(*id, none)).tokens()
    }

    /// Whether an edge is sampled in front of the search. Where the bound may stop its first evolution, the edges of that
    /// have to be seen again.
    fn is_still(&self, id: EdgeId) -> bool {
        !self.plan.may_be_unstable && self.plan.memory.still_edges.contains(&id)
    }

    /// Edges that only the first evolution sees are gone (A2).
    pub(super) fn forget_edges(&self) -> TokenStream {
        let edges: Vec<_> = self.plan.memory.still_edges.iter().copied().filter(|id| self.is_still(*id)).list();
        self.names_of_edges(&edges).into_iter().map(|local| quote!(#local = false;)).tokens()
    }

    /// Whether the evolutions of a search each have edges of their own.
    pub(super) fn samples_in_search(&self) -> bool {
        self.plan.memory.edges.iter().any(|(id, ..)| !self.is_still(*id))
    }

    /// All edges, delays and combinational variables in an order in which each comes after those it reads.
    fn samples(&self) -> Vec<Sample> {
        let mut order = Vec::new();
        let mut waiting: Vec<Sample> = self.model.edges.ids().map(Sample::Edge).list();
        waiting.push_all(self.model.delays.ids().map(Sample::Delay));
        waiting.push_all(self.plan.memory.combinational.iter().copied().map(Sample::Combinational));
        while let Some(next) = waiting.iter().position(|sample| !self.looks_at(*sample, &waiting)) {
            order.push(waiting.remove(next));
        }
        order
    }

    fn looks_at(&self, sample: Sample, others: &[Sample]) -> bool {
        let waits = |read: &Read| match read {
            Read::Rising(id) | Read::Falling(id) => others.contains(&Sample::Edge(*id)),
            Read::Delay(id) => others.contains(&Sample::Delay(*id)),
            Read::Name(Name::Var(id)) => others.contains(&Sample::Combinational(*id)),
            _ => false,
        };
        match sample {
            Sample::Edge(id) => self.model.edges[id].of.reads.iter().any(waits),
            Sample::Delay(id) => self.model.delays[id].of.reads.iter().any(waits),
            Sample::Combinational(id) => {
                let mut conditions = asserted(self.model, id).filter_map(|association| association.condition.as_ref());
                conditions.any(|condition| condition.reads.iter().any(waits))
            }
        }
    }

    /// Whether the expression of a delay looks at the edge, directly or through other edges.
    fn feeds_a_delay(&self, id: EdgeId) -> bool {
        let looks =
            |of: &Expr| of.reads.iter().any(|read| matches!(read, Read::Rising(e) | Read::Falling(e) if *e == id));
        self.model.delays.values().any(|delay| looks(&delay.of))
            || self.model.edges.iter().any(|(outer, edge)| looks(&edge.of) && self.feeds_a_delay(outer))
    }

    fn sample_delay(&self, id: DelayId) -> TokenStream {
        let (p, delay) = (&self.p, &self.model.delays[id]);
        let (field, value) = (names::delay_field(id), self.value(&delay.of, Moment::Sample));
        let (on, off) = (self.time(delay.on), self.time(delay.off));
        quote! {
            let input_ = #value;
            #p::Delay::update(&mut self.#field, input_, #on, #off, elapsed_);
        }
    }

    /// An edge, which is used up by that.
    fn sample_edge(&self, id: EdgeId, none: &TokenStream) -> TokenStream {
        let (look, field) = (self.look_at_edge(id, none), names::edge_field(id));
        quote!(#look self.#field = value_;)
    }

    fn look_at_edge(&self, id: EdgeId, none: &TokenStream) -> TokenStream {
        let p = &self.p;
        let (field, value) = (names::edge_field(id), self.value(&self.model.edges[id].of, Moment::Sample));
        let used = self.plan.memory.edges.iter().find(|(other, ..)| *other == id);
        let none = used.is_some_and(|(_, rising, falling)| *rising && *falling).then(|| quote!(&& !#none));
        let sides = used.into_iter().flat(|(_, rising, falling)| [(*rising, true), (*falling, false)]);
        let sides = sides.filter(|(used, _)| *used).map(|(_, is_rising)| {
            let local = names::edge_local(id, is_rising);
            let edge = if is_rising { quote!(value_ && !self.#field) } else { quote!(!value_ && self.#field) };
            quote!(#local = #edge #none;)
        });
        quote!(let value_: #p::bool = #value; #(#sides)*)
    }

    /// The locals that hold the edges.
    pub(super) fn declare_edges(&self) -> TokenStream {
        self.edge_locals(&self.model.edges.ids().list())
    }

    /// The locals of all edges.
    pub(super) fn edge_names(&self) -> Vec<Ident> {
        self.names_of_edges(&self.model.edges.ids().list())
    }

    fn names_of_edges(&self, wanted: &[EdgeId]) -> Vec<Ident> {
        let edges = self.plan.memory.edges.iter().filter(|(id, ..)| wanted.contains(id));
        let sides = edges.flat(|(id, rising, falling)| [(*id, *rising, true), (*id, *falling, false)]);
        sides.filter(|(_, used, _)| *used).map(|(id, _, is_rising)| names::edge_local(id, is_rising)).list()
    }

    fn edge_locals(&self, wanted: &[EdgeId]) -> TokenStream {
        self.names_of_edges(wanted).into_iter().map(|local| quote!(let mut #local = false;)).tokens()
    }

    /// Keeps what edges compare with, and puts it back: an evolution that does not take place consumes no edge.
    pub(super) fn keep_edges(&self) -> (TokenStream, TokenStream) {
        let kept = self.plan.memory.edges.iter().map(|(id, ..)| (names::edge_field(*id), names::edge_kept(*id)));
        let (mut keep, mut put_back) = (TokenStream::new(), TokenStream::new());
        for (field, local) in kept {
            keep.extend(quote!(let #local = self.#field;));
            put_back.extend(quote!(self.#field = #local;));
        }
        (keep, put_back)
    }

    /// Whether the first cycle is under way.
    pub(super) fn first(&self) -> TokenStream {
        if !self.plan.has_start {
            return quote!(false);
        }
        self.is_starting(At::Now)
    }
}
