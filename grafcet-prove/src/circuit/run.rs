//! Statements: what the places hold after them, as wires. Loops are unrolled.

use std::rc::Rc;

use grafcet_compiler::model::{Place, Statement as Code, Ty};
use grafcet_compiler::program::{Expr, Mark, PlaceId, Role, Run, Statement, Type, Value};

use super::free::Origin;
use super::sym::Sym;
use super::{Env, Lowering, Refused};
use crate::aig::Lit;
use crate::probe::Probe;

/// What the places hold, and where the innermost loop has been left.
type After = (Env, Lit);

impl<'m> Lowering<'_, 'm> {
    pub(super) fn block(&mut self, env: Env, statements: &[Statement<'m>]) -> Result<After, Refused> {
        let mut env = env;
        for (index, statement) in statements.iter().enumerate() {
            let (after, left) = self.statement(env, statement)?;
            if left == Lit::TRUE {
                return Ok((after, left));
            }
            env = after;
            if left != Lit::FALSE {
                let path = self.path;
                self.path = self.aig.and(path, !left);
                let (rest, later) = self.block(env.clone(), &statements[index + 1..])?;
                self.path = path;
                let merged = self.merge(left, &env, &rest)?;
                return Ok((merged, self.aig.or(left, later)));
            }
        }
        Ok((env, Lit::FALSE))
    }

    fn statement(&mut self, mut env: Env, statement: &Statement<'m>) -> Result<After, Refused> {
        match statement {
            Statement::Part(_, body) => return self.block(env, body),
            Statement::Set(place, value) => {
                if self.program.places[place.0].role == Role::Reading {
                    return Ok((env, Lit::FALSE));
                }
                let value = self.eval(value, &env)?;
                self.write(&mut env, *place, value)?;
            }
            Statement::If(condition, then, otherwise) => {
                let condition = self.holds(condition, &env)?;
                return self.branch(condition, env, then, otherwise);
            }
            Statement::Match(place, arms, otherwise) => return self.arms(*place, env, arms, otherwise),
            Statement::Loop { rounds, body } => return Ok((self.rounds(*rounds, env, body)?, Lit::FALSE)),
            Statement::Break => return Ok((env, Lit::TRUE)),
            Statement::Run(run) => self.user(run, &mut env)?,
            Statement::Call(action, _, args) => {
                let params = &self.program.model.actions[*action].params;
                for (arg, (_, ty)) in args.iter().zip(params) {
                    let value = self.eval(arg, &env)?;
                    // It may overflow; nothing else of it matters.
                    self.placed(value, Type::User(ty))?;
                }
            }
            Statement::Mark(Mark::Evolved) => self.evolutions.push(Vec::new()),
            Statement::Mark(mark) => {
                let path = self.path;
                self.evolutions.last_mut().into_iter().for_each(|marks| marks.push((*mark, path)));
            }
            Statement::Fence(_) => {}
        }
        Ok((env, Lit::FALSE))
    }

    fn branch(
        &mut self,
        condition: Lit,
        env: Env,
        then: &[Statement<'m>],
        otherwise: &[Statement<'m>],
    ) -> Result<After, Refused> {
        match condition.known() {
            Some(true) => return self.block(env, then),
            Some(false) => return self.block(env, otherwise),
            None => {}
        }
        let path = self.path;
        self.path = self.aig.and(path, condition);
        let (first, left) = self.block(env.clone(), then)?;
        self.path = self.aig.and(path, !condition);
        let (second, other) = self.block(env, otherwise)?;
        self.path = path;
        let merged = self.merge(condition, &first, &second)?;
        Ok((merged, self.aig.mux(condition, left, other)))
    }

    fn arms(
        &mut self,
        place: PlaceId,
        env: Env,
        arms: &[(Vec<Value>, Vec<Statement<'m>>)],
        otherwise: &[Statement<'m>],
    ) -> Result<After, Refused> {
        let Some(((values, body), rest)) = arms.split_first() else { return self.block(env, otherwise) };
        let mut is = Lit::FALSE;
        for value in values {
            let value = self.value(*value)?;
            let same = self.equal(&env[place.0], &value)?;
            is = self.aig.or(is, same);
        }
        let path = self.path;
        self.path = self.aig.and(path, is);
        let (first, left) = self.block(env.clone(), body)?;
        self.path = self.aig.and(path, !is);
        let (second, other) = self.arms(place, env, rest, otherwise)?;
        self.path = path;
        let merged = self.merge(is, &first, &second)?;
        Ok((merged, self.aig.mux(is, left, other)))
    }

    /// As many rounds as are certain to be enough.
    fn rounds(&mut self, rounds: u32, env: Env, body: &[Statement<'m>]) -> Result<Env, Refused> {
        let path = self.path;
        let (mut env, mut ends) = (env, Vec::new());
        let mut probe = Probe::new();
        for round in 0..rounds {
            if probe.is_never(round, &self.aig, self.path) {
                break;
            }
            if self.rounds.len() <= round as usize {
                self.rounds.push(Lit::FALSE);
            }
            self.rounds[round as usize] = self.aig.or(self.rounds[round as usize], self.path);
            let (after, left) = self.block(env, body)?;
            env = after;
            ends.push((left, env.clone()));
            if left == Lit::TRUE {
                break;
            }
            self.path = self.aig.and(self.path, !left);
            if self.path == Lit::FALSE {
                break;
            }
            if self.aig.len() > self.largest {
                return Err(Refused::too_large());
            }
        }
        self.path = path;
        let Some((_, mut result)) = ends.pop() else { return Ok(env) };
        while let Some((left, end)) = ends.pop() {
            result = self.merge(left, &end, &result)?;
        }
        Ok(result)
    }

    pub(super) fn merge(&mut self, condition: Lit, then: &Env, otherwise: &Env) -> Result<Env, Refused> {
        if Rc::ptr_eq(then, otherwise) {
            return Ok(then.clone());
        }
        let mut merged = Vec::with_capacity(then.len());
        for (then, otherwise) in then.iter().zip(otherwise.iter()) {
            merged.push(self.mux(condition, then, otherwise)?);
        }
        Ok(Rc::new(merged))
    }

    fn write(&mut self, env: &mut Env, place: PlaceId, value: Sym) -> Result<(), Refused> {
        let value = self.kept(value, place)?;
        Rc::make_mut(env)[place.0] = value;
        Ok(())
    }

    /// A block of the user.
    fn user(&mut self, run: &Run<'m>, env: &mut Env) -> Result<(), Refused> {
        if let Some(statements) = &run.code.statements {
            *env = self.code(statements, run, env.clone())?;
            return Ok(());
        }
        // Nobody knows what it writes, nor whether it does.
        for write in &run.writes {
            let sym = Sym::Free(self.free(Origin::Made(run.code.text.clone()), Vec::new(), true));
            let sym = match self.program.places[write.to.0].ty {
                Type::User(Ty::Other(_)) if self.variants(write.to).is_some() => {
                    return Err(Refused("a block that writes an enum and is not looked into".to_owned()));
                }
                _ => sym,
            };
            self.write(env, write.to, sym)?;
            if let Some(noted) = write.noted {
                let sym = Sym::Free(self.free(Origin::Made(run.code.text.clone()), Vec::new(), true));
                self.write(env, noted, sym)?;
            }
        }
        Ok(())
    }

    fn code(&mut self, statements: &[Code], run: &Run<'m>, env: Env) -> Result<Env, Refused> {
        let mut env = env;
        for statement in statements {
            let reads = self.binds(run, &env)?;
            match statement {
                Code::Assign(place, tree) => {
                    let value = self.tree(tree, &reads)?;
                    self.assign(*place, value, run, &mut env)?;
                }
                Code::If(condition, then, otherwise) => {
                    let condition = self.tree(condition, &reads)?;
                    let condition = self.bool(&condition)?;
                    let path = self.path;
                    self.path = self.aig.and(path, condition);
                    let first = self.code(then, run, env.clone())?;
                    self.path = self.aig.and(path, !condition);
                    let second = self.code(otherwise, run, env)?;
                    self.path = path;
                    env = self.merge(condition, &first, &second)?;
                }
            }
        }
        Ok(env)
    }

    fn binds(&mut self, run: &Run<'m>, env: &Env) -> Result<Vec<(grafcet_compiler::model::Read, Sym)>, Refused> {
        let mut reads = Vec::new();
        for (read, bound) in &run.binds {
            // A place of the clock's is read by nobody.
            if matches!(bound, Expr::Now) {
                continue;
            }
            reads.push((*read, self.eval(bound, env)?));
        }
        Ok(reads)
    }

    fn assign(&mut self, place: Place, value: Sym, run: &Run<'m>, env: &mut Env) -> Result<(), Refused> {
        let Some(write) = run.writes.iter().find(|write| write.name == place) else {
            return Err(Refused(run.code.text.clone()));
        };
        self.write(env, write.to, value)?;
        if let Some(noted) = write.noted {
            Rc::make_mut(env)[noted.0] = Sym::bool(true);
        }
        Ok(())
    }
}
