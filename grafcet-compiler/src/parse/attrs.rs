//! Attributes and doc comments: what is passed on, what sets the level of a rule, and what is refused.

use proc_macro2::{Delimiter, TokenStream};
use quote::ToTokens;
use syn::punctuated::Punctuated;
use syn::{AttrStyle, Attribute, Meta, MetaList, Path, Token};

use super::input::Turns;
use super::{Error, Input, Result};
use crate::ast::{Attrs, Derive, LevelAttr};
use crate::diagnostic::{Mark, Severity, Sink, rules};
use crate::list::{List, PushAll};

/// The attributes in front of an item.
#[derive(Default)]
pub(super) struct Outer {
    pub(super) attrs: Attrs,
    /// Where each of them stands and whether it is more than documentation.
    marks: Vec<Mark>,
}

impl Outer {
    /// Reports the attributes in front of something that no attribute changes anything about.
    pub(super) fn refuse(self, what: &str, sink: &mut Sink) {
        for mark in self.marks {
            sink.notation(
                mark,
                format!("{what} has nothing that an attribute or a doc comment could reach; remove it, or write `//`"),
            );
        }
    }

    /// The error where nothing follows the attributes; attributes that are mistakes themselves say enough.
    pub(super) fn of_nothing(&self, input: &Input) -> Error {
        if self.marks.is_empty() { Error::reported() } else { input.error("expected an item after its attributes") }
    }

    /// Reports attributes for the generated item where there is none.
    pub(super) fn levels_only(self, what: &str, sink: &mut Sink) -> Attrs {
        for attr in self.attrs.passed_on.iter().filter(|attr| !attr.path().is_ident("doc")) {
            let message = format!(
                "nothing is generated for {what} that this could reach; possible here is `#[allow(grafcet::…)]`"
            );
            sink.notation(Mark::of(attr), message);
        }
        self.attrs
    }
}

/// What to do about attributes in the middle of something.
pub(super) const MISPLACED: &str =
    "attributes and doc comments stand in front of a whole declaration, step or chain, not in the middle of it";

/// The attributes in front of the chart.
pub(super) fn of_chart(input: &mut Input, sink: &mut Sink) -> Attrs {
    all(input, sink).attrs
}

/// The attributes that stand in front of what comes next in a body.
pub(super) fn outer(input: &mut Input, sink: &mut Sink) -> Outer {
    let mut outer = all(input, sink);
    for derive in outer.attrs.derives.drain(..) {
        sink.notation(derive.mark, "derives stand in front of the chart and reach all its types");
    }
    outer
}

fn all(input: &mut Input, sink: &mut Sink) -> Outer {
    let (mut outer, mut turns) = (Outer::default(), Turns::default());
    while turns.more(input) && input.at("#") {
        let start = *input;
        if input.next().at("!") {
            inner_out_of_place(input, sink);
        } else if let Err(error) = one(input, &mut outer) {
            error.report(sink);
            // The brackets of an attribute that could not be read.
            if input.is_at(&start) {
                input.bump();
                input.enter(Delimiter::Bracket);
            }
        }
    }
    outer
}

fn inner_out_of_place(input: &mut Input, sink: &mut Sink) {
    let start = *input;
    input.bump();
    input.bump();
    input.enter(Delimiter::Bracket);
    sink.notation(
        input.since(&start),
        "an inner attribute stands at the beginning of the braces it is about; in front of an item write `#[…]`",
    );
}

fn one(input: &mut Input, outer: &mut Outer) -> Result<()> {
    let start = *input;
    let attr = read(input)?;
    let mark = input.since(&start);
    sort(attr, mark, &mut outer.attrs)?;
    outer.marks.push(mark);
    Ok(())
}

/// Cuts out `#[…]` or `#![…]` and lets `syn` read it.
fn read(input: &mut Input) -> Result<Attribute> {
    let inner = input.next().at("!");
    let mut brackets = input.next();
    if inner {
        brackets.bump();
    }
    if !brackets.at_group(Delimiter::Bracket) {
        return Err(brackets.error(format!("expected the brackets of an attribute, found {}", brackets.found())));
    }
    input.rust_tokens(2 + usize::from(inner), |input| {
        let content;
        Ok(Attribute {
            pound_token: input.parse()?,
            style: if inner { AttrStyle::Inner(input.parse()?) } else { AttrStyle::Outer },
            bracket_token: syn::bracketed!(content in input),
            meta: content.parse()?,
        })
    })
}

