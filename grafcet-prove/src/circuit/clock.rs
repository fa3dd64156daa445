//! How exactly times have to be counted.
//!
//! Where times are only compared with constants, all that are longer than the longest of these are alike: so they saturate there, and
//! so does what passes between two cycles, which is an input. `min(min(t, M) + min(e, M), M) = min(t + e, M)`: nothing is lost.
//!
//! What blinks asks how far a period is. So of all that is longer as much is told apart as the periods tell apart: with a common multiple of
//! theirs above the longest constant, each longer time has one that is as far in each of them.

use grafcet_compiler::model::{Model, Name, Read, Tree, Ty};
use grafcet_compiler::program::{Expr, Program, Role, Run, Statement, Type, Value};

/// The bits of a time.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Clock {
    pub(super) width: usize,
    /// What all periods divide; one without any.
    pub(super) period: u32,
}

/// As wide as a tick count of the program.
const EXACT: usize = 32;

impl Clock {
    /// The one that tells what both do.
    pub(super) fn or(self, other: Self) -> Self {
        let Some(period) = common(self.period, other.period) else { return Self::EXACT };
        // More than either, and a common multiple above that.
        let most = |clock: Self| (1_u64 << clock.width) - u64::from(clock.period);
        Self::beyond(most(self).max(most(other)), period)
    }

    const EXACT: Self = Self { width: EXACT, period: 1 };

    /// That which tells apart all up to here, and then so many.
    fn beyond(longest: u64, period: u32) -> Self {
        // What saturates has to be more than any constant.
        let width = (longest + u64::from(period)).next_power_of_two().trailing_zeros() as usize;
        if width < EXACT { Self { width, period } } else { Self::EXACT }
    }

    /// `claims` are what properties look at, `deadline` is the longest that they ask for.
    pub(super) fn of(program: &Program<'_>, claims: &[Tree], deadline: u32) -> Self {
        let mut scan = Scan { program, longest: deadline, period: Some(1), exact: false };
        let declared = program.model.inputs.values().any(|input| matches!(input.ty, Ty::Time(_)));
        let stored = program.places.iter().any(|place| {
            matches!(place.ty, Type::Ticks) && matches!(place.role, Role::Output(_) | Role::Var(_) | Role::Param(_))
        });
        scan.exact = declared || stored;
        scan.block(&program.cycle);
        for claim in claims {
            scan.tree(claim);
        }
        match scan.period {
            Some(period) if !scan.exact => Self::beyond(u64::from(scan.longest) + 1, period),
            _ => Self::EXACT,
        }
    }
}

/// The least common multiple; none where it does not fit.
fn common(a: u32, b: u32) -> Option<u32> {
    let (mut divisor, mut rest) = (a, b);
    while rest > 0 {
        (divisor, rest) = (rest, divisor % rest);
    }
    (a / divisor.max(1)).checked_mul(b)
}

struct Scan<'p, 'm> {
    program: &'p Program<'m>,
    longest: u32,
    /// None where it is too long.
    period: Option<u32>,
    exact: bool,
}

impl Scan<'_, '_> {
    fn block(&mut self, statements: &[Statement<'_>]) {
        for statement in statements {
            match statement {
                Statement::Part(_, body) | Statement::Loop { body, .. } => self.block(body),
                Statement::Set(_, value) => self.expr(value),
                Statement::If(condition, then, otherwise) => {
                    self.expr(condition);
                    self.block(then);
                    self.block(otherwise);
                }
                Statement::Match(_, arms, otherwise) => {
                    for (_, body) in arms {
                        self.block(body);
                    }
                    self.block(otherwise);
                }
                Statement::Run(run) => self.run(run),
                Statement::Call(_, _, args) => args.iter().for_each(|arg| self.expr(arg)),
                Statement::Break | Statement::Mark(_) | Statement::Fence(_) => {}
            }
        }
    }

    fn run(&mut self, run: &Run<'_>) {
        run.binds.iter().for_each(|(_, bound)| self.expr(bound));
        // A block may do with a time what it likes.
        self.exact |= run.binds.iter().any(|(read, _)| is_time(self.program.model, *read));
    }

    fn expr(&mut self, expr: &Expr<'_>) {
        match expr {
            Expr::Value(Value::Ticks(ticks)) => self.longest = self.longest.max(*ticks),
            Expr::Period(reached, passed, period) => {
                self.period = self.period.and_then(|known| common(known, (*period).max(1)));
                self.expr(reached);
                self.expr(passed);
            }
            Expr::Sub(..) => self.exact = true,
            Expr::Not(inner) => self.expr(inner),
            Expr::All(parts) | Expr::Any(parts) => parts.iter().for_each(|part| self.expr(part)),
            Expr::Compare(_, a, b) | Expr::Add(a, b) => {
                self.expr(a);
                self.expr(b);
            }
            Expr::Choose(parts) => parts.iter().for_each(|part| self.expr(part)),
            Expr::User(user) => {
                user.binds.iter().for_each(|(_, bound)| self.expr(bound));
                self.tree(user.tree);
            }
            Expr::Value(_)
            | Expr::Place(_)
            | Expr::Initial(_)
            | Expr::Input(_)
            | Expr::Now
            | Expr::Is(..)
            | Expr::Next(_)
            | Expr::Table(..)
            | Expr::Since(..) => {}
        }
    }

    /// A time may be compared with a constant, and nothing else.
    fn tree(&mut self, tree: &Tree) {
        match tree {
            Tree::Read(Read::Ticks(ticks)) => self.longest = self.longest.max(*ticks),
            Tree::Read(read) => self.exact |= is_time(self.program.model, *read),
            Tree::Unary(_, inner) => self.tree(inner),
            Tree::Binary(operator, a, b) => match (&**a, &**b) {
                (Tree::Read(read), Tree::Read(Read::Ticks(ticks)))
                | (Tree::Read(Read::Ticks(ticks)), Tree::Read(read))
                    if operator.is_comparison() && is_time(self.program.model, *read) =>
                {
                    self.longest = self.longest.max(*ticks);
                }
                (a, b) => {
                    self.tree(a);
                    self.tree(b);
                }
            },
            Tree::Opaque { reads, .. } => {
                self.exact |= reads.iter().any(|read| is_time(self.program.model, *read));
            }
            Tree::Elapsed(time, _) | Tree::MacroElapsed(time, _) => {
                if let grafcet_compiler::model::TimeRef::Ticks(ticks) = time {
                    self.longest = self.longest.max(*ticks);
                }
            }
            Tree::Bool(_) | Tree::Int(_) => {}
        }
    }
}

fn is_time(model: &Model, read: Read) -> bool {
    match read {
        Read::Since(_) | Read::MacroSince(_) => true,
        Read::Name(name @ (Name::Input(_) | Name::Output(_) | Name::Var(_) | Name::Param(_))) => model.is_time(name),
        _ => false,
    }
}
