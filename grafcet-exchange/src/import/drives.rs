//! An action that stands for all steps which drive a place, as `cargo grafcet export` writes it, becomes what it came from: `q if cond`, `speed = 3`,
//! `S q if cond`.

use super::actions::Actions;
use super::expr::Kind;
use super::facts::{everywhere, variable};
use super::parser::{Expr, Op, Statement, expression};
use super::parts::conjunction;
use super::source::{Block, Section, What, same};
use super::walk::each;

/// How one step drives a place: the rest of its condition, and the statement of its branch.
type Driven<'e> = (&'e str, Vec<&'e Expr>, &'e Statement);

impl Actions<'_, '_> {
    /// The lines of this step, where the action drives a place for all its steps.
    pub(super) fn driven(&mut self, name: &str, number: usize) -> Option<Vec<String>> {
        let key = name.to_lowercase();
        if !self.drives.contains_key(&key) {
            let lines = self.drive(name);
            self.drives.insert(key.clone(), lines);
        }
        let step = &self.pou.steps[number].name;
        let lines = self.drives[&key].as_ref()?;
        Some(lines.iter().filter(|(of, _)| same(of, step)).map(|(_, line)| line.clone()).collect())
    }

    fn drive(&mut self, name: &str) -> Option<Vec<(String, String)>> {
        let facts = self.facts;
        let Some(Ok(body)) = facts.bodies.get(&name.to_lowercase()) else { return None };
        let mut lines = Vec::new();
        let mut rest = &body[..];
        while let Some(first) = rest.first() {
            let length =
                rest.iter().take_while(|next| switches(next).is_some() && switches(next) == switches(first)).count();
            let (group, more) = rest.split_at(length.max(1));
            if !facts.only_remembers(group) {
                lines.extend(self.group(group, name)?);
            }
            rest = more;
        }
        (!lines.is_empty()).then_some(lines)
    }

    /// Statements about one place.
    fn group(&mut self, body: &[Statement], name: &str) -> Option<Vec<(String, String)>> {
        let (target, driven) = match body {
            [Statement::Assign(target, value)] => (target, terms(value, &body[0])?),
            [Statement::If(branches, otherwise)] if !otherwise.is_empty() => self.values(branches, otherwise)?,
            all => stored(all)?,
        };
        let mut steps: Vec<&str> = driven.iter().map(|(step, ..)| *step).collect();
        steps.sort_unstable();
        steps.dedup();
        // It belongs to every step, or to those that it asks for.
        let everywhere = everywhere(self.pou, name);
        let only = everywhere
            || self.pou.steps.iter().all(|step| {
                let here: Vec<&Block> = step
                    .blocks
                    .iter()
                    .filter(|block| matches!(&block.what, What::Named(other) if same(other, name)))
                    .collect();
                here.iter().all(|block| same(&block.qualifier, "N"))
                    && here.is_empty() != steps.iter().any(|other| same(other, &step.name))
            });
        let alone =
            self.facts.bodies.iter().filter(|(_, body)| body.iter().any(|body| writes(body, target))).count() == 1;
        let controlled = self
            .pou
            .steps
            .iter()
            .flat_map(|step| &step.blocks)
            .any(|block| matches!(&block.what, What::Named(other) if same(other, target)));
        if !only || !alone || controlled {
            return None;
        }
        let place = self.scope.names.get(target)?.to_owned();
        let mut lines = Vec::new();
        for (step, rest, statement) in &driven {
            self.scope.active = vec![(*step).to_owned()];
            let what = match statement {
                Statement::Assign(..) if body.len() == 1 && matches!(body[0], Statement::Assign(..)) => place.clone(),
                Statement::Assign(_, Expr::Bool(true)) if is_stored(body) => format!("S {place}"),
                Statement::Assign(_, Expr::Bool(false)) if is_stored(body) => format!("R {place}"),
                Statement::Assign(target, value) => {
                    let kind = self.scope.kinds.get(&target.to_lowercase()).copied();
                    format!("{place} = {}", self.scope.rust(value, kind).ok()?)
                }
                _ => return None,
            };
            let rest =
                rest.iter().map(|one| (*one).clone()).reduce(|a, b| Expr::Binary(Op::And, Box::new(a), Box::new(b)));
            let condition = match rest {
                Some(rest) => format!(" if {}", self.scope.rust(&rest, Some(Kind::Bool)).ok()?),
                None => String::new(),
            };
            lines.push(((*step).to_owned(), format!("{what}{condition};")));
        }
        Some(lines)
    }

