//! Where each local is declared: in the innermost block that has all mentions of it, by its first assignment where there is one.

use super::layout::Layout;
use crate::program::uses::{
    each_block, each_own_asked, each_own_written, each_written, is_read_in, is_written_in, mentions,
};
use crate::program::{PlaceId, Program, Statement};

/// The declarations, by the number of their statement in the order of the program's text.
pub(super) struct Scope {
    /// Those that stand in front of a statement.
    pub(super) before: Vec<Vec<PlaceId>>,
    /// Whether a `Set` declares what it sets.
    pub(super) declares: Vec<bool>,
    /// By place: whether it is written again after its declaration.
    pub(super) mutable: Vec<bool>,
    /// By place: each way through the statement in front of which it is declared sets it once, before anything reads it.
    pub(super) settled: Vec<bool>,
}

/// A block that is being walked through.
#[derive(Clone, Copy)]
struct Level {
    block: usize,
    /// The statement of the block that is looked at.
    statement: usize,
    /// It is the body of a loop.
    is_loop: bool,
}

/// What is known about a place so far.
#[derive(Clone, Default)]
struct Mentions {
    /// The path to the first mention.
    first: Vec<Level>,
    /// How much of it leads to all of them.
    common: usize,
    /// The first mention is an assignment to it.
    by_set: bool,
    writes: usize,
}

/// Where each place is mentioned.
struct MentionSearch<'s, 'm> {
    blocks: usize,
    statements: usize,
    path: Vec<Level>,
    mentions: Vec<Option<Mentions>>,
    /// By number.
    all: Vec<&'s Statement<'m>>,
}

impl Scope {
    pub(super) fn of(program: &Program<'_>, layout: &Layout, cycle: &[Statement<'_>]) -> Self {
        let mut search = MentionSearch {
            blocks: 0,
            statements: 0,
            path: Vec::new(),
            mentions: vec![None; program.places.len()],
            all: Vec::new(),
        };
        search.block(cycle, false);
        let mut scope = Self {
            before: vec![Vec::new(); search.statements],
            declares: vec![false; search.statements],
            mutable: vec![false; program.places.len()],
            settled: vec![false; program.places.len()],
        };
        let set_once = SetOnce { program, layout };
        for (index, mentions) in std::mem::take(&mut search.mentions).into_iter().enumerate() {
            if let (Some(mentions), true) = (mentions, layout.is_local(PlaceId(index))) {
                scope.declare(PlaceId(index), &mentions, &search.all, &set_once);
            }
        }
        scope
    }

    fn declare(&mut self, place: PlaceId, mentions: &Mentions, all: &[&Statement<'_>], set_once: &SetOnce<'_, '_>) {
        let Mentions { first, common, by_set, writes } = mentions;
        let Some(inner) = first[..*common].last() else { return };
        if *by_set && first.len() == *common {
            self.declares[inner.statement] = true;
            self.mutable[place.0] = *writes > 1;
            return;
        }
        // A loop must not begin it anew.
        let outside = first[..*common].iter().position(|level| level.is_loop).map_or(*common, |inside| inside);
        if let Some(level) = first[..outside].last() {
            self.before[level.statement].push(place);
            let sets = set_once.sets(all[level.statement], place);
            let again = *writes > times_written(all[level.statement], place);
            self.settled[place.0] = sets == Some(true) && !again;
            self.mutable[place.0] = *writes > 0 && !self.settled[place.0];
        }
    }
}

impl<'s, 'm> MentionSearch<'s, 'm> {
    fn block(&mut self, statements: &'s [Statement<'m>], is_loop: bool) {
        let level = Level { block: self.blocks, statement: self.statements, is_loop };
        self.blocks += 1;
        self.path.push(level);
        self.list(statements);
        self.path.pop();
    }

    fn list(&mut self, statements: &'s [Statement<'m>]) {
        for statement in statements {
            if let Statement::Part(_, body) = statement {
                self.list(body);
                continue;
            }
            if let Some(level) = self.path.last_mut() {
                level.statement = self.statements;
            }
            self.statements += 1;
            self.all.push(statement);
            let is_set = matches!(statement, Statement::Set(..));
            each_own_asked(statement, &mut |place| self.mention(place, false, false));
            each_own_written(statement, &mut |place| self.mention(place, true, is_set));
            let is_loop = matches!(statement, Statement::Loop { .. });
            each_block(statement, &mut |inner| self.block(inner, is_loop));
        }
    }

    fn mention(&mut self, place: PlaceId, writes: bool, by_set: bool) {
        let path = &self.path;
        let known = self.mentions[place.0].get_or_insert_with(|| Mentions {
            first: path.clone(),
            common: path.len(),
            by_set,
            writes: 0,
        });
        known.writes += usize::from(writes);
        let same = known.first.iter().zip(path).take_while(|(one, other)| one.block == other.block).count();
        known.common = known.common.min(same);
    }
}

/// Whether each way through statements sets a place once.
struct SetOnce<'s, 'm> {
    program: &'s Program<'m>,
    layout: &'s Layout,
}

impl SetOnce<'_, '_> {
    /// Whether each way sets it once, and none reads it before; `None` where only some do, or more than once.
    fn sets(&self, statement: &Statement<'_>, place: PlaceId) -> Option<bool> {
        match statement {
            Statement::Set(set, value) if *set == place => (!mentions(value, place)).then_some(true),
            Statement::If(condition, then, otherwise) => {
                let (then, otherwise) = (self.all_set(then, place)?, self.all_set(otherwise, place)?);
                (!mentions(condition, place) && then == otherwise).then_some(then)
            }
            Statement::Match(on, arms, otherwise) if *on != place => {
                let complete = self.layout.is_complete(self.program, self.program.places[on.0].ty, arms);
                let mut sets = if complete { None } else { Some(self.all_set(otherwise, place)?) };
                for (_, body) in arms {
                    let own = self.all_set(body, place)?;
                    if sets.is_some_and(|sets| sets != own) {
                        return None;
                    }
                    sets = Some(own);
                }
                sets
            }
            other => {
                let one = std::slice::from_ref(other);
                (!is_read_in(one, place) && !is_written_in(one, place)).then_some(false)
            }
        }
    }

    fn all_set(&self, statements: &[Statement<'_>], place: PlaceId) -> Option<bool> {
        for (at, statement) in statements.iter().enumerate() {
            let rest = &statements[at + 1..];
            if self.sets(statement, place)? {
                let again = rest.iter().any(|statement| times_written(statement, place) > 0);
                return (!again).then_some(true);
            }
        }
        Some(false)
    }
}

/// How often a place is written in the text of a statement.
fn times_written(statement: &Statement<'_>, place: PlaceId) -> usize {
    let mut writes = 0;
    each_written(std::slice::from_ref(statement), &mut |written| writes += usize::from(written == place));
    writes
}
