//! A model as data that can be drawn: the same description that a program finds in `Motor::CHART`.

use grafcet_core::description::{self, Description};

use crate::list::List;
use crate::model::{Dialect, Effect, ForceOrder, Id, Model, PartialId, StepId, TimeRef, Transition};
use crate::raw::plain;

/// Calls `f` with the description of a chart.
pub fn with_description<R>(model: &Model, f: impl FnOnce(&Description<'_>) -> R) -> R {
    let texts = Texts::of(model);
    let actions: Vec<Vec<_>> = texts.steps.iter().map(StepTexts::actions).list();
    let forces: Vec<Vec<&str>> = texts.steps.iter().map(|step| strs(&step.forces)).list();
    let steps = model.steps.values().zip(&texts.steps).zip(actions.iter().zip(&forces));
    let steps: Vec<_> = steps
        .map(|((step, texts), (actions, forces))| description::Step {
            name: &texts.name,
            initial: step.initial,
            linked: step.linked,
            partial: step.partial.index(),
            expansion: step.macro_step.map(Id::index),
            actions,
            within: &texts.within,
            forces,
        })
        .list();
    let ends: Vec<Ends> = model.drawn_transitions().map(|(_, t)| Ends::of(model, t)).list();
    let lists: Vec<[Vec<&str>; 2]> = texts.transitions.iter().map(|t| [strs(&t.clearing), strs(&t.except)]).list();
    let transitions = texts.transitions.iter().zip(ends.iter().zip(&lists));
    let transitions: Vec<_> = transitions
        .map(|(texts, (ends, [clearing, except]))| description::Transition {
            name: &texts.name,
            sources: &ends.sources,
            any: ends.any.as_ref().map(|steps| description::Any { steps, except }),
            targets: &ends.targets,
            condition: &texts.condition,
            clearing,
        })
        .list();
    let partials = model.partials.values().zip(&texts.partials);
    let partials: Vec<_> = partials
        .map(|(partial, name)| description::Partial {
            name,
            enclosed_by: partial.enclosed_by.map(Id::index),
            doc: &partial.doc,
        })
        .list();
    let macros = model.macros.values().zip(&texts.macros);
    let macros: Vec<_> = macros
        .map(|(m, name)| description::MacroStep {
            name,
            outer: m.outer.map(Id::index),
            entry: m.entry.index(),
            exit: m.exit.index(),
            doc: &m.doc,
        })
        .list();
    let lets = model.lets.values().zip(&texts.lets);
    let lets: Vec<_> = lets.map(|(named, name)| description::Let { name, text: &named.text, doc: &named.doc }).list();
    let dialect = match model.dialect {
        Dialect::Sfc => description::Dialect::Sfc,
        Dialect::Grafcet => description::Dialect::Grafcet,
    };
    f(&Description {
        name: &texts.name,
        dialect,
        partials: &partials,
        macros: &macros,
        steps: &steps,
        transitions: &transitions,
        lets: &lets,
    })
}

/// The steps at both ends of a transition, by their numbers.
struct Ends {
    sources: Vec<usize>,
    /// What an `any` leaves, to which it has no lines.
    any: Option<Vec<usize>>,
    targets: Vec<usize>,
}

impl Ends {
    fn of(model: &Model, transition: &Transition) -> Self {
        let any = transition.any.map(|any| numbers(&model.anys[any].sources));
        let sources = if any.is_some() { Vec::new() } else { numbers(&transition.sources) };
        Self { sources, any, targets: numbers(&transition.targets) }
    }
}

/// The texts that the description borrows.
struct Texts {
    name: String,
    partials: Vec<String>,
    macros: Vec<String>,
    steps: Vec<StepTexts>,
    transitions: Vec<TransitionTexts>,
    lets: Vec<String>,
}

struct TransitionTexts {
    name: String,
    condition: String,
    clearing: Vec<String>,
    /// What an `any` leaves out.
    except: Vec<String>,
}

struct StepTexts {
    name: String,
    within: String,
    actions: Vec<ActionTexts>,
    forces: Vec<String>,
}

struct ActionTexts {
    qualifier: &'static str,
    time: String,
    condition: String,
    text: String,
}

impl StepTexts {
    fn actions(&self) -> Vec<description::Action<'_>> {
        self.actions
            .iter()
            .map(|texts| description::Action {
                qualifier: texts.qualifier,
                time: &texts.time,
                condition: &texts.condition,
                text: &texts.text,
            })
            .list()
    }
}

