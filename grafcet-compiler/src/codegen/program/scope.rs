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

struct Walk {
    blocks: usize,
    statements: usize,
    way: Vec<Level>,
    mentions: Vec<Option<Mentions>>,
}

impl Scope {
    pub(super) fn of(program: &Program<'_>, layout: &Layout, cycle: &[Statement<'_>]) -> Self {
        let mut walk = Walk { blocks: 0, statements: 0, way: Vec::new(), mentions: vec![None; program.places.len()] };
        walk.block(cycle, false);
        let mut scope = Self {
            before: vec![Vec::new(); walk.statements],
            declares: vec![false; walk.statements],
            mutable: vec![false; program.places.len()],
        };
        for (index, mentions) in walk.mentions.into_iter().enumerate() {
            if let (Some(mentions), true) = (mentions, layout.is_local(PlaceId(index))) {
                scope.declare(PlaceId(index), &mentions);
            }
        }
        scope
    }

    fn declare(&mut self, place: PlaceId, mentions: &Mentions) {
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
            self.mutable[place.0] = *writes > 0;
        }
    }
}

impl Walk {
    fn block(&mut self, statements: &[Statement<'_>], is_loop: bool) {
        let level = Level { block: self.blocks, statement: self.statements, is_loop };
        self.blocks += 1;
        self.way.push(level);
        self.list(statements);
        self.way.pop();
    }

    fn list(&mut self, statements: &[Statement<'_>]) {
        for statement in statements {
            if let Statement::Part(_, body) = statement {
                self.list(body);
                continue;
            }
            if let Some(level) = self.way.last_mut() {
                level.statement = self.statements;
            }
            self.statements += 1;
            let is_set = matches!(statement, Statement::Set(..));
            visit::statement(statement, &mut |seen| match seen {
                Seen::Read(place) => self.mention(place, false, false),
                Seen::Written(place) => self.mention(place, true, is_set),
                Seen::Set(..) | Seen::Arm(..) | Seen::Value(_) => {}
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
