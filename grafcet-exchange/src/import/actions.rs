//! What steps do, as a person would have written it.

use std::collections::{BTreeMap, BTreeSet};

use super::Wrong;
use super::expr::{Kind, Scope};
use super::facts::{Facts, action, inline, is_set, variable};
use super::parser::{Expr, Statement, expression};
use super::source::{Block, Piece, Pou, Section, Span, What, same};

/// What a program has beside its steps.
pub(super) struct Actions<'p, 's> {
    pub(super) pou: &'p Pou,
    pub(super) facts: &'s Facts,
    pub(super) scope: &'s mut Scope<'p>,
    pub(super) notes: Vec<Wrong>,
    /// The keys of bodies that are stubs.
    pub(super) stubs: BTreeSet<String>,
    /// Code actions: what is said of them, and their parameters.
    pub(super) code: BTreeMap<String, (Vec<String>, String)>,
    /// Of actions that drive a place, by name in small letters: lines by step.
    pub(super) drives: BTreeMap<String, Option<Vec<(String, String)>>>,
}

impl<'p, 's> Actions<'p, 's> {
    pub(super) fn new(pou: &'p Pou, facts: &'s Facts, scope: &'s mut Scope<'p>) -> Self {
        Self {
            pou,
            facts,
            scope,
            notes: Vec::new(),
            stubs: BTreeSet::new(),
            code: BTreeMap::new(),
            drives: BTreeMap::new(),
        }
    }

    fn note(&mut self, at: &Span, message: impl Into<String>) {
        self.notes.push(Wrong { at: at.clone(), message: message.into() });
    }

    /// The lines in the body of a step.
    pub(super) fn of_step(&mut self, number: usize) -> Vec<String> {
        let mut lines = Vec::new();
        let step = &self.pou.steps[number];
        for (index, block) in step.blocks.iter().enumerate() {
            self.scope.active = vec![step.name.clone()];
            lines.extend(self.block(block, number, index));
            for differs in std::mem::take(&mut self.scope.differs) {
                self.note(&block.at, differs);
            }
        }
        // What an action does for this step that runs in each scan and stands at another one.
        let here =
            |name: &str| step.blocks.iter().any(|block| matches!(&block.what, What::Named(other) if same(other, name)));
        for action in &self.pou.actions {
            if is_set(self.pou, &action.name) && !here(&action.name) {
                lines.extend(self.driven(&action.name, number).unwrap_or_default());
            }
        }
        lines
    }

    fn block(&mut self, block: &Block, number: usize, index: usize) -> Vec<String> {
        let Some(qualifier) = self.qualifier(block) else { return Vec::new() };
        match &block.what {
            What::Named(name) => match action(self.pou, name) {
                Some(action) => {
                    if let Some(lines) = self.driven(&action.name, number) {
                        return lines;
                    }
                    let key = action.name.to_lowercase();
                    self.body(block, &qualifier, &key, &action.name, &action.body, &action.note)
                }
                None => self.boolean(block, &qualifier, name),
            },
            What::Inline(text) => {
                let name = format!("{}_{}", self.pou.steps[number].name, index + 1);
                self.body(block, &qualifier, &inline(number, index), &name, text, "")
            }
        }
    }

    /// `L 5s`
    fn qualifier(&mut self, block: &Block) -> Option<String> {
        let word = block.qualifier.to_uppercase();
        let has_time = ["L", "D", "SD", "DS", "SL"].contains(&&*word);
        if !has_time && !["N", "S", "R", "P", "P0", "P1"].contains(&&*word) {
            self.note(&block.at, format!("the qualifier `{word}` is none of IEC 61131-3: left out"));
            return None;
        }
        if !has_time {
            return Some(word);
        }
        let text = Piece { text: block.time.clone().unwrap_or_default(), at: block.at.clone(), language: None };
        let time = expression(&text).map_err(|wrong| wrong.message).and_then(|time| match time {
            Expr::Time(_) | Expr::Name(_) => self.scope.rust(&time, Some(Kind::Time)),
            _ => Err("its time is neither a literal nor a variable".to_owned()),
        });
        match time {
            Ok(time) => Some(format!("{word} {time}")),
            Err(why) => {
                self.note(&block.at, format!("`{word}` is left out: {why}"));
                None
            }
        }
    }