impl Texts {
    fn of(model: &Model) -> Self {
        let transition = |t: &Transition| TransitionTexts {
            name: t.name.as_ref().map(plain).unwrap_or_default(),
            condition: t.condition.text.clone(),
            clearing: t.clearing.iter().map(|done| effect(model, done)).list(),
            except: t.any.map_or_else(Vec::new, |any| model.anys[any].except.iter().map(plain).list()),
        };
        Self {
            name: plain(&model.name),
            partials: model.partials.values().map(|p| p.name.as_ref().map(plain).unwrap_or_default()).list(),
            macros: model.macros.values().map(|m| plain(&m.name)).list(),
            steps: model.steps.ids().map(|step| step_texts(model, step)).list(),
            transitions: model.drawn_transitions().map(|(_, t)| transition(t)).list(),
            lets: model.lets.values().map(|named| plain(&named.name)).list(),
        }
    }
}

fn step_texts(model: &Model, id: StepId) -> StepTexts {
    let step = &model.steps[id];
    let actions = step.associations.iter().map(|id| {
        let association = &model.associations[*id];
        let condition = association.condition.as_ref().or(association.event.as_ref());
        ActionTexts {
            qualifier: association.qualifier.word(),
            time: association.time.map(|at| time(model, at)).unwrap_or_default(),
            condition: condition.map(|condition| condition.text.clone()).unwrap_or_default(),
            text: effect(model, &association.effect),
        }
    });
    let forces = step.forces.iter().map(|id| {
        let force = &model.forces[*id];
        format!("{} {{{}}}", partial(model, force.target), order(model, &force.order))
    });
    let within = step.within().map(|at| time(model, at)).unwrap_or_default();
    StepTexts { name: plain(&step.name), within, actions: actions.list(), forces: forces.list() }
}

/// `relay`, `count = count + 1`, `heat(80)`, `count += 1;`
fn effect(model: &Model, effect: &Effect) -> String {
    match effect {
        Effect::Control(place) => plain(model.place_name(*place)),
        Effect::Assign(place, value) => format!("{} = {}", plain(model.place_name(*place)), value.text),
        Effect::Call(action, arguments) => {
            let arguments: Vec<&str> = arguments.iter().map(|argument| argument.text.as_str()).list();
            format!("{}({})", plain(&model.actions[*action].name), arguments.join(", "))
        }
        Effect::Block(code) => code.text.clone(),
    }
}

fn time(model: &Model, time: TimeRef) -> String {
    match time {
        TimeRef::Ticks(ticks) => model.time_text(i128::from(ticks)),
        TimeRef::Param(id) => plain(&model.params[id].name),
        TimeRef::Var(id) => plain(&model.vars[id].name),
    }
}

fn partial(model: &Model, id: PartialId) -> String {
    model.partials[id].name.as_ref().map_or_else(|| plain(&model.name), plain)
}

fn order(model: &Model, order: &ForceOrder) -> String {
    match order {
        ForceOrder::Steps(steps) => {
            let names: Vec<String> = steps.iter().map(|step| plain(&model.steps[*step].name)).list();
            names.join(", ")
        }
        ForceOrder::Hold => "*".to_owned(),
        ForceOrder::Init => "INIT".to_owned(),
    }
}

fn numbers(steps: &[StepId]) -> Vec<usize> {
    steps.iter().map(|step| step.index()).list()
}

fn strs(texts: &[String]) -> Vec<&str> {
    texts.iter().map(String::as_str).list()
}
