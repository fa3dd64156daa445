//! What the notation has and the compiler does not compile yet: an error that says so, at its tokens.

use crate::analysis::Concurrency;
use crate::ast::{self, Item, Property, Setting, StepKind};
use crate::diagnostic::{Mark, Sink};
use crate::model::{Effect, Model, Place, Qualifier, Read};
use crate::plan::Regions;

/// Reports everything in the chart that cannot be compiled yet.
pub fn not_yet(chart: &ast::Chart, model: &Model, sink: &mut Sink) {
    body(&chart.body, sink);
    declarations(model, sink);
    associations(model, sink);
    conditions(model, sink);
    if !sink.has_errors() {
        parallel(model, sink);
    }
}

fn report(mark: impl Into<Mark>, what: &str, sink: &mut Sink) {
    sink.notation(mark, format!("{what} cannot be compiled yet"));
}

fn body(body: &ast::Body, sink: &mut Sink) {
    for item in &body.items {
        match item {
            Item::Setting(Setting::Budget { keyword, .. }) => report(*keyword, "`budget`", sink),
            Item::Setting(Setting::AssumeNever { keyword, .. }) => report(*keyword, "`assume`", sink),
            Item::Property(
                Property::Never { keyword, .. } | Property::Always { keyword, .. } | Property::Home { keyword, .. },
            ) => report(*keyword, "a property", sink),
            Item::Partial(partial) => report(&partial.name, "a partial grafcet", sink),
            Item::Step(step) => match &step.kind {
                StepKind::Plain(body) => body.forces.iter().for_each(|f| report(f.mark, "a forcing order", sink)),
                StepKind::Macro(keyword, _) => report(*keyword, "a macro-step", sink),
                StepKind::Enclosing(keyword, ..) => report(*keyword, "an enclosing step", sink),
            },
            _ => {}
        }
    }
}

fn declarations(model: &Model, sink: &mut Sink) {
    model.vars.values().for_each(|var| report(&var.name, "a variable", sink));
    model.params.values().for_each(|param| report(&param.name, "a param", sink));
    model.actions.values().for_each(|action| report(&action.name, "a code action", sink));
}

fn associations(model: &Model, sink: &mut Sink) {
    for association in model.associations.values() {
        let mark = association.mark;
        match (association.qualifier, &association.effect) {
            (Qualifier::N | Qualifier::S | Qualifier::R | Qualifier::P, Effect::Control(Place::Output(_))) => {}
            (Qualifier::N | Qualifier::P1 | Qualifier::P0, Effect::Assign(Place::Output(_), _)) => {}
            (_, Effect::Block(_)) => report(mark, "a block", sink),
            _ => report(mark, "this action", sink),
        }
    }
    for transition in model.transitions.values().filter(|t| !t.clearing.is_empty()) {
        report(transition.mark, "an action on clearing", sink);
    }
}

fn conditions(model: &Model, sink: &mut Sink) {
    for transition in model.transitions.values() {
        let later = |read: &Read| !matches!(read, Read::Name(_) | Read::Active(_));
        if transition.condition.reads.iter().any(later) {
            report(transition.mark, "a condition on time or on an edge", sink);
        }
    }
}

fn parallel(model: &Model, sink: &mut Sink) {
    let regions = Regions::of(model, &Concurrency::of(model));
    if !regions.is_single() {
        let message = "more than one step can be active here (parallel branches, or branches of a `grafcet` \
                       that do not exclude each other), which cannot be compiled yet";
        sink.notation(&model.name, message);
    }
}
