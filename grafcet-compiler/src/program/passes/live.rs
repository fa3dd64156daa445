//! What is live: read later on, before something writes it.

use super::super::build::not;
use super::super::{Arm, Expr, PlaceId, Statement, Write};
use super::uses::{each_asked, each_read, is_pure};

/// A set of places, one bit each: a search that asks for a thousand transitions has as many live in each of its ifs.
#[derive(Clone, PartialEq)]
pub(super) struct Places {
    words: Vec<u64>,
}

impl Places {
    /// From a list by place.
    pub(super) fn of(list: &[bool]) -> Self {
        let mut set = Self { words: vec![0; list.len().div_ceil(64)] };
        for (index, is_in) in list.iter().enumerate() {
            set.put(PlaceId(index), *is_in);
        }
        set
    }

    pub(super) fn contains(&self, place: PlaceId) -> bool {
        self.words.get(place.0 / 64).is_some_and(|word| word >> (place.0 % 64) & 1 == 1)
    }

    pub(super) fn put(&mut self, place: PlaceId, is_in: bool) {
        if place.0 / 64 >= self.words.len() {
            self.words.resize(place.0 / 64 + 1, 0);
        }
        let bit = 1 << (place.0 % 64);
        let word = &mut self.words[place.0 / 64];
        *word = if is_in { *word | bit } else { *word & !bit };
    }

    pub(super) fn join(&mut self, other: &Self) {
        if self.words.len() < other.words.len() {
            self.words.resize(other.words.len(), 0);
        }
        for (word, other) in self.words.iter_mut().zip(&other.words) {
            *word |= other;
        }
    }
}

/// What is live at a place of the program, gone through from its end to its beginning.
pub(super) struct Live<'l> {
    /// What is read after the end, in the next cycle or from outside.
    after: &'l Places,
    pub(super) now: Places,
    /// The same where a loop is left.
    pub(super) left: Places,
}

impl<'l> Live<'l> {
    pub(super) fn after(after: &'l Places) -> Self {
        Self::with(after, after.clone())
    }

    /// Where besides is read what comes between here and the end.
    pub(super) fn with(after: &'l Places, now: Places) -> Self {
        Self { after, left: now.clone(), now }
    }

    fn read(&mut self, expr: &Expr<'_>) {
        each_read(expr, &mut |place| self.now.put(place, true));
    }

    /// From the end to the beginning.
    pub(super) fn sweep(&mut self, statements: &mut Vec<Statement<'_>>) {
        let mut kept = Vec::with_capacity(statements.len());
        while let Some(mut statement) = statements.pop() {
            if self.keep(&mut statement) {
                kept.push(statement);
            }
        }
        kept.reverse();
        *statements = kept;
    }

    /// A round of a loop reads what the one before has written; after the loop is where it is left.
    pub(super) fn rounds(&mut self, body: &mut Vec<Statement<'_>>) {
        let after = self.now.clone();
        let outside = std::mem::replace(&mut self.left, after);
        // Of fields it is enough that they may be live.
        self.now.join(self.after);
        loop {
            let at_end = self.now.clone();
            self.sweep(&mut body.clone());
            self.now.join(&at_end);
            if self.now == at_end {
                break;
            }
        }
        let at_end = self.now.clone();
        self.sweep(body);
        self.now = at_end;
        self.left = outside;
    }

    fn keep(&mut self, statement: &mut Statement<'_>) -> bool {
        match statement {
            Statement::Part(_, body) => {
                self.sweep(body);
                !body.is_empty()
            }
            Statement::Set(place, value) => {
                if matches!(value, Expr::Place(other) if other == place) || !self.now.contains(*place) && is_pure(value)
                {
                    return false;
                }
                self.now.put(*place, false);
                self.read(value);
                true
            }
            Statement::If(condition, then, otherwise) => self.keep_if(condition, then, otherwise),
            Statement::Match(place, arms, otherwise) => {
                self.arms(arms, otherwise);
                self.now.put(*place, true);
                !(arms.is_empty() && otherwise.is_empty())
            }
            Statement::Run(run) => {
                let idle = run.code.statements.is_some() && run.binds.iter().all(|(_, value)| is_pure(value));
                let wanted = |write: &Write| {
                    self.now.contains(write.to) || write.noted.is_some_and(|noted| self.now.contains(noted))
                };
                if idle && !run.writes.iter().any(wanted) {
                    return false;
                }
                each_asked(std::slice::from_ref(statement), &mut |place| self.now.put(place, true));
                true
            }
            Statement::Break => {
                self.now.clone_from(&self.left);
                true
            }
            Statement::Loop { body, .. } => {
                self.rounds(body);
                true
            }
            other => {
                each_asked(std::slice::from_ref(other), &mut |place| self.now.put(place, true));
                true
            }
        }
    }
    fn keep_if<'m>(
        &mut self,
        condition: &mut Expr<'m>,
        then: &mut Vec<Statement<'m>>,
        otherwise: &mut Vec<Statement<'m>>,
    ) -> bool {
        let after = self.now.clone();
        self.sweep(then);
        let first = std::mem::replace(&mut self.now, after);
        self.sweep(otherwise);
        self.now.join(&first);
        if then.is_empty() && otherwise.is_empty() && is_pure(condition) {
            return false;
        }
        if then.is_empty() {
            std::mem::swap(then, otherwise);
            *condition = not(condition.clone());
        }
        self.read(condition);
        true
    }

    fn arms<'m>(&mut self, arms: &mut Vec<Arm<'m>>, otherwise: &mut Vec<Statement<'m>>) {
        let after = self.now.clone();
        self.sweep(otherwise);
        for (_, body) in arms.iter_mut() {
            let so_far = std::mem::replace(&mut self.now, after.clone());
            self.sweep(body);
            self.now.join(&so_far);
        }
        if otherwise.is_empty() {
            arms.retain(|(_, body)| !body.is_empty());
        }
    }
}
