//! The names of a chart: what is declared, what is meant, what was nearly meant.

use proc_macro2::Ident;

use super::modes;
use crate::ast::Body;
use crate::diagnostic::{Mark, Sink, rules};
use crate::list::{List, PushAll};
use crate::model::{ActionId, LetId, MacroId, Name, PartialId, StepId};
use crate::raw::plain;
use crate::similar;
use crate::sorted::{Map, Set};

/// What a name in an expression or after a qualifier means.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Meaning {
    Value(Name),
    Let(LetId),
    Action(ActionId),
    Step(StepId),
    Macro(MacroId),
}

impl Meaning {
    /// What it is, in a sentence.
    pub(super) fn kind(self) -> &'static str {
        match self {
            Self::Value(Name::Input(_)) => "an input",
            Self::Value(Name::Output(_)) => "an output",
            Self::Value(Name::Var(_)) => "a variable",
            Self::Value(Name::Param(_)) => "a param",
            Self::Let(_) => "a named condition",
            Self::Action(_) => "an action",
            Self::Step(_) => "a step",
            Self::Macro(_) => "a macro-step",
        }
    }
}

/// The declared names. Steps and values share one name space: `Off.X` must mean one thing.
#[derive(Default)]
pub(super) struct Scope {
    /// Of several with one name, which is an error, the first counts; as a step the first step.
    names: Map<String, Vec<(Meaning, Ident)>>,
    partials: Map<String, (PartialId, Ident)>,
    transitions: Map<String, Ident>,
    /// What `modes;` declares, with its keyword.
    modes: Vec<Ident>,
    /// Names that a broken item would have declared: no error about them, its own error says enough.
    broken: Vec<Ident>,
    /// How many steps lack their name, and names that can be theirs: no error about these either.
    nameless_steps: usize,
    theirs: Set<String>,
    /// The plants of the call, at which the chart cannot look.
    plants: Vec<String>,
    /// The declarations that names lack, at all their places what the first of them asks for.
    wishes: Map<String, Wish>,
}

/// How a name that is not declared should be.
struct Wish {
    declaration: String,
    /// An action writes it.
    written: bool,
}

/// Qualifiers and words of the notation that would make it ambiguous.
const NOTATION: &[&str] = &["N", "S", "R", "L", "D", "P", "P1", "P0", "SD", "DS", "SL", "INIT", "rising", "falling"];

/// What Rust gives no name, not even as `r#…`.
const NEVER_A_NAME: &[&str] = &["self", "Self", "super", "crate", "_"];

