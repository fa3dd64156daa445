//! What has changed, as a person would say it.

use super::levels::Level;
use super::words::{Step, Text, Transition, Words};

/// One change.
#[derive(PartialEq, Debug)]
pub(crate) struct Change {
    /// `renamed`, `step`, `transition`, `condition`, `action`, `priority`, …
    pub(crate) kind: &'static str,
    pub(crate) sentence: String,
    pub(crate) old: Option<String>,
    pub(crate) new: Option<String>,
    /// The steps of the new version that it is about.
    pub(crate) steps: Vec<String>,
}

/// What `new` has otherwise than `old`, in which what has another name has the new one already.
pub(crate) fn changes(old: &Words, new: &Words) -> Vec<Change> {
    let mut all = Changes(Vec::new());
    if old.name != new.name {
        all.add(
            "chart",
            format!("the chart is called `{}` instead of `{}`", new.name, old.name),
            Some(&old.name),
            Some(&new.name),
        );
    }
    for ((what, before), (_, after)) in old.whole.iter().zip(&new.whole) {
        if before != after {
            all.add("chart", format!("{what}: {after} instead of {before}"), Some(before), Some(after));
        }
    }
    all.declared(old, new);
    all.steps(old, new);
    let pairs = pairs(&old.transitions, &new.transitions);
    all.transitions(old, new, &pairs);
    if !new.is_grafcet {
        all.priorities(old, new, &pairs);
    }
    all.said(old, new);
    all.levels(old, new);
    all.0
}

struct Changes(Vec<Change>);

impl Changes {
    fn add(&mut self, kind: &'static str, sentence: String, old: Option<&str>, new: Option<&str>) -> &mut Change {
        self.0.push(Change {
            kind,
            sentence,
            old: old.map(str::to_owned),
            new: new.map(str::to_owned),
            steps: Vec::new(),
        });
        let last = self.0.len() - 1;
        &mut self.0[last]
    }

    fn declared(&mut self, old: &Words, new: &Words) {
        let shown = |text: &Text| if text.shown.is_empty() { String::new() } else { format!(": `{}`", text.shown) };
        for one in &old.declared {
            match new.declared.iter().find(|other| other.name == one.name && other.kind == one.kind) {
                None => {
                    let sentence = format!("the {} `{}` is gone", one.kind, one.name);
                    self.add(one.kind, sentence, Some(&one.text.shown), None);
                }
                Some(other) if other.text == one.text => {}
                Some(other) => {
                    let (before, after) = (&one.text.shown, &other.text.shown);
                    let sentence = format!("the {} `{}` is `{after}` instead of `{before}`", one.kind, one.name);
                    self.add(one.kind, sentence, Some(before), Some(after));
                }
            }
        }
        for one in &new.declared {
            if old.declared.iter().all(|other| other.name != one.name || other.kind != one.kind) {
                let sentence = format!("there is a new {} `{}`{}", one.kind, one.name, shown(&one.text));
                self.add(one.kind, sentence, None, Some(&one.text.shown));
            }
        }
        for (kind, many) in
            [("input", "inputs"), ("output", "outputs"), ("variable", "variables"), ("parameter", "parameters")]
        {
            let of = |words: &Words| -> Vec<String> {
                words.declared.iter().filter(|one| one.kind == kind).map(|one| one.name.clone()).collect()
            };
            self.order(many, &of(old), &of(new));
        }
    }

    /// The order of those that are in both.
    fn order(&mut self, what: &str, old: &[String], new: &[String]) {
        let both = |these: &[String], those: &[String]| -> String {
            let both: Vec<&str> = these.iter().filter(|name| those.contains(name)).map(String::as_str).collect();
            both.join(", ")
        };
        let (before, after) = (both(old, new), both(new, old));
        if before != after {
            self.add(
                "order",
                format!("the order of the {what} is {after} instead of {before}"),
                Some(&before),
                Some(&after),
            );
        }
    }

    fn steps(&mut self, old: &Words, new: &Words) {
        for step in &old.steps {
            if let Some(other) = new.steps.iter().find(|other| other.name == step.name) {
                self.step(step, other);
            } else {
                self.add("step", format!("the step `{}` is gone", step.name), Some(&step.name), None);
            }
        }
        for step in new.steps.iter().filter(|step| old.steps.iter().all(|other| other.name != step.name)) {
            let traits: Vec<&str> = step.traits.iter().map(|text| text.shown.as_str()).collect();
            let traits = if traits.is_empty() { String::new() } else { format!(" ({})", traits.join(", ")) };
            let actions: Vec<String> = step.actions.iter().map(|text| format!("`{}`", text.shown)).collect();
            let actions = if actions.is_empty() { String::new() } else { format!(" with {}", actions.join(", ")) };
            let sentence = format!("there is a new step `{}`{traits}{actions}", step.name);
            self.add("step", sentence, None, Some(&step.name)).steps.push(step.name.clone());
        }
        let names = |words: &Words| words.steps.iter().map(|step| step.name.clone()).collect::<Vec<_>>();
        self.order("steps", &names(old), &names(new));
    }

