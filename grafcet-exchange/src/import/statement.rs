//! Statements of structured text.

use super::Wrong;
use super::parser::{Arm, Cursor, DEEPEST, Expr, Label, Statement};

/// What ends the statements in front of it.
const ENDS: [&str; 9] =
    ["elsif", "else", "end_if", "end_case", "end_for", "end_while", "until", "end_repeat", "end_action"];

impl Cursor<'_> {
    pub(super) fn statements(&mut self) -> Result<Vec<Statement>, Wrong> {
        let mut statements = Vec::new();
        loop {
            while self.sign(";") {}
            let ends = ENDS.iter().any(|word| self.is_word(word)) || self.is_label();
            if ends || self.peek().is_none() {
                return Ok(statements);
            }
            self.statement(&mut statements)?;
        }
    }

    /// A body within another one.
    fn inner(&mut self) -> Result<Vec<Statement>, Wrong> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return self.wrong("statements that are nested less deep");
        }
        let inner = self.statements()?;
        self.depth -= 1;
        Ok(inner)
    }

    fn statement(&mut self, statements: &mut Vec<Statement>) -> Result<(), Wrong> {
        let start = self.here();
        let done = if self.word("if") {
            self.if_()?
        } else if self.word("case") {
            self.case()?
        } else if self.word("for") {
            self.for_()?
        } else if self.word("while") {
            let condition = self.expr()?;
            self.need_word("do")?;
            let body = self.inner()?;
            self.need_word("end_while")?;
            Statement::While(condition, body)
        } else if self.word("repeat") {
            let body = self.inner()?;
            self.need_word("until")?;
            let condition = self.expr()?;
            self.sign(";");
            self.need_word("end_repeat")?;
            Statement::Repeat(body, condition)
        } else if self.word("exit") {
            Statement::Exit
        } else if self.word("continue") {
            Statement::Continue
        } else if self.is_word("return") {
            return Err(Wrong { at: start, message: "`RETURN` is not translated".to_owned() });
        } else {
            return self.simple(statements);
        };
        statements.push(done);
        Ok(())
    }

    /// An assignment, or a call with what it writes.
    fn simple(&mut self, statements: &mut Vec<Statement>) -> Result<(), Wrong> {
        let name = self.name()?;
        if self.sign("(") {
            let (arguments, outputs) = self.arguments_and_outputs()?;
            statements.push(Statement::Call(name.clone(), arguments));
            let read =
                |(output, target): (String, String)| Statement::Assign(target, Expr::Member(name.clone(), output));
            statements.extend(outputs.into_iter().map(read));
            return Ok(());
        }
        // An input of an instance.
        let target = if self.sign(".") { format!("{name}.{}", self.name()?) } else { name };
        if !self.sign(":=") {
            return self.wrong("`:=`, or a call: other statements are not translated");
        }
        let value = self.expr()?;
        statements.push(Statement::Assign(target, value));
        Ok(())
    }

    fn if_(&mut self) -> Result<Statement, Wrong> {
        let mut branches = Vec::new();
        loop {
            let condition = self.expr()?;
            self.need_word("then")?;
            branches.push((condition, self.inner()?));
            if !self.word("elsif") {
                break;
            }
        }
        let otherwise = if self.word("else") { self.inner()? } else { Vec::new() };
        self.need_word("end_if")?;
        Ok(Statement::If(branches, otherwise))
    }

    fn case(&mut self) -> Result<Statement, Wrong> {
        let of = self.expr()?;
        self.need_word("of")?;
        let mut arms = Vec::new();
        while !self.is_word("else") && !self.is_word("end_case") {
            let mut labels = Vec::new();
            loop {
                let first = self.expr()?;
                labels.push(if self.sign("..") { Label::Range(first, self.expr()?) } else { Label::One(first) });
                if !self.sign(",") {
                    break;
                }
            }
            self.need(":")?;
            arms.push(Arm { labels, body: self.inner()? });
        }
        let otherwise = if self.word("else") { self.inner()? } else { Vec::new() };
        self.need_word("end_case")?;
        Ok(Statement::Case(of, arms, otherwise))
    }

    fn for_(&mut self) -> Result<Statement, Wrong> {
        let name = self.name()?;
        self.need(":=")?;
        let from = self.expr()?;
        self.need_word("to")?;
        let to = self.expr()?;
        let by = if self.word("by") { Some(self.expr()?) } else { None };
        self.need_word("do")?;
        let body = self.inner()?;
        self.need_word("end_for")?;
        Ok(Statement::For(name, [from, to], by, body))
    }
}
