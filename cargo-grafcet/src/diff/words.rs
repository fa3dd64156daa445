//! A chart in words, which can be compared.

use grafcet_compiler::describe::with_description;
use grafcet_compiler::model::{Expr, Model, Name, Ty};
use grafcet_core::description::{self, Description, Dialect};
use proc_macro2::{TokenStream, TokenTree};

use super::levels::{self, Level};
use crate::find::Found;

/// What somebody has written. Blanks and comments do not count, and a name that has changed counts as the new one.
#[derive(Clone, Debug)]
pub(crate) struct Text {
    /// As it stands in the source.
    pub(crate) shown: String,
    tokens: Vec<String>,
}

impl PartialEq for Text {
    fn eq(&self, other: &Self) -> bool {
        self.tokens == other.tokens
    }
}

impl Text {
    pub(crate) fn of(shown: &str) -> Self {
        let mut tokens = Vec::new();
        match shown.parse::<TokenStream>() {
            Ok(stream) => flatten(stream, &mut tokens),
            Err(_) => tokens.extend(shown.split_whitespace().map(str::to_owned)),
        }
        Self { shown: shown.to_owned(), tokens }
    }

    pub(super) fn rename(&mut self, old: &str, new: &str) {
        self.tokens.iter_mut().filter(|token| *token == old).for_each(|token| new.clone_into(token));
    }
}

fn flatten(stream: TokenStream, tokens: &mut Vec<String>) {
    for tree in stream {
        match tree {
            TokenTree::Group(group) => {
                tokens.push(format!("{:?}", group.delimiter()));
                flatten(group.stream(), tokens);
                tokens.push("end".to_owned());
            }
            other => tokens.push(other.to_string().trim_start_matches("r#").to_owned()),
        }
    }
}