    fn boolean(&mut self, block: &Block, qualifier: &str, name: &str) -> Vec<String> {
        let known = variable(self.pou, name).is_some_and(|variable| Kind::of(&variable.ty) == Some(Kind::Bool));
        if !known {
            self.note(&block.at, format!("`{name}` is neither an action nor a boolean of this program: left out"));
            return Vec::new();
        }
        let there = name;
        let name = self.scope.names.get(name).unwrap_or_default().to_owned();
        if self.facts.assigned.contains(&there.to_lowercase()) && ["N", "S", "R"].contains(&qualifier) {
            let message = format!(
                "`{there}` is assigned by an action, too: here this step assigns it when it begins and, for `N`, when it ends"
            );
            self.note(&block.at, message);
            let mut lines = vec![format!("P1 {name} = {};", qualifier != "R")];
            lines.extend((qualifier == "N").then(|| format!("P0 {name} = false;")));
            return lines;
        }
        match qualifier {
            "N" => vec![format!("{name};")],
            "P1" | "P0" => {
                let what = format!(
                    "`{qualifier}` does nothing to a boolean by the standard; what is meant may be `P {name}` or `{qualifier} {name} = true`"
                );
                self.note(&block.at, what);
                Vec::new()
            }
            _ => vec![format!("{qualifier} {name};")],
        }
    }

    /// What an action does, or a code action that stands for it.
    fn body(&mut self, block: &Block, qualifier: &str, key: &str, name: &str, text: &Piece, said: &str) -> Vec<String> {
        let facts = self.facts;
        let word = qualifier.split(' ').next().unwrap_or_default();
        let translated = match &facts.bodies[key] {
            Err(why) => Err(why.clone()),
            Ok(body) if body.is_empty() || facts.only_remembers(body) => return Vec::new(),
            Ok(body) => match &body[..] {
                [Statement::Call(instance, arguments)] => self.call(qualifier, instance, arguments),
                [Statement::Assign(target, value)] if self.is_assigned(word, target) => {
                    let kind = self.scope.kinds.get(&target.to_lowercase()).copied();
                    let value = self.scope.rust(value, kind);
                    let target = self.scope.names.get(target).unwrap_or_default();
                    value.map(|value| vec![format!("{qualifier} {target} = {value};")])
                }
                _ if ["S", "R", "SD", "DS", "SL"].contains(&word) => {
                    Err(format!("what `{word}` stores or ends it is told by name"))
                }
                body => self.scope.block(body, 1).map(|lines| {
                    if let [one] = &lines[..] {
                        return vec![format!("{qualifier} {{ {} }}", one.trim())];
                    }
                    let lines = lines.into_iter();
                    std::iter::once(format!("{qualifier} {{")).chain(lines).chain(["}".to_owned()]).collect()
                }),
            },
        };
        match translated {
            Ok(lines) => {
                self.twice(block, word, name);
                let said = [said.to_owned()].into_iter().chain(comments(&text.text));
                let said = said.flat_map(|one| one.lines().map(|line| line.trim().to_owned()).collect::<Vec<_>>());
                said.filter(|line| !line.is_empty()).map(|line| format!("// {line}")).chain(lines).collect()
            }
            Err(why) => {
                self.stubs.insert(key.to_owned());
                self.note(&text.at, format!("`{name}` is a code action to be written in Rust: {why}"));
                vec![format!("{qualifier} {}();", self.stub(name, text, said))]
            }
        }
    }

    /// A stored value, which is assigned, or a variable that is assigned in each cycle.
    fn is_assigned(&self, word: &str, target: &str) -> bool {
        let known = variable(self.pou, target);
        match word {
            "P1" | "P0" => known.is_some(),
            "N" => known.is_some_and(|variable| variable.section == Section::Local && variable.address.is_none()),
            _ => false,
        }
    }