    /// `IF B.X THEN q := 4; ELSIF A.X THEN q := 3; ELSE q := 0; END_IF`, where the end is the initial value.
    fn values<'e>(
        &self,
        branches: &'e [(Expr, Vec<Statement>)],
        otherwise: &'e [Statement],
    ) -> Option<(&'e String, Vec<Driven<'e>>)> {
        let [Statement::Assign(target, last)] = otherwise else { return None };
        let declared = variable(self.pou, target)?;
        if declared.section != Section::Output {
            return None;
        }
        let initial = declared.init.as_ref().and_then(|init| expression(init).ok());
        let nothing = match Kind::of(&declared.ty)? {
            Kind::Bool => Expr::Bool(false),
            Kind::Time => Expr::Time(0),
            Kind::Number(_) => Expr::Int(0),
            Kind::Enum(_) => return None,
        };
        if *last != initial.unwrap_or(nothing) {
            return None;
        }
        let mut driven = Vec::new();
        for (condition, then) in branches.iter().rev() {
            let [one @ Statement::Assign(of, _)] = &then[..] else { return None };
            let (step, rest) = active(condition)?;
            if !same(of, target) {
                return None;
            }
            driven.push((step, rest, one));
        }
        Some((target, driven))
    }
}

/// The boolean that `IF … THEN q := TRUE; END_IF` switches.
fn switches(statement: &Statement) -> Option<&str> {
    let Statement::If(branches, otherwise) = statement else { return None };
    let ([(_, then)], []) = (&branches[..], &otherwise[..]) else { return None };
    let [Statement::Assign(target, Expr::Bool(_))] = &then[..] else { return None };
    Some(target)
}

/// `S.X AND c`
fn active(condition: &Expr) -> Option<(&str, Vec<&Expr>)> {
    let mut parts = conjunction(condition).into_iter();
    match parts.next() {
        Some(Expr::Member(step, member)) if same(member, "x") => Some((step, parts.collect())),
        _ => None,
    }
}

/// `A.X AND c OR B.X`
fn terms<'e>(value: &'e Expr, statement: &'e Statement) -> Option<Vec<Driven<'e>>> {
    let mut all = Vec::new();
    let mut rest = value;
    while let Expr::Binary(Op::Or, before, last) = rest {
        all.push(&**last);
        rest = before;
    }
    all.push(rest);
    let one = |term: &'e Expr| active(term).map(|(step, rest)| (step, rest, statement));
    all.into_iter().rev().map(one).collect()
}

/// `IF A.X THEN q := TRUE; END_IF; IF B.X THEN q := FALSE; END_IF`: reset is the last to be asked.
fn stored(body: &[Statement]) -> Option<(&String, Vec<Driven<'_>>)> {
    let mut driven = Vec::new();
    let mut target: Option<&String> = None;
    let mut reset = false;
    for statement in body {
        let Statement::If(branches, otherwise) = statement else { return None };
        let ([(condition, then)], []) = (&branches[..], &otherwise[..]) else { return None };
        let [one @ Statement::Assign(of, Expr::Bool(value))] = &then[..] else { return None };
        if target.is_some_and(|other| !same(other, of)) || reset && *value {
            return None;
        }
        reset |= !value;
        target = Some(of);
        let (step, more) = active(condition)?;
        driven.push((step, more, one));
    }
    target.map(|target| (target, driven))
}

fn is_stored(body: &[Statement]) -> bool {
    stored(body).is_some()
}

fn writes(body: &[Statement], name: &str) -> bool {
    let mut found = false;
    each(body, &mut |one| found |= super::facts::writes(one, name));
    found
}