/// A chart in words.
pub(crate) struct Words {
    pub(crate) name: String,
    pub(crate) is_grafcet: bool,
    /// What holds for the chart as a whole: `sfc`, the unit of its clock, and so on.
    pub(crate) whole: Vec<(&'static str, String)>,
    pub(crate) declared: Vec<Declared>,
    /// What it assumes and claims, each with its kind.
    pub(crate) said: Vec<(&'static str, Text)>,
    pub(crate) steps: Vec<Step>,
    pub(crate) transitions: Vec<Transition>,
    pub(crate) levels: Vec<Level>,
}

/// `input on: bool;`
pub(crate) struct Declared {
    /// `input`
    pub(crate) kind: &'static str,
    pub(crate) name: String,
    /// `u8 = 0`
    pub(crate) text: Text,
}

pub(crate) struct Step {
    pub(crate) name: String,
    /// `initial`, `within 10s`
    pub(crate) traits: Vec<Text>,
    /// `N relay if hot`
    pub(crate) actions: Vec<Text>,
}

pub(crate) struct Transition {
    /// Often empty.
    pub(crate) name: String,
    pub(crate) from: Vec<String>,
    /// What an `any` leaves out; none where it is no `any`.
    pub(crate) any: Option<Vec<String>>,
    pub(crate) to: Vec<String>,
    pub(crate) condition: Text,
    pub(crate) clearing: Vec<Text>,
}

impl Transition {
    /// `` `A → (B, C)` ``
    pub(crate) fn label(&self) -> String {
        let side = |steps: &[String]| match steps {
            [one] => one.clone(),
            steps => format!("({})", steps.join(", ")),
        };
        let from = match self.any.as_deref() {
            Some([]) => "any".to_owned(),
            Some(except) => format!("any except {}", side(except)),
            None => side(&self.from),
        };
        let name = if self.name.is_empty() { String::new() } else { format!("{}: ", self.name) };
        format!("`{name}{from} → {}`", side(&self.to))
    }
}

impl Words {
    pub(crate) fn of(model: &Model, found: &Found) -> Self {
        let source = |mark: grafcet_compiler::diagnostic::Mark| {
            let bytes = mark.start.byte_range().start..mark.end.byte_range().end;
            let words: Vec<&str> = found.source.text.get(bytes).unwrap_or_default().split_whitespace().collect();
            Text::of(&words.join(" "))
        };
        let claims: Vec<Text> = model.properties.iter().map(|property| source(property.mark)).collect();
        let assumed = model.assumptions.iter().filter(|one| one.of_range.is_none());
        let mut said: Vec<(&str, Text)> = assumed.map(|one| ("assumption", source(one.mark))).collect();
        said.extend(model.often.iter().map(|one| ("assumption", Text::of(&format!("assume often {}", one.text)))));
        said.extend(model.orders.iter().map(|one| ("assumption", source(one.mark))));
        said.extend(claims.iter().map(|claim| ("property", claim.clone())));
        with_description(model, |chart| Self {
            name: chart.name.to_owned(),
            is_grafcet: chart.dialect == Dialect::Grafcet,
            whole: whole(model),
            declared: declared(model, chart),
            said,
            steps: model.steps.values().enumerate().map(|(number, of)| step(chart, number, of.is_final)).collect(),
            transitions: chart.transitions.iter().map(|one| transition(chart, one)).collect(),
            levels: levels::of(model, chart, &claims),
        })
    }

    /// What is said by each line of the chart, in tokens; the first one says what kind of line it is.
    pub(crate) fn facts(&self) -> Vec<Vec<&str>> {
        let mut all: Vec<Vec<&str>> = Vec::new();
        for one in &self.declared {
            all.push([one.kind, one.name.as_str()].into_iter().chain(strs(&one.text)).collect());
        }
        for (kind, text) in &self.said {
            all.push([*kind].into_iter().chain(strs(text)).collect());
        }
        for step in &self.steps {
            all.push(["step", step.name.as_str()].into_iter().chain(step.traits.iter().flat_map(strs)).collect());
            for action in &step.actions {
                all.push([ACTION, step.name.as_str()].into_iter().chain(strs(action)).collect());
            }
        }
        for one in &self.transitions {
            let any = one.any.iter().flat_map(|except| ["any"].into_iter().chain(except.iter().map(String::as_str)));
            let ends = one.from.iter().map(String::as_str).chain(["→"]).chain(one.to.iter().map(String::as_str));
            let texts = [&one.condition].into_iter().chain(&one.clearing).flat_map(strs);
            all.push([TRANSITION].into_iter().chain(any).chain(ends).chain(texts).collect());
        }
        all
    }

    /// Whether it has what a level is about; what has no name of its own it may have.
    pub(crate) fn has(&self, level: &Level) -> bool {
        let is = |name: &str| level.of == Text::of(name);
        match level.kind {
            "transition" | "property" => true,
            "step" => self.steps.iter().any(|step| is(&step.name)),
            kind => self.declared.iter().any(|one| one.kind == kind && is(&one.name)),
        }
    }

    /// All names of steps and of what is declared.
    pub(crate) fn names(&self) -> Vec<&str> {
        let steps = self.steps.iter().map(|step| step.name.as_str());
        steps.chain(self.declared.iter().map(|one| one.name.as_str())).collect()
    }

    /// Everywhere another name.
    pub(crate) fn rename(&mut self, old: &str, new: &str) {
        let name = |name: &mut String| {
            if name == old {
                new.clone_into(name);
            }
        };
        for one in &mut self.declared {
            name(&mut one.name);
            one.text.rename(old, new);
        }
        self.said.iter_mut().for_each(|(_, text)| text.rename(old, new));
        self.levels.iter_mut().for_each(|level| level.of.rename(old, new));
        for step in &mut self.steps {
            name(&mut step.name);
            step.traits.iter_mut().chain(&mut step.actions).for_each(|text| text.rename(old, new));
        }
        for one in &mut self.transitions {
            one.from.iter_mut().chain(&mut one.to).chain(one.any.iter_mut().flatten()).for_each(name);
            one.clearing.iter_mut().chain([&mut one.condition]).for_each(|text| text.rename(old, new));
        }
    }
}

/// The first word of a fact about an action, and of one about a transition.
pub(crate) const ACTION: &str = "action of a step";
pub(crate) const TRANSITION: &str = "transition";

fn strs(text: &Text) -> impl Iterator<Item = &str> {
    text.tokens.iter().map(String::as_str)
}

fn whole(model: &Model) -> Vec<(&'static str, String)> {
    let dialect = if model.is_grafcet() { "grafcet" } else { "sfc" };
    let yes = |is: bool| if is { "yes" } else { "no" }.to_owned();
    let or_none = |value: Option<String>| value.unwrap_or_else(|| "none".to_owned());
    vec![
        ("dialect", dialect.to_owned()),
        ("unit of the clock", format!("{} ns", model.clock_nanos)),
        ("max_evolutions", or_none(model.max_evolutions.map(|most| most.to_string()))),
        ("encoding flags", yes(model.flags)),
        ("forceable", yes(model.forceable)),
        ("modes", yes(model.modes.is_some())),
        ("longest cycle", or_none(model.longest_cycle.map(|ticks| model.time_text(ticks.into())))),
    ]
}

fn type_of(ty: &Ty) -> String {
    match ty {
        Ty::Bool(rust) | Ty::Int { rust, .. } | Ty::Other(rust) => quote::quote!(#rust).to_string(),
        Ty::Time(_) => "time".to_owned(),
    }
}

fn declared(model: &Model, chart: &Description<'_>) -> Vec<Declared> {
    let value = |kind, name: Name, init: Option<&Expr>, range: Option<&str>| {
        let mut text = type_of(model.ty(name));
        if let Some(listed) = model.variants_of(name) {
            let variants: Vec<String> = listed.list.iter().map(|variant| variant.name.to_string()).collect();
            text = format!("{text} in {{{}}}", variants.join(", "));
        }
        text += &range.map(|range| format!(" in {range}")).unwrap_or_default();
        text += &init.map(|init| format!(" = {}", init.text)).unwrap_or_default();
        Declared { kind, name: model.value_name(name).to_string(), text: Text::of(&text) }
    };
    let mut all: Vec<Declared> = model.inputs.ids().map(|id| value("input", Name::Input(id), None, None)).collect();
    all.extend(model.outputs.iter().map(|(id, one)| value("output", Name::Output(id), one.init.as_ref(), None)));
    all.extend(model.vars.iter().map(|(id, one)| value("variable", Name::Var(id), one.init.as_ref(), None)));
    all.extend(model.params.iter().map(|(id, one)| {
        value("parameter", Name::Param(id), one.init.as_ref(), one.range.as_ref().map(|range| range.text.as_str()))
    }));
    let other = |kind, name: &str, text: String| Declared { kind, name: name.to_owned(), text: Text::of(&text) };
    all.extend(chart.lets.iter().map(|one| other("named condition", one.name, one.text.to_owned())));
    all.extend(model.actions.values().map(|action| {
        let params: Vec<String> = action.params.iter().map(|(name, ty)| format!("{name}: {}", type_of(ty))).collect();
        other("code action", &action.name.to_string(), format!("({})", params.join(", ")))
    }));
    let named = chart.partials.iter().filter(|partial| !partial.name.is_empty());
    all.extend(named.map(|partial| {
        let outer = partial.enclosed_by.map_or("", |step| chart.steps[step].name);
        other(
            "partial grafcet",
            partial.name,
            if outer.is_empty() { String::new() } else { format!("enclosed by {outer}") },
        )
    }));
    all.extend(chart.macros.iter().map(|one| {
        let text = format!("from {} to {}", chart.steps[one.entry].name, chart.steps[one.exit].name);
        other("macro-step", one.name, text)
    }));
    all
}

fn step(chart: &Description<'_>, number: usize, is_final: bool) -> Step {
    let (name, step) = (step_name(chart, number), &chart.steps[number]);
    let mut traits = Vec::new();
    for (is, text) in [(step.initial, "initial"), (is_final, "final"), (step.linked, "with the activation link")] {
        traits.extend(is.then(|| Text::of(text)));
    }
    let partial = chart.partials[step.partial].name;
    if !partial.is_empty() {
        traits.push(Text::of(&format!("in {partial}")));
    }
    if let Some(expansion) = step.expansion {
        traits.push(Text::of(&format!("in the expansion of {}", chart.macros[expansion].name)));
    }
    if !step.within.is_empty() {
        traits.push(Text::of(&format!("within {}", step.within)));
    }
    let action = |action: &description::Action<'_>| {
        let parts = [action.qualifier, action.time, action.text];
        let mut text = parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(" ");
        if !action.condition.is_empty() {
            text = format!("{text} if {}", action.condition);
        }
        Text::of(&text)
    };
    let forces = step.forces.iter().map(|force| Text::of(&format!("force {force}")));
    Step { name, traits, actions: step.actions.iter().map(action).chain(forces).collect() }
}

fn transition(chart: &Description<'_>, one: &description::Transition<'_>) -> Transition {
    let names = |steps: &[usize]| steps.iter().map(|step| step_name(chart, *step)).collect();
    Transition {
        name: one.name.to_owned(),
        from: names(one.sources),
        any: one.any.as_ref().map(|any| any.except.iter().map(|name| (*name).to_owned()).collect()),
        to: names(one.targets),
        condition: Text::of(one.condition),
        clearing: one.clearing.iter().map(|text| Text::of(text)).collect(),
    }
}

/// With its partial grafcet where another step has the same name.
pub(crate) fn step_name(chart: &Description<'_>, number: usize) -> String {
    let step = &chart.steps[number];
    match chart.steps.iter().filter(|other| other.name == step.name).count() {
        1 => step.name.to_owned(),
        _ => format!("{}::{}", chart.partials[step.partial].name, step.name),
    }
}