/// The other keywords of Rust, those reserved for the future included.
const KEYWORDS: &[&str] = &[
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "do", "dyn", "else", "enum",
    "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro", "match", "mod", "move",
    "mut", "override", "priv", "pub", "ref", "return", "static", "struct", "trait", "true", "try", "type", "typeof",
    "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

impl Scope {
    /// The scope of a chart in whose call these plants stand.
    pub(super) fn beside(plants: &[String]) -> Self {
        Self { plants: plants.to_vec(), ..Self::default() }
    }

    /// Takes note of the names of items that could not be parsed.
    pub(super) fn add_broken(&mut self, body: &Body) {
        self.broken.push_all(body.broken.iter().cloned());
        self.nameless_steps += body.nameless_steps;
    }

    /// Names in chains that no step has belong to the steps without a name, where there are enough of these.
    pub(super) fn name_the_nameless(&mut self, drawn: &Set<String>) {
        let unknown = |name: &&String| {
            let name = name.trim_start_matches("r#");
            self.names.get(name).is_none() && !self.broken.iter().any(|broken| plain(broken) == name)
        };
        let unknown: Set<String> =
            drawn.iter().filter(unknown).map(|name| name.trim_start_matches("r#").to_owned()).collect();
        if unknown.len() <= self.nameless_steps {
            self.theirs = unknown;
        }
    }

    /// Declares `name`; `false` if it is taken. A reserved one is reported and declared all the same, so that its uses
    /// are no further errors.
    pub(super) fn declare(&mut self, name: &Ident, meaning: Meaning, sink: &mut Sink) -> bool {
        if name == "any" && matches!(meaning, Meaning::Step(_) | Meaning::Macro(_)) {
            let message = "`any` in front of a transition stands for all steps, `any -[x]-> A;`; choose another name for this one";
            sink.rule(&rules::RESERVED_NAME, &[], vec![(name.into(), message.to_owned())]);
        }
        let same = self.names.or_default(plain(name));
        match same.first() {
            Some((_, first)) if self.modes.contains(first) => modes::taken(name, first.span(), sink),
            Some((_, first)) => report_duplicate(name, first, sink),
            None => refuse_reserved(name, sink),
        }
        same.push((meaning, name.clone()));
        same.len() == 1
    }

    /// Declares an input of `modes;`, whose keyword is where the name stands; the other declaration of a name is reported.
    pub(super) fn declare_of_modes(&mut self, name: &Ident, meaning: Meaning, sink: &mut Sink) {
        self.modes.push(name.clone());
        let same = self.names.or_default(plain(name));
        if let Some((_, first)) = same.first() {
            modes::taken(first, name.span(), sink);
        }
        same.push((meaning, name.clone()));
    }

    /// Declares a partial grafcet.
    pub(super) fn declare_partial(&mut self, name: &Ident, id: PartialId, sink: &mut Sink) {
        match self.partials.get(&plain(name)) {
            Some((_, first)) => report_duplicate(name, first, sink),
            None => {
                refuse_reserved(name, sink);
                self.partials.insert(plain(name), (id, name.clone()));
            }
        }
    }

    /// Declares a named transition.
    pub(super) fn declare_transition(&mut self, name: &Ident, sink: &mut Sink) {
        match self.transitions.get(&plain(name)) {
            Some(first) => report_duplicate(name, first, sink),
            None => {
                refuse_reserved(name, sink);
                self.transitions.insert(plain(name), name.clone());
            }
        }
    }

    /// What `name` means, if it is declared.
    pub(super) fn get(&self, name: &Ident) -> Option<Meaning> {
        self.names.get(&plain(name))?.first().map(|(meaning, _)| *meaning)
    }

    /// Everything of that name: more than one thing is an error by itself.
    pub(super) fn all(&self, name: &Ident) -> impl Iterator<Item = Meaning> + '_ {
        self.names.get(&plain(name)).into_iter().flatten().map(|(meaning, _)| *meaning)
    }

    /// Whether a partial grafcet is called so.
    pub(super) fn has_partial(&self, name: &Ident) -> bool {
        self.partials.contains_key(&plain(name))
    }

    /// The partial grafcet `name`; an unknown one is reported.
    pub(super) fn partial(&self, name: &Ident, sink: &mut Sink) -> Option<PartialId> {
        if let Some((id, _)) = self.partials.get(&plain(name)) {
            return Some(*id);
        }
        if self.plants.contains(&name.to_string()) {
            let message = format!(
                "a chart sees the plant `{name}` by its inputs alone; properties and assumptions may speak of its steps, and what \
                 the chart shall know is an output of the plant and an input of the chart"
            );
            sink.notation(name, message);
        } else if !self.is_broken(name) {
            let hint = nearest(name, &self.partials.values().map(|(_, declared)| declared).list())
                .unwrap_or_else(|| declaration(name, &format!("partial {name} {{ … }}")));
            sink.rule(
                &rules::UNKNOWN_PARTIAL,
                &[],
                vec![(name.into(), format!("no partial grafcet is called `{name}`; {hint}"))],
            );
        }
        None
    }

    /// The step or macro-step `name`; anything else is reported.
    pub(super) fn step(&self, name: &Ident, sink: &mut Sink) -> Option<Meaning> {
        let Some(same) = self.names.get(&plain(name)) else {
            self.unknown_step(name, sink);
            return None;
        };
        let mut meanings = same.iter().map(|(meaning, _)| *meaning);
        let step = meanings.clone().find(|meaning| matches!(meaning, Meaning::Step(_) | Meaning::Macro(_)));
        if let (None, Some(other)) = (step, meanings.next()) {
            let message =
                format!("`{name}` is {}, not a step; name a step, or declare one under another name", other.kind());
            sink.rule(&rules::UNKNOWN_STEP, &[], vec![(name.into(), message)]);
        }
        step
    }

    /// Reports a step that is not declared.
    pub(super) fn unknown_step(&self, name: &Ident, sink: &mut Sink) {
        if self.is_broken(name) {
            return;
        }
        if name == "any" {
            let message = "`any` stands for all steps of its net, and only at the begin of a chain, `any -[x]-> A;`; name a step here";
            sink.rule(&rules::UNKNOWN_STEP, &[], vec![(name.into(), message.to_owned())]);
            return;
        }
        let hint = self.suggest(name, |m| matches!(m, Meaning::Step(_) | Meaning::Macro(_)));
        let hint = hint.unwrap_or_else(|| declaration(name, &format!("step {name};")));
        let message = format!("no step is called `{name}`; {hint}");
        sink.rule(&rules::UNKNOWN_STEP, &[], vec![(name.into(), message)]);
    }

    /// Takes note of the declaration that a name lacks which an action writes.
    pub(super) fn wish(&mut self, name: &Ident, wanted: &str) {
        self.wishes.or_insert_with(plain(name), || Wish { declaration: wanted.to_owned(), written: true });
    }

    /// Reports a name in an expression or after a qualifier that is not declared.
    pub(super) fn unknown_name(&mut self, name: &Ident, wanted: &str, sink: &mut Sink) {
        if self.is_broken(name) {
            return;
        }
        let unwritten = || Wish { declaration: wanted.to_owned(), written: false };
        let Wish { declaration: wanted, written } = self.wishes.or_insert_with(plain(name), unwritten);
        let (wanted, written) = (wanted.clone(), *written);
        // What stands for it has to be something that an action may write.
        let fits: fn(Meaning) -> bool = if written {
            |m| matches!(m, Meaning::Value(Name::Output(_) | Name::Var(_)))
        } else {
            |m| matches!(m, Meaning::Value(_) | Meaning::Let(_) | Meaning::Action(_))
        };
        let hint = self.suggest(name, fits).unwrap_or_else(|| declaration(name, &wanted));
        let message = format!("no name `{name}` is declared; {hint}");
        sink.rule(&rules::UNKNOWN_NAME, &[], vec![(name.into(), message)]);
    }

    /// The names of all steps and macro-steps.
    pub(super) fn steps(&self) -> impl Iterator<Item = &Ident> {
        let steps = |(meaning, _): &&(Meaning, Ident)| matches!(meaning, Meaning::Step(_) | Meaning::Macro(_));
        self.names.values().flatten().filter(steps).map(|(_, name)| name)
    }

    /// Whether the name is declared more than once, which has been reported.
    pub(super) fn is_twice(&self, name: &Ident) -> bool {
        self.names.get(&plain(name)).is_some_and(|same| same.len() > 1)
    }

    /// Whether a broken item would have declared the name.
    pub(super) fn is_broken(&self, name: &Ident) -> bool {
        self.broken.iter().any(|b| name == b) || self.theirs.contains(&plain(name))
    }

    /// Whether a name that may be one of the surrounding Rust is rather a slip of the pen: `Endlage_vron`.
    pub(super) fn is_misspelt(&self, name: &Ident) -> bool {
        let text = plain(name);
        let is_upper = |c: char| c.is_uppercase();
        let own = |meaning: Meaning| matches!(meaning, Meaning::Value(_) | Meaning::Let(_));
        text.starts_with(is_upper) && text.contains(char::is_lowercase) && {
            let declared = self.names.values().flatten().filter(|(meaning, _)| own(*meaning)).map(|(_, name)| name);
            let alike = declared.filter(|name| plain(name).starts_with(is_upper));
            alike.into_iter().any(|declared| similar::distance(&text, &plain(declared)) <= text.chars().count() / 6)
        }
    }

    /// Reports a name alone, where a step may stand, that is nearly one; a constant of the surrounding Rust is not written so.
    pub(super) fn is_misspelt_step(&self, name: &Ident, sink: &mut Sink) -> bool {
        let text = plain(name);
        let is_camel = text.starts_with(char::is_uppercase) && text.contains(char::is_lowercase);
        if !is_camel || self.names.get(&text).is_some() || self.is_broken(name) {
            return false;
        }
        let steps = self.steps().list();
        // Of a short name one letter too many is a third or more of it.
        let one_off = || {
            let longer = |step: &&&Ident| text.starts_with(&plain(step)) && similar::distance(&text, &plain(step)) == 1;
            let near = steps.iter().find(longer).filter(|_| !text.ends_with(char::is_numeric));
            near.map(|step| format!("did you mean `{step}`?"))
        };
        let Some(hint) = nearest(name, &steps).or_else(one_off) else { return false };
        sink.rule(&rules::UNKNOWN_STEP, &[], vec![(name.into(), format!("no step is called `{name}`; {hint}"))]);
        true
    }

    fn suggest(&self, name: &Ident, fits: fn(Meaning) -> bool) -> Option<String> {
        let declared =
            self.names.values().flatten().filter(|(meaning, _)| fits(*meaning)).map(|(_, declared)| declared);
        nearest(name, &declared.list())
    }
}

