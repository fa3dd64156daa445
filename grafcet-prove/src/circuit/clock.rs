//! How exactly times have to be counted.
//!
//! Where times are only compared with constants, all that are longer than the longest of these are alike: so they saturate there, and
//! so does what passes between two cycles, which is an input. `min(min(t, M) + min(e, M), M) = min(t + e, M)`: nothing is lost.

use grafcet_compiler::model::{Binary, Model, Name, Read, Tree, Ty};
use grafcet_compiler::program::{Expr, Program, Role, Run, Statement, Type, Value};

/// The bits of a time.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Clock {
    pub(super) width: usize,
}

/// As wide as a tick count of the program.
const EXACT: usize = 32;

impl Clock {
    /// The one that tells more.
    pub(super) fn or(self, other: Self) -> Self {
        Self { width: self.width.max(other.width) }
    }

    /// `claims` are what properties look at, `deadline` is the longest that they ask for.
    pub(super) fn of(program: &Program<'_>, claims: &[Tree], deadline: u32) -> Self {
        let mut scan = Scan { program, longest: deadline, exact: false };
        let declared = program.model.inputs.values().any(|input| matches!(input.ty, Ty::Time(_)));
        let stored = program.places.iter().any(|place| {
            matches!(place.ty, Type::Ticks) && matches!(place.role, Role::Output(_) | Role::Var(_) | Role::Param(_))
        });
        scan.exact = declared || stored;
        scan.block(&program.cycle);
        for claim in claims {
            scan.tree(claim);
        }
        if scan.exact {
            return Self { width: EXACT };
        }
        // What saturates has to be more than any constant.
        let width = (u64::from(scan.longest) + 2).next_power_of_two().trailing_zeros();
        Self { width: (width as usize).min(EXACT) }
    }
}

struct Scan<'p, 'm> {
    program: &'p Program<'m>,
    longest: u32,
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
            Expr::Period(..) | Expr::Sub(..) => self.exact = true,
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
                    if is_comparison(*operator) && is_time(self.program.model, *read) =>
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

fn is_comparison(operator: Binary) -> bool {
    matches!(operator, Binary::Eq | Binary::Ne | Binary::Lt | Binary::Le | Binary::Gt | Binary::Ge)
}
