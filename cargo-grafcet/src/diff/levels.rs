//! Levels of rules: `#[allow(grafcet::unreachable_step)]` at a step, and the like.

use grafcet_compiler::ast::LevelAttr;
use grafcet_compiler::diagnostic::Severity;
use grafcet_compiler::model::{Id, Model, Name, StepId};
use grafcet_core::description::Description;

use super::words::{Text, step_name};

/// What is said of a rule somewhere.
pub(crate) struct Level {
    /// `step`; `chart` for all of it.
    pub(crate) kind: &'static str,
    /// Nothing for the chart.
    pub(crate) of: Text,
    pub(crate) rule: String,
    /// `allow`
    pub(crate) word: &'static str,
}

impl Level {
    /// The same rule at the same place.
    pub(crate) fn is_of(&self, other: &Self) -> bool {
        (self.kind, &self.of, &self.rule) == (other.kind, &other.of, &other.rule)
    }

    /// `` the step `Off` ``
    pub(crate) fn owner(&self) -> String {
        if self.of.shown.is_empty() { "the chart".to_owned() } else { format!("the {} `{}`", self.kind, self.of.shown) }
    }

    /// `` allow(grafcet::deadlock) ``
    pub(crate) fn attribute(&self) -> String {
        format!("{}(grafcet::{})", self.word, self.rule)
    }
}

/// All of them; properties are what `claims` says of each.
pub(super) fn of(model: &Model, chart: &Description<'_>, claims: &[Text]) -> Vec<Level> {
    let mut all = Vec::new();
    let mut add = |kind, of: Text, levels: &[LevelAttr]| {
        all.extend(levels.iter().map(|level| Level {
            kind,
            of: of.clone(),
            rule: level.rule.to_string(),
            word: match level.severity {
                Severity::Allow => "allow",
                Severity::Warn => "warn",
                Severity::Deny => "deny",
            },
        }));
    };
    let plain = |name: &dyn ToString| Text::of(name.to_string().trim_start_matches("r#"));
    add("chart", Text::of(""), &model.levels);
    for (id, one) in model.inputs.iter() {
        add("input", plain(model.value_name(Name::Input(id))), &one.levels);
    }
    for one in model.outputs.values() {
        add("output", plain(&one.name), &one.levels);
    }
    for one in model.vars.values() {
        add("variable", plain(&one.name), &one.levels);
    }
    for one in model.params.values() {
        add("parameter", plain(&one.name), &one.levels);
    }
    for one in model.lets.values() {
        add("named condition", plain(&one.name), &one.levels);
    }
    for one in model.actions.values() {
        add("code action", plain(&one.name), &one.levels);
    }
    for one in model.partials.values() {
        if let Some(name) = &one.name {
            add("partial grafcet", plain(name), &one.levels);
        }
    }
    for (id, one) in model.steps.iter() {
        add("step", Text::of(&step_name(chart, id.index())), &one.levels);
    }
    for (id, one) in model.transitions.iter() {
        // An `any` is one transition for each step that it leaves.
        if one.any.is_none_or(|any| model.anys[any].first == id) {
            add("transition", ends(chart, &one.sources, &one.targets), &one.levels);
        }
    }
    for (one, claim) in model.properties.iter().zip(claims) {
        add("property", claim.clone(), &one.levels);
    }
    all
}

/// `A → (B, C)`
fn ends(chart: &Description<'_>, from: &[StepId], to: &[StepId]) -> Text {
    let side = |steps: &[StepId]| {
        let names: Vec<String> = steps.iter().map(|step| step_name(chart, step.index())).collect();
        if names.len() == 1 { names.concat() } else { format!("({})", names.join(", ")) }
    };
    // As it is written, so that its names are found.
    let mut text = Text::of(&format!("{} -> {}", side(from), side(to)));
    text.shown = text.shown.replace("->", "→");
    text
}