    fn step(&mut self, old: &Step, new: &Step) {
        let first = self.0.len();
        let name = &new.name;
        let (gone, fresh) = (missing(&old.traits, &new.traits), missing(&new.traits, &old.traits));
        for text in gone {
            self.add("step", format!("the step `{name}` is no longer {}", text.shown), Some(&text.shown), None);
        }
        for text in fresh {
            self.add("step", format!("the step `{name}` is now {}", text.shown), None, Some(&text.shown));
        }
        let (gone, fresh) = (missing(&old.actions, &new.actions), missing(&new.actions, &old.actions));
        if let ([before], [after]) = (&gone[..], &fresh[..]) {
            let sentence = format!("the step `{name}` does `{}` instead of `{}`", after.shown, before.shown);
            self.add("action", sentence, Some(&before.shown), Some(&after.shown));
        } else {
            for text in &gone {
                self.add(
                    "action",
                    format!("the step `{name}` no longer does `{}`", text.shown),
                    Some(&text.shown),
                    None,
                );
            }
            for text in &fresh {
                self.add("action", format!("the step `{name}` also does `{}`", text.shown), None, Some(&text.shown));
            }
        }
        if gone.is_empty() && fresh.is_empty() && old.actions != new.actions {
            let list = |step: &Step| step.actions.iter().map(|text| text.shown.as_str()).collect::<Vec<_>>().join("; ");
            let sentence = format!("the order of the actions of `{name}` is {} instead of {}", list(new), list(old));
            self.add("order", sentence, Some(&list(old)), Some(&list(new)));
        }
        self.0[first..].iter_mut().for_each(|change| change.steps.push(name.clone()));
    }

    fn transitions(&mut self, old: &Words, new: &Words, pairs: &[(usize, usize)]) {
        for (place, one) in old.transitions.iter().enumerate() {
            match pairs.iter().find(|(before, _)| *before == place) {
                Some((_, after)) => self.transition(one, &new.transitions[*after]),
                None => {
                    let text = format!("{} on `{}`", one.label(), one.condition.shown);
                    self.add("transition", format!("the transition {text} is gone"), Some(&text), None);
                }
            }
        }
        for (place, one) in new.transitions.iter().enumerate() {
            if pairs.iter().all(|(_, after)| *after != place) {
                let text = format!("{} on `{}`", one.label(), one.condition.shown);
                let lower = new.transitions[place + 1..].iter().find(|other| share(one, other) && !new.is_grafcet);
                let before = lower.map(|other| format!(", with priority over {}", other.label())).unwrap_or_default();
                let sentence = format!("there is a new transition {text}{before}");
                self.add("transition", sentence, None, Some(&text)).steps.clone_from(&one.from);
            }
        }
    }

    fn transition(&mut self, old: &Transition, new: &Transition) {
        let first = self.0.len();
        let (before, after) = (old.label(), new.label());
        if !ends(old, new) || old.name != new.name {
            let sentence = format!("the transition {before} on `{}` is now {after}", new.condition.shown);
            self.add("transition", sentence, Some(&before), Some(&after));
        }
        if old.condition != new.condition {
            let (was, is) = (&old.condition.shown, &new.condition.shown);
            self.add("condition", format!("{after} clears on `{is}` instead of `{was}`"), Some(was), Some(is));
        }
        for text in missing(&old.clearing, &new.clearing) {
            self.add(
                "action",
                format!("{after} no longer does `{}` as it clears", text.shown),
                Some(&text.shown),
                None,
            );
        }
        for text in missing(&new.clearing, &old.clearing) {
            self.add("action", format!("{after} does `{}` as it clears", text.shown), None, Some(&text.shown));
        }
        self.0[first..].iter_mut().for_each(|change| change.steps.clone_from(&new.from));
    }