    /// Several steps share an action, and each has its own here: where one follows the other, it ends and begins.
    fn twice(&mut self, block: &Block, word: &str, name: &str) {
        if word != "N" && word != "L" && word != "D" {
            return;
        }
        let has = |step: &str| {
            let step = self.pou.steps.iter().find(|other| same(&other.name, step));
            step.is_some_and(|step| {
                step.blocks.iter().any(|block| matches!(&block.what, What::Named(other) if same(other, name)))
            })
        };
        let follows = self.pou.transitions.iter().find(|transition| {
            let pairs = transition.from.iter().flat_map(|from| transition.to.iter().map(move |to| (from, to)));
            // One step that follows itself has one action.
            pairs.into_iter().any(|(from, to)| !same(from, to) && has(from) && has(to))
        });
        if let Some(transition) = follows {
            let message = format!(
                "`{name}` goes on from `{}` to `{}` in the file, and here has its final call in one and a first one in the other, in one cycle",
                transition.from.join(", "),
                transition.to.join(", ")
            );
            self.note(&block.at, message);
        }
    }

    /// A code action with the text that it stands for.
    fn stub(&mut self, name: &str, text: &Piece, said: &str) -> String {
        let rust = self.scope.names.action(name);
        let mut docs: Vec<String> = Vec::new();
        docs.extend((!said.is_empty()).then(|| said.to_owned()));
        docs.push(format!("To be written: `{name}` was {}", text.language.as_deref().unwrap_or("structured text")));
        docs.extend(super::rust::original(&text.text));
        self.code.entry(rust.clone()).or_insert((docs, String::new()));
        rust
    }

    /// A call of a function block is one of a code action.
    fn call(
        &mut self,
        qualifier: &str,
        instance: &str,
        arguments: &[(Option<String>, Expr)],
    ) -> Result<Vec<String>, String> {
        let Some(block) = variable(self.pou, instance) else { return Err(format!("`{instance}` is not declared")) };
        if ["R_TRIG", "F_TRIG", "TON", "TOF", "TP", "CTU", "CTD", "CTUD", "SR", "RS"]
            .contains(&&*block.ty.to_uppercase())
        {
            return Err(format!("what `{}` gives is asked for elsewhere", block.ty));
        }
        let declared = self.scope.pous.iter().find(|pou| same(&pou.name, &block.ty));
        let (mut given, mut parameters) = (Vec::new(), Vec::new());
        for (index, (name, value)) in arguments.iter().enumerate() {
            // Which call it is a code action is told anyway.
            let told = name.as_deref().is_some_and(|name| same(name, "run"));
            if told
                && (*value == Expr::Bool(true)
                    || matches!(value, Expr::Member(step, member) if same(member, "x") && self.scope.active.contains(step)))
            {
                continue;
            }
            let input = declared.and_then(|pou| {
                pou.variables.iter().find(|one| name.as_deref().is_some_and(|name| same(name, &one.name)))
            });
            let kind = input.and_then(|input| self.scope.kind_of(&input.ty)).or_else(|| self.scope.kind(value));
            let Some(kind) = kind else { return Err(format!("the type of an argument of `{instance}` is not known")) };
            given.push(self.scope.rust(value, Some(kind))?);
            let name = name
                .as_deref()
                .map_or_else(|| format!("argument_{}", index + 1), |name| super::names::Names::new().value(name));
            parameters.push(format!("{name}: {}", self.scope.type_of(kind)));
        }
        let known = self.scope.names.get(instance).map(str::to_owned);
        let rust = known.unwrap_or_else(|| self.scope.names.value(instance));
        let parameters = parameters.join(", ");
        let docs = block.note.lines().map(str::to_owned).collect();
        let declared = self.code.entry(rust.clone()).or_insert((docs, parameters.clone()));
        if declared.1 != parameters {
            return Err(format!("`{instance}` is called with other arguments elsewhere"));
        }
        Ok(vec![format!("{qualifier} {rust}({});", given.join(", "))])
    }
}

/// What is said within a body. What a drawing has in other languages than structured text has none.
fn comments(text: &str) -> Vec<String> {
    let lexed = super::lexer::lex(text, 0).map(|lexed| lexed.comments).unwrap_or_default();
    lexed.into_iter().map(|(words, _)| words).collect()
}
