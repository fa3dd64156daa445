//! `next_deadline`: until when nothing happens, unless an input changes.

use proc_macro2::{Ident, TokenStream};

use super::machine::{Deadline, Machine};
use super::situation::At;
use super::{Cx, names};
use crate::list::List;
use crate::model::{
    Binary, Blink, Blinker, Effect, Expr, MacroId, Name, Place, Qualifier, Read, StepId, TimeRef, Tree,
};
use crate::place::quote;
use crate::sorted::Set;

/// At which times of a step something changes.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Threshold {
    /// At the time itself.
    At(TimeRef),
    /// One tick after it.
    Behind(TimeRef),
    /// At the ends of both parts of a period.
    Blinks(Blink),
    /// At every tick: the time is used in another way than in a comparison.
    Always,
}

/// Whose time is meant.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Clock {
    Step(StepId),
    Macro(MacroId),
}

/// The method, where the chart uses time.
pub(super) fn method(cx: &Cx<'_>, machine: &Machine<'_>) -> Option<TokenStream> {
    let (vis, p) = (&cx.model.vis, &cx.p);
    let Deadline { at_once, waits, reading, from } = machine.deadline.as_ref()?;
    let soonest = match from {
        None => quote!(soonest_),
        Some(from) => quote! {
            match soonest_ {
                #p::Option::Some(time_) => #p::Option::Some(#from.after(time_)),
                #p::Option::None => #p::Option::None,
            }
        },
    };
    Some(quote! {
        /// The reading of the clock before which nothing changes unless an input does (or the recipe): a controller
        /// that sleeps until then behaves like one that scans all the time. The reading of the last cycle means
        /// "scan again at once"; `None` means "only an input can change anything".
        #[must_use]
        #vis fn next_deadline(&self) -> #p::Option<#p::Ticks> {
            if #at_once {
                return #p::Option::Some(#reading);
            }
            let mut soonest_ = #p::Option::None;
            #waits
            #soonest
        }
    })
}