    /// Of transitions that leave a step, the first one in the source goes before the others.
    fn priorities(&mut self, old: &Words, new: &Words, pairs: &[(usize, usize)]) {
        for (a, b) in pairs.iter().flat_map(|a| pairs.iter().map(move |b| (a, b))) {
            let (first, second) = (&new.transitions[a.1], &new.transitions[b.1]);
            let shared = share(first, second) && share(&old.transitions[a.0], &old.transitions[b.0]);
            if shared && a.1 < b.1 && a.0 > b.0 {
                let label = |one: &Transition| format!("{} on `{}`", one.label(), one.condition.shown);
                let (is, was) = (label(first), label(second));
                let sentence = format!("{is} now has priority over {was}");
                self.add("priority", sentence, Some(&was), Some(&is)).steps.clone_from(&first.from);
            }
        }
    }

    fn said(&mut self, old: &Words, new: &Words) {
        for (kind, text) in old.said.iter().filter(|one| !new.said.contains(one)) {
            self.add(kind, format!("the {kind} `{}` is gone", text.shown), Some(&text.shown), None);
        }
        for (kind, text) in new.said.iter().filter(|one| !old.said.contains(one)) {
            self.add(kind, format!("there is a new {kind} `{}`", text.shown), None, Some(&text.shown));
        }
    }
}

impl Changes {
    /// Of what is in both versions.
    fn levels(&mut self, old: &Words, new: &Words) {
        for level in &old.levels {
            let is_left = level.of.shown.is_empty() || new.has(level);
            let Some(other) = new.levels.iter().find(|other| other.is_of(level)) else {
                if is_left {
                    let (owner, attribute) = (level.owner(), level.attribute());
                    self.level(level, format!("{owner} no longer has `{attribute}`"), Some(&attribute), None);
                }
                continue;
            };
            if other.word != level.word {
                let (before, after) = (level.attribute(), other.attribute());
                let sentence = format!("{} has `{after}` instead of `{before}`", other.owner());
                self.level(other, sentence, Some(&before), Some(&after));
            }
        }
        for level in new.levels.iter().filter(|level| old.levels.iter().all(|other| !other.is_of(level))) {
            let (owner, attribute) = (level.owner(), level.attribute());
            self.level(level, format!("{owner} now has `{attribute}`"), None, Some(&attribute));
        }
    }

    fn level(&mut self, level: &Level, sentence: String, old: Option<&str>, new: Option<&str>) {
        let change = self.add("level", sentence, old, new);
        if level.kind == "step" {
            change.steps.push(level.of.shown.clone());
        }
    }
}

/// What is in the one and not in the other, as often as it is.
pub(super) fn missing<'t>(these: &'t [Text], others: &[Text]) -> Vec<&'t Text> {
    let mut left: Vec<&Text> = others.iter().collect();
    let mut missing = Vec::new();
    for text in these {
        match left.iter().position(|other| *other == text) {
            Some(place) => _ = left.remove(place),
            None => missing.push(text),
        }
    }
    missing
}

/// Whether both leave one step.
pub(super) fn share(a: &Transition, b: &Transition) -> bool {
    let any = a.any.is_some() || b.any.is_some();
    any || a.from.iter().any(|step| b.from.contains(step))
}

/// Which transition of the old version is which of the new one: first those of which nothing has changed, in the end those of which little is the same.
pub(super) fn pairs(old: &[Transition], new: &[Transition]) -> Vec<(usize, usize)> {
    const ALIKE: [fn(&Transition, &Transition) -> bool; 6] = [
        |a, b| ends(a, b) && a.condition == b.condition && a.clearing == b.clearing && a.name == b.name,
        |a, b| ends(a, b) && a.condition == b.condition,
        |a, b| !a.name.is_empty() && a.name == b.name,
        ends,
        |a, b| begin(a, b) && a.condition == b.condition,
        |a, b| same(&a.to, &b.to) && a.condition == b.condition,
    ];
    let mut pairs: Vec<(usize, usize)> = Vec::new();
    // Those that belong to none yet.
    let (mut left, mut free): (Vec<usize>, Vec<usize>) = ((0..old.len()).collect(), (0..new.len()).collect());
    for alike in ALIKE {
        left.retain(|before| match free.iter().position(|after| alike(&old[*before], &new[*after])) {
            Some(place) => {
                pairs.push((*before, free.remove(place)));
                false
            }
            None => true,
        });
    }
    pairs.sort_unstable();
    pairs
}

pub(super) fn ends(a: &Transition, b: &Transition) -> bool {
    begin(a, b) && same(&a.to, &b.to)
}

fn begin(a: &Transition, b: &Transition) -> bool {
    same(&a.from, &b.from) && a.any == b.any
}

/// In any order.
fn same(a: &[String], b: &[String]) -> bool {
    a.len() == b.len() && a.iter().all(|step| b.contains(step))
}