/// "did you mean `Off`?", where something is near enough.
fn nearest(name: &Ident, candidates: &[&Ident]) -> Option<String> {
    similar::nearest(name, candidates).map(|candidate| format!("did you mean `{candidate}`?"))
}

/// Reports a name that the notation or Rust needs.
pub(super) fn refuse_reserved(name: &Ident, sink: &mut Sink) {
    if let Some(reason) = reserved(name) {
        sink.rule(&rules::RESERVED_NAME, &[], vec![(name.into(), format!("`{name}` {reason}"))]);
    }
}

/// Why nothing can be called so.
fn reserved(name: &Ident) -> Option<String> {
    let is_in = |words: &[&str]| words.iter().any(|word| name == word);
    if is_in(NOTATION) {
        Some("is a word of the notation and cannot be a name; choose another one".to_owned())
    } else if is_in(NEVER_A_NAME) {
        Some("cannot be a name in Rust; choose another one".to_owned())
    } else if is_in(KEYWORDS) {
        Some(format!("is a keyword of Rust and cannot be a name; choose another one, or write `r#{name}` everywhere"))
    } else {
        None
    }
}

/// What to do about a name that is not declared.
fn declaration(name: &Ident, wanted: &str) -> String {
    match reserved(name) {
        _ if name == "rising" || name == "falling" => format!("an edge is written `{name}(a)`"),
        _ if name == "self" => "the names of a chart stand alone, without `self.`".to_owned(),
        Some(reason) => format!("it {reason}"),
        None if name == "all" && wanted.starts_with("step") => {
            format!("all steps are `any`: `any -[x]-> A;`; or declare it: `{wanted}`")
        }
        None if ["otherwise", "default", "sonst"].iter().any(|word| name == word) => {
            format!("the last branch of a step has `-[else]->`; if a signal is called so, declare it: `{wanted}`")
        }
        None => format!("declare it: `{wanted}`"),
    }
}

/// `name`, as generated code can spell it also where it was reported as reserved.
pub(super) fn spelled(name: &Ident) -> Ident {
    if KEYWORDS.iter().any(|word| name == word) {
        Ident::new_raw(&name.to_string(), name.span())
    } else if NEVER_A_NAME.iter().any(|word| name == word) {
        Ident::new(&format!("{name}_"), name.span())
    } else {
        name.clone()
    }
}

/// Reports a name that is declared twice, at both places.
pub(super) fn report_duplicate(second: &Ident, first: &Ident, sink: &mut Sink) {
    let notes: Vec<(Mark, String)> = vec![
        (first.into(), format!("`{first}` is declared here first, and again further down; rename one of them")),
        (second.into(), format!("`{second}` is declared here a second time; rename one of them")),
    ];
    sink.rule(&rules::DUPLICATE_NAME, &[], notes);
}