impl Cx<'_> {
    /// As long as nothing contradicts, the cycle leaves nothing to the next one.
    pub(super) fn assume_settled(&self) -> Option<TokenStream> {
        self.plan.flags_left_over.then(|| quote!(self.settled = true;))
    }

    /// The cycle leaves something to the next one.
    pub(super) fn unsettle(&self) -> Option<TokenStream> {
        self.plan.flags_left_over.then(|| quote!(self.settled = false;))
    }

    /// The same, if something changes.
    pub(super) fn unsettle_if(&self, change: &TokenStream) -> Option<TokenStream> {
        self.unsettle().map(|unsettle| quote!(if #change { #unsettle }))
    }

    /// What is remembered of that, its type and what it begins with.
    pub(super) fn left_over_field(&self) -> Option<(Ident, TokenStream, TokenStream)> {
        let p = &self.p;
        self.plan.flags_left_over.then(|| (names::own("settled"), quote!(#p::bool), quote!(false)))
    }

    /// Whether the last cycle has left something to the next one, or there was none.
    fn is_left_over(&self) -> TokenStream {
        if self.plan.flags_left_over { quote!(!self.settled) } else { self.first() }
    }

    /// Until when nothing changes, where the chart uses time.
    pub(super) fn deadline(&self) -> Option<Deadline> {
        if !self.plan.memory.time {
            return None;
        }
        let p = &self.p;
        let thresholds = self.thresholds();
        let steps = thresholds.iter().map(|(clock, threshold)| self.until(*clock, *threshold));
        let delays = self.model.delays.iter().map(|(id, delay)| {
            let (field, on, off) = (names::delay_field(id), self.time(delay.on), self.time(delay.off));
            quote!(soonest_ = #p::sooner(soonest_, #p::Delay::remaining(&self.#field, #on, #off));)
        });
        let timers = self.timers();
        let left_over = self.is_left_over();
        let unknown = self.restless().into_iter().map(|steps| {
            let active = steps.iter().map(|step| self.in_step(At::Now, *step));
            let active: Vec<_> = active.list();
            if active.is_empty() { quote!(true) } else { quote!(#(#active)&&*) }
        });
        let at_once = quote!(#left_over #(|| #unknown)*);
        Some(Deadline {
            at_once,
            waits: quote!(#(#steps)* #(#delays)* #timers),
            reading: quote!(self.now),
            from: Some(quote!(self.now)),
        })
    }

    /// `if active { soonest = sooner(soonest, until(since, 5s)); }`
    fn until(&self, clock: Clock, threshold: Threshold) -> TokenStream {
        let p = &self.p;
        let (active, since) = match clock {
            Clock::Step(step) => (self.in_step(At::Now, step), self.counted(self.plan.regions.of_step(step))),
            Clock::Macro(id) => {
                let active = self.model.macros[id].steps.iter().map(|step| self.in_step(At::Now, *step));
                let (active, since) = (active.list(), names::macro_time(id));
                (quote!(#(#active)||*), quote!(self.#since))
            }
        };
        let tick = quote!(#p::Ticks::new(1));
        let remaining = match threshold {
            Threshold::At(time) => {
                let time = self.time(time);
                quote!(#p::until(#since, #time))
            }
            Threshold::Behind(time) => {
                let time = self.time(time);
                quote!(#p::until(#since, #time + #tick))
            }
            Threshold::Blinks(blink) => {
                let (phase, _) = self.phases_of_blink(blink);
                let (on, period) = (blink.on, blink.period());
                quote!(#p::Option::Some(#p::until_change(self.#phase, #p::Ticks::new(#on), #p::Ticks::new(#period))))
            }
            Threshold::Always => quote!(#p::Option::Some(#tick)),
        };
        quote!(if #active { soonest_ = #p::sooner(soonest_, #remaining); })
    }

    /// The timers of the action control.
    fn timers(&self) -> TokenStream {
        let p = &self.p;
        let mut tokens = TokenStream::new();
        for (index, target) in self.plan.control.targets.iter().enumerate() {
            for qualifier in Qualifier::ALL.into_iter().filter(|qualifier| qualifier.has_time()) {
                if target.has(self.model, qualifier) {
                    let prefix = format!("timer_{}", names::flag(qualifier));
                    let timer = names::target(&prefix, self.model, index, target);
                    let time = self.target_time(index, target, qualifier);
                    tokens
                        .extend(quote!(soonest_ = #p::sooner(soonest_, #p::OnDelay::remaining(&self.#timer, #time));));
                }
            }
        }
        tokens
    }

    /// The steps, each time all of them together, with which each cycle asks for a call that may have another value each time.
    fn restless(&self) -> Set<Vec<StepId>> {
        let model = self.model;
        let mut found = Set::new();
        for transition in model.transitions.values().filter(|transition| transition.condition.tree.may_differ()) {
            found.insert(transition.sources.clone());
        }
        for association in model.associations.values() {
            let value = match &association.effect {
                Effect::Assign(Place::Output(_), value) if association.qualifier == Qualifier::N => Some(value),
                _ => None,
            };
            let mut asked = association.condition.iter().and(&association.event).and(value);
            if asked.any(|expr| expr.tree.may_differ()) {
                found.insert(vec![association.step]);
            }
        }
        // Edges and delays are sampled in every cycle.
        let mut sampled = model.edges.values().map(|edge| &edge.of).and(model.delays.values().map(|delay| &delay.of));
        if sampled.any(|of| of.tree.may_differ()) {
            found.insert(Vec::new());
        }
        found
    }

    /// Every time of a step that an expression looks at.
    fn thresholds(&self) -> Set<(Clock, Threshold)> {
        let mut found = Set::new();
        for transition in self.model.transitions.values() {
            collect(&transition.condition.tree, &mut found);
            transition.clearing.iter().for_each(|effect| of_effect(effect, &mut found));
        }
        for (id, association) in self.model.associations.iter() {
            association.condition.iter().and(&association.event).for_each(|expr| collect(&expr.tree, &mut found));
            of_effect(&association.effect, &mut found);
            if let Some(time) = self.plan.control.step_limit(self.model, id) {
                found.insert((Clock::Step(association.step), Threshold::At(time)));
            }
        }
        self.model.steps.values().filter_map(|step| step.late).for_each(|late| always(late, &mut found));
        self.model.edges.values().for_each(|edge| collect(&edge.of.tree, &mut found));
        self.model.delays.values().for_each(|delay| collect(&delay.of.tree, &mut found));
        found
    }
}

fn of_effect(effect: &Effect, found: &mut Set<(Clock, Threshold)>) {
    let of_expr = |expr: &Expr, found: &mut Set<_>| collect(&expr.tree, found);
    match effect {
        Effect::Control(_) => {}
        Effect::Assign(_, value) => of_expr(value, found),
        Effect::Call(_, args) => args.iter().for_each(|arg| of_expr(arg, found)),
        Effect::Block(code) => code.reads.iter().for_each(|read| always(*read, found)),
    }
}

fn collect(tree: &Tree, found: &mut Set<(Clock, Threshold)>) {
    match tree {
        Tree::Elapsed(time, step) => {
            found.insert((Clock::Step(*step), Threshold::At(*time)));
        }
        Tree::MacroElapsed(time, id) => {
            found.insert((Clock::Macro(*id), Threshold::At(*time)));
        }
        Tree::Binary(operator, a, b) => {
            match comparison(*operator, a, b).or_else(|| comparison(operator.mirrored(), b, a)) {
                Some((clock, thresholds)) => found.extend(thresholds.into_iter().map(|threshold| (clock, threshold))),
                None => {
                    collect(a, found);
                    collect(b, found);
                }
            }
        }
        Tree::Unary(_, inner) => collect(inner, found),
        Tree::Read(read) => always(*read, found),
        Tree::Opaque { reads, .. } => reads.iter().for_each(|read| always(*read, found)),
        Tree::Bool(_) | Tree::Int(_) => {}
    }
}

fn always(read: Read, found: &mut Set<(Clock, Threshold)>) {
    let entry = match read {
        Read::Since(step) => (Clock::Step(step), Threshold::Always),
        Read::MacroSince(id) => (Clock::Macro(id), Threshold::Always),
        Read::Elapsed(time, step) => (Clock::Step(step), Threshold::At(time)),
        Read::MacroElapsed(time, id) => (Clock::Macro(id), Threshold::At(time)),
        Read::Blink(blink) => match blink.of {
            Blinker::Step(step) => (Clock::Step(step), Threshold::Blinks(blink)),
            Blinker::Macro(id) => (Clock::Macro(id), Threshold::Blinks(blink)),
        },
        _ => return,
    };
    found.insert(entry);
}

/// `Step.T < 5s`: when its truth can change.
fn comparison(operator: Binary, a: &Tree, b: &Tree) -> Option<(Clock, Vec<Threshold>)> {
    let clock = match a {
        Tree::Read(Read::Since(step)) => Clock::Step(*step),
        Tree::Read(Read::MacroSince(id)) => Clock::Macro(*id),
        _ => return None,
    };
    let time = match b {
        Tree::Read(Read::Ticks(ticks)) => TimeRef::Ticks(*ticks),
        Tree::Read(Read::Name(Name::Param(id))) => TimeRef::Param(*id),
        Tree::Read(Read::Name(Name::Var(id))) => TimeRef::Var(*id),
        _ => return None,
    };
    let thresholds = match operator {
        Binary::Lt | Binary::Ge => vec![Threshold::At(time)],
        Binary::Gt | Binary::Le => vec![Threshold::Behind(time)],
        Binary::Eq | Binary::Ne => vec![Threshold::At(time), Threshold::Behind(time)],
        _ => return None,
    };
    Some((clock, thresholds))
}
