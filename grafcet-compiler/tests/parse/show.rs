//! The syntax tree as a line of text, so that a test can say what it expects.

use grafcet_compiler::ast::{
    ActionDecl, Arrow, Association, Attrs, Body, Chain, Chart, Clearing, Condition, Decl, Force, ForceOrder, Item,
    Node, Partial, Property, Setting, Step, StepBody, StepKind, Target, Time, TimeArg, Transition, Ty,
};
use quote::ToTokens;

fn tokens(tokens: &impl ToTokens) -> String {
    tokens.to_token_stream().to_string()
}

fn list<T>(items: impl IntoIterator<Item = T>, show: impl Fn(T) -> String) -> String {
    items.into_iter().map(show).collect::<Vec<_>>().join(", ")
}

fn joined<T>(items: impl IntoIterator<Item = T>, show: impl Fn(T) -> String) -> String {
    items.into_iter().map(show).collect::<Vec<_>>().concat()
}

fn lines<T>(items: impl IntoIterator<Item = T>, show: impl Fn(T) -> String) -> String {
    items.into_iter().map(show).collect::<Vec<_>>().join("; ")
}

pub(crate) fn chart(chart: &Chart) -> String {
    let vis = tokens(&chart.vis);
    format!("{}{vis} {:?} {} {{{}}}", attrs(&chart.attrs), chart.dialect, chart.name, body(&chart.body))
        .trim_start()
        .to_owned()
}

pub(crate) fn body(body: &Body) -> String {
    let levels = joined(&body.levels, |level| format!("#![{:?} {}] ", level.severity, level.rule));
    levels + &lines(&body.items, item)
}

fn attrs(attrs: &Attrs) -> String {
    let passed = attrs.passed_on.iter().map(|attr| tokens(attr) + " ").collect::<String>();
    let levels = joined(&attrs.levels, |level| format!("[{:?} {}] ", level.severity, level.rule));
    passed + &levels
}

fn item(item: &Item) -> String {
    match item {
        Item::Decl(it) => decl(it),
        Item::Action(it) => action(it),
        Item::Setting(it) => setting(it),
        Item::Property(it) => property(it),
        Item::Step(it) => step(it),
        Item::Chain(it) => chain(it),
        Item::Partial(it) => partial(it),
        Item::Let(it) => format!("LET {} {}", it.name, tokens(&it.value)),
    }
}

fn ty(ty: &Ty) -> String {
    match ty {
        Ty::Time(_) => "TIME".to_owned(),
        Ty::Rust(ty) => tokens(ty),
    }
}

fn decl(decl: &Decl) -> String {
    let init = decl.init.as_ref().map(|init| format!(" = {}", tokens(init))).unwrap_or_default();
    format!("{}{:?} {}: {}{init}", attrs(&decl.attrs), decl.kind, list(&decl.names, ToString::to_string), ty(&decl.ty))
}

fn action(action: &ActionDecl) -> String {
    let params = list(&action.params, |(name, it)| format!("{name}: {}", ty(it)));
    format!("{}action {}({params})", attrs(&action.attrs), action.name)
}

fn time(time: &Time) -> String {
    format!("{}ns", time.nanos)
}

fn setting(setting: &Setting) -> String {
    match setting {
        Setting::Clock { unit, .. } => format!("clock {}", time(unit)),
        Setting::MaxEvolutions { count, .. } => format!("max_evolutions {count}"),
        Setting::Budget { count, .. } => format!("budget {count}"),
        Setting::OptimizeSize { .. } => "optimize size".to_owned(),
        Setting::Forceable { .. } => "forceable".to_owned(),
        Setting::Modes { .. } => "modes".to_owned(),
        Setting::EncodingFlags { .. } => "encoding flags".to_owned(),
        Setting::AssumePure { paths, .. } => format!("assume pure {}", list(paths, tokens)),
        Setting::AssumeCycle { longest, .. } => format!("assume cycle within {}", time(longest)),
        Setting::AssumeOften { condition, .. } => format!("assume often {}", tokens(condition)),
        Setting::AssumeOrder { order, .. } => format!("assume {}", property(order)),
        Setting::AssumeNever { condition, .. } => format!("assume never {}", tokens(condition)),
    }
}

fn property(property: &Property) -> String {
    match property {
        Property::Never { condition, attrs: it, .. } => format!("{}never {}", attrs(it), tokens(condition)),
        Property::Always { premise, condition, .. } => {
            let premise = premise.as_ref().map(|it| format!("{} => ", tokens(it))).unwrap_or_default();
            format!("always {premise}{}", tokens(condition))
        }
        Property::Home { steps, .. } => format!("home ({})", list(steps, ToString::to_string)),
        Property::LeadsTo { from, to, within, .. } => {
            let within = within.as_ref().map(|within| format!(" within {}", time(within))).unwrap_or_default();
            format!("{} leads_to {}{within}", tokens(from), tokens(to))
        }
        Property::Before { first, then, .. } => format!("{} before {}", tokens(first), tokens(then)),
    }
}

