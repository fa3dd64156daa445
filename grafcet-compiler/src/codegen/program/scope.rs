//! Where each local is declared: in the innermost block that has all mentions of it, by its first assignment where there is one.

use super::layout::Layout;
use super::visit::{self, Seen};
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
    /// The way to the first mention.
    first: Vec<Level>,
    /// How much of it leads to all of them.
    common: usize,
    /// The first mention is an assignment to it.
    by_set: bool,
    writes: usize,
}

struct Walk<'s, 'm> {
    blocks: usize,
    statements: usize,
    way: Vec<Level>,
    mentions: Vec<Option<Mentions>>,
    /// By number.
    all: Vec<&'s Statement<'m>>,
}

impl Scope {
    pub(super) fn of(program: &Program<'_>, layout: &Layout, cycle: &[Statement<'_>]) -> Self {
        let mut walk = Walk {
            blocks: 0,
            statements: 0,
            way: Vec::new(),
            mentions: vec![None; program.places.len()],
            all: Vec::new(),
        };
        walk.block(cycle, false);
        let mut scope = Self {
            before: vec![Vec::new(); walk.statements],
            declares: vec![false; walk.statements],
            mutable: vec![false; program.places.len()],
            settled: vec![false; program.places.len()],
        };
        let ways = Ways { program, layout };
        for (index, mentions) in std::mem::take(&mut walk.mentions).into_iter().enumerate() {
            if let (Some(mentions), true) = (mentions, layout.is_local(PlaceId(index))) {
                scope.declare(PlaceId(index), &mentions, &walk.all, &ways);
            }
        }
        scope
    }

    fn declare(&mut self, place: PlaceId, mentions: &Mentions, all: &[&Statement<'_>], ways: &Ways<'_, '_>) {
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
            let sets = ways.sets(all[level.statement], place);
            let again = *writes > Ways::writes(all[level.statement], place);
            self.settled[place.0] = sets == Some(true) && !again;
            self.mutable[place.0] = *writes > 0 && !self.settled[place.0];
        }
    }
}

impl<'s, 'm> Walk<'s, 'm> {
    fn block(&mut self, statements: &'s [Statement<'m>], is_loop: bool) {
        let level = Level { block: self.blocks, statement: self.statements, is_loop };
        self.blocks += 1;
        self.way.push(level);
        self.list(statements);
        self.way.pop();
    }

    fn list(&mut self, statements: &'s [Statement<'m>]) {
        for statement in statements {
            if let Statement::Part(_, body) = statement {
                self.list(body);
                continue;
            }
            if let Some(level) = self.way.last_mut() {
                level.statement = self.statements;
            }
            self.statements += 1;
            self.all.push(statement);
            let is_set = matches!(statement, Statement::Set(..));
            visit::statement(statement, &mut |seen| match seen {
                Seen::Read(place) => self.mention(place, false, false),
                Seen::Written(place) => self.mention(place, true, is_set),
                Seen::Set(..) | Seen::Arm(..) | Seen::Entry(_) | Seen::Value(_) => {}
            });
            let is_loop = matches!(statement, Statement::Loop { .. });
            for inner in visit::blocks(statement) {
                self.block(inner, is_loop);
            }
        }
    }

    fn mention(&mut self, place: PlaceId, writes: bool, by_set: bool) {
        let way = &self.way;
        let known = self.mentions[place.0].get_or_insert_with(|| Mentions {
            first: way.clone(),
            common: way.len(),
            by_set,
            writes: 0,
        });
        known.writes += usize::from(writes);
        let same = known.first.iter().zip(way).take_while(|(one, other)| one.block == other.block).count();
        known.common = known.common.min(same);
    }
}

/// What the ways through statements do with a place.
struct Ways<'s, 'm> {
    program: &'s Program<'m>,
    layout: &'s Layout,
}

impl Ways<'_, '_> {
    /// How often it is written in the text.
    fn writes(statement: &Statement<'_>, place: PlaceId) -> usize {
        let mut writes = 0;
        visit::block(std::slice::from_ref(statement), &mut |seen| {
            writes += usize::from(matches!(seen, Seen::Written(written) if written == place));
        });
        writes
    }

    fn mentions(statements: &[Statement<'_>], place: PlaceId) -> bool {
        let mut found = false;
        visit::block(statements, &mut |seen| {
            found |= matches!(seen, Seen::Read(other) | Seen::Written(other) if other == place);
        });
        found
    }

    /// Whether each way sets it once, and none reads it before; `None` where only some do, or more than once.
    fn sets(&self, statement: &Statement<'_>, place: PlaceId) -> Option<bool> {
        match statement {
            Statement::Set(set, value) if *set == place => {
                let mut reads = false;
                visit::expr(value, &mut |seen| reads |= matches!(seen, Seen::Read(read) if read == place));
                (!reads).then_some(true)
            }
            Statement::If(condition, then, otherwise) => {
                let mut reads = false;
                visit::expr(condition, &mut |seen| reads |= matches!(seen, Seen::Read(read) if read == place));
                let (then, otherwise) = (self.all_set(then, place)?, self.all_set(otherwise, place)?);
                (!reads && then == otherwise).then_some(then)
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
            other => (!Self::mentions(std::slice::from_ref(other), place)).then_some(false),
        }
    }

    fn all_set(&self, statements: &[Statement<'_>], place: PlaceId) -> Option<bool> {
        for (at, statement) in statements.iter().enumerate() {
            let rest = &statements[at + 1..];
            if self.sets(statement, place)? {
                let again = rest.iter().any(|statement| Self::writes(statement, place) > 0);
                return (!again).then_some(true);
            }
        }
        Some(false)
    }
}
