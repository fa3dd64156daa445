//! Some statements with all that is known: cut into parts, of which each is looked at by itself.

use super::super::belonging::{Kept, finer};
use super::super::engine::Fact;
use super::super::parts::{Looked, Part, spread, written};
use super::super::uses::each_asked;
use super::joint::size;
use super::prepared::join_wide;
use super::{Env, Several};
use crate::list::List;
use crate::program::{PlaceId, Statement, Value};

impl<'m> Several<'_, 'm> {
    pub(in super::super) fn spec(&self, list: &[Statement<'m>], env: &Env) -> Vec<Statement<'m>> {
        self.effort.set(self.effort.get().saturating_sub(list.len() + self.places.len()));
        let (body, _) = self.folded(list, env);
        let body = self.swept(body, env);
        let off = |place: PlaceId| env.facts[place.0] == Fact::Is(Value::Bool(false));
        let body = spread(self.places, body, &off);
        let looked = Looked::at(self.places, body);
        let stopped = self.by_stop(&looked, env);
        let tries = self.tries_stops.get();
        self.tries_stops.set(tries && stopped.is_none());
        let usual = self.by_parts(looked, env);
        self.tries_stops.set(tries);
        match stopped {
            Some(stopped) if size(&stopped) < size(&usual) => stopped,
            _ => usual,
        }
    }

    /// Cut into parts, of which each is looked at by itself.
    fn by_parts(&self, looked: Looked<'m>, env: &Env) -> Vec<Statement<'m>> {
        let off = |place: PlaceId| env.facts[place.0] == Fact::Is(Value::Bool(false));
        let copies = self.copies(&looked.list, env);
        let situations = self.situations();
        let by_group = finer((self.places, &situations), &looked, &off, &copies);
        let mut parts = by_group.unwrap_or_else(|| looked.parts(self.places, &situations));
        join_wide(&mut parts, self.places);
        // By part, from the last one on: what is read after it.
        let mut later = vec![env.later.clone()];
        for part in parts.iter().skip(1).rev() {
            let mut reads = later.last().cloned().unwrap_or_default();
            each_asked(&part.statements, &mut |place| _ = reads.insert(place));
            later.push(reads);
        }
        let mut env = env.clone();
        let mut body = Vec::new();
        for part in parts {
            env.later = later.pop().unwrap_or_default();
            let statements = (!later.is_empty()).then(|| part.statements.clone());
            body.extend(self.part(part, &env));
            if let Some(statements) = statements {
                self.after(&statements, &mut env);
            }
        }
        body
    }

    /// By region, where its state before may be kept.
    fn copies(&self, list: &[Statement<'m>], env: &Env) -> Vec<Kept> {
        let free = self.free(list, env);
        let of = self.states.iter().zip(&self.was).enumerate();
        of.map(|(region, (state, was))| {
            let copy = was.filter(|_| free.contains(&region));
            let is_made = copy.is_some_and(|copy| env.facts[copy.0] == Fact::Copy(*state));
            Kept { state: *state, copy, is_made }
        })
        .list()
    }

    fn part(&self, part: Part<'m>, env: &Env) -> Vec<Statement<'m>> {
        match (&written(self.places, &part.statements)[..], &part.regions[..]) {
            (_, []) => part.statements,
            ([], _) if part.statements.len() < 2 => part.statements,
            ([region], _) | ([], [region]) => self.single(*region, part, env),
            ([], _) => part.statements,
            _ => self.joint(part, env),
        }
    }
}