/// Puts an attribute where it goes, or says why it goes nowhere.
fn sort(attr: Attribute, mark: Mark, attrs: &mut Attrs) -> Result<()> {
    let path = attr.path();
    if path.is_ident("doc") {
        attrs.passed_on.push(attr);
        return Ok(());
    }
    if let Some(derive) = derive(&attr.meta, mark)? {
        attrs.derives.push(derive);
        return Ok(());
    }
    if path.is_ident("cfg") || path.is_ident("cfg_attr") {
        let message = "conditional compilation belongs on the whole macro call: `#[cfg(…)] grafcet! { … }`; a condition \
                       is possible on what the chart derives: `#[cfg_attr(…, derive(…))]`";
        return Err(Error::new(mark, message));
    }
    let Some(set) = level_of(path) else {
        let message = "possible here are doc comments, the lint attributes `allow`, `expect`, `warn`, `deny` and `forbid`, and \
             `derive` in front of the chart";
        return Err(Error::new(mark, message));
    };
    let Meta::List(list) = &attr.meta else {
        return Err(Error::new(mark, "a lint attribute lists its lints: `#[allow(grafcet::unreachable_step)]`"));
    };
    let lints = list.parse_args_with(Punctuated::<Meta, Token![,]>::parse_terminated)?;
    let mut others = Vec::new();
    let mut mistakes = Vec::new();
    for lint in &lints {
        match lint {
            Meta::Path(path) if tool(path) == Some("grafcet") => match level(path, set) {
                Ok(level) => attrs.levels.push(level),
                Err(mistake) => mistakes.push(mistake),
            },
            Meta::Path(path) if tool(path).is_none() => {
                let message = "possible are lints of rustc, `clippy::…`, `rustdoc::…` and `grafcet::…`";
                mistakes.push((Mark::of(path), message.to_owned()));
            }
            other => others.push(other.clone()),
        }
    }
    if others.len() == lints.len() {
        attrs.passed_on.push(attr);
    } else if others.iter().any(|meta| matches!(meta, Meta::Path(_))) {
        attrs.passed_on.push(rest(&attr, list, &others));
    }
    Error::several(mistakes).map_or(Ok(()), Err)
}

/// `derive(…)`, also after the condition of a `cfg_attr`.
fn derive(meta: &Meta, mark: Mark) -> Result<Option<Derive>> {
    let Meta::List(list) = meta else { return Ok(None) };
    if list.path.is_ident("derive") {
        let traits = list.parse_args_with(Punctuated::<Path, Token![,]>::parse_terminated)?;
        return Ok(Some(Derive { when: None, traits: traits.into_iter().list(), mark }));
    }
    if !list.path.is_ident("cfg_attr") {
        return Ok(None);
    }
    let metas = list.parse_args_with(Punctuated::<Meta, Token![,]>::parse_terminated)?;
    let mut metas = metas.iter();
    let Some(when) = metas.next().map(ToTokens::to_token_stream) else { return Ok(None) };
    let mut traits = Vec::new();
    for meta in metas {
        let Some(inner) = derive(meta, mark)?.filter(|inner| inner.when.is_none()) else { return Ok(None) };
        traits.push_all(inner.traits);
    }
    Ok((!traits.is_empty()).then_some(Derive { when: Some(when), traits, mark }))
}

/// What a lint attribute does to its lints.
#[derive(Clone, Copy)]
enum Level {
    Is(Severity),
    Expected,
}

/// The level a lint attribute sets.
fn level_of(path: &Path) -> Option<Level> {
    match path.get_ident()?.to_string().as_str() {
        "allow" => Some(Level::Is(Severity::Allow)),
        "warn" => Some(Level::Is(Severity::Warn)),
        "deny" | "forbid" => Some(Level::Is(Severity::Deny)),
        "expect" => Some(Level::Expected),
        _ => None,
    }
}

/// Whose lint it is; `None` for somebody's who has no business here.
fn tool(path: &Path) -> Option<&'static str> {
    let first = path.segments.first()?;
    match path.segments.len() {
        1 => Some("rustc"),
        _ => ["grafcet", "clippy", "rustdoc"].into_iter().find(|tool| first.ident == tool),
    }
}

fn level(path: &Path, level: Level) -> std::result::Result<LevelAttr, (Mark, String)> {
    let Level::Is(severity) = level else {
        let message = "`expect` is for lints of rustc; a rule takes `allow`, `warn` or `deny`";
        return Err((Mark::of(path), message.to_owned()));
    };
    match path.segments.iter().nth(1) {
        Some(rule) if path.segments.len() == 2 && rule.arguments.is_none() => {
            match rules::refuse_level(&rule.ident.to_string(), severity) {
                Some(message) => Err(((&rule.ident).into(), message)),
                None => Ok(LevelAttr { severity, rule: rule.ident.clone() }),
            }
        }
        _ => Err((Mark::of(path), "a rule is named `grafcet::…`, such as `grafcet::unreachable_step`".to_owned())),
    }
}

/// The attribute without the rules: with only `others` in its list.
fn rest(attr: &Attribute, list: &MetaList, others: &[Meta]) -> Attribute {
    let mut tokens = TokenStream::new();
    for meta in others {
        meta.to_tokens(&mut tokens);
        <Token![,]>::default().to_tokens(&mut tokens);
    }
    let mut attr = attr.clone();
    attr.meta = Meta::List(MetaList { path: list.path.clone(), delimiter: list.delimiter.clone(), tokens });
    attr
}

/// The inner attributes at the beginning of a body.
pub(super) fn inner(input: &mut Input, sink: &mut Sink) -> Vec<LevelAttr> {
    let (mut attrs, mut turns) = (Attrs::default(), Turns::default());
    while turns.more(input) && input.at("#") && input.next().at("!") {
        let start = *input;
        let read = read(input);
        if read.is_err() && input.is_at(&start) {
            input.bump();
            input.bump();
            input.enter(Delimiter::Bracket);
        }
        let mark = input.since(&start);
        let result = read.and_then(|attr| sort(attr, mark, &mut attrs));
        if let Err(error) = result {
            error.report(sink);
        } else if !attrs.passed_on.is_empty() || !attrs.derives.is_empty() {
            attrs.passed_on.clear();
            attrs.derives.clear();
            sink.notation(
                mark,
                "inside a chart only the levels of rules can be set: `#![allow(grafcet::…)]`; \
                what the generated types shall carry stands in front of the header",
            );
        }
    }
    attrs.levels
}