fn step(step: &Step) -> String {
    let words = [
        ("initial ", step.initial),
        ("final ", step.is_final),
        ("linked ", step.linked),
        ("entry ", step.entry),
        ("exit ", step.exit),
    ];
    let words = words.iter().filter(|(_, at)| at.is_some()).map(|(word, _)| *word).collect::<String>();
    let (kind, inside) = match &step.kind {
        StepKind::Plain(body) => ("", step_body(body)),
        StepKind::Macro(_, inside) => ("macro ", body(inside)),
        StepKind::Enclosing(_, body, partials) => {
            let mut parts = vec![step_body(body)];
            parts.extend(partials.iter().map(partial));
            parts.retain(|part| !part.is_empty());
            ("enclosing ", parts.join("; "))
        }
    };
    let within = match step.within.as_ref().map(|within| &within.time) {
        Some(Some(TimeArg::Literal(it))) => format!(" within {}", time(it)),
        Some(Some(TimeArg::Name(name))) => format!(" within <{name}>"),
        Some(None) | None => String::new(),
    };
    format!("{}{words}{kind}step {}{within} {{{inside}}}", attrs(&step.attrs), step.name)
}

fn step_body(body: &StepBody) -> String {
    let mut all = body.associations.iter().map(association).collect::<Vec<_>>();
    all.extend(body.forces.iter().map(force));
    all.join("; ")
}

fn association(association: &Association) -> String {
    let qualifier = association.qualifier.map(|(qualifier, _)| format!("{qualifier:?} ")).unwrap_or_default();
    let time = match &association.time {
        Some(TimeArg::Literal(it)) => time(it) + " ",
        Some(TimeArg::Name(name)) => format!("<{name}> "),
        None => String::new(),
    };
    let event = association.event.as_ref().map(|event| format!("<{}> ", tokens(event))).unwrap_or_default();
    let condition = association.condition.as_ref().map(|it| format!(" if {}", tokens(it))).unwrap_or_default();
    format!("{qualifier}{time}{event}{}{condition}", target(&association.target))
}

fn target(target: &Target) -> String {
    match target {
        Target::Name(name) => name.to_string(),
        Target::Assign { name, value } => format!("{name} := {}", tokens(value)),
        Target::Call { name, args } => format!("{name}({})", list(args, tokens)),
        Target::Block(block) => tokens(block),
    }
}

fn force(force: &Force) -> String {
    let order = match &force.order {
        ForceOrder::Steps(steps) => list(steps, ToString::to_string),
        ForceOrder::Hold => "HOLD".to_owned(),
        ForceOrder::Empty => "EMPTY".to_owned(),
        ForceOrder::Init => "INITIAL".to_owned(),
    };
    format!("force {} <{order}>", force.partial)
}

fn partial(partial: &Partial) -> String {
    format!("{}partial {} {{{}}}", attrs(&partial.attrs), partial.name, body(&partial.body))
}

fn chain(chain: &Chain) -> String {
    let rest = joined(&chain.rest, |(it, next)| format!(" {} {}", arrow(it), node(next)));
    format!("{}{}{rest}", attrs(&chain.attrs), node(&chain.first))
}

fn node(node: &Node) -> String {
    match node {
        Node::Step(name) => name.to_string(),
        Node::Group(names, _) => format!("({})", list(names, ToString::to_string)),
        Node::Any(any) => match any.except.as_slice() {
            [] => "any".to_owned(),
            some => format!("any except ({})", list(some, ToString::to_string)),
        },
        Node::Missing(_) => "MISSING".to_owned(),
        Node::Forgotten(_) => "FORGOTTEN".to_owned(),
    }
}

fn arrow(arrow: &Arrow) -> String {
    match arrow {
        Arrow::Bare(_) => "BARE".to_owned(),
        Arrow::Transition(Transition { name, condition, clearing, .. }) => {
            let name = name.as_ref().map(|name| format!("{name}: ")).unwrap_or_default();
            let clearing = match clearing.as_slice() {
                [] => String::new(),
                some => format!(" => {}", list(some, |Clearing { target: it, .. }| target(it))),
            };
            let condition = match condition {
                Condition::Holds(expr) => tokens(expr),
                Condition::Else(_) => "ELSE".to_owned(),
                Condition::Broken => "BROKEN".to_owned(),
            };
            format!("-[{name}{condition}{clearing}]->")
        }
    }
}
