//! The textual form of SFC: `PROGRAM … VAR … END_VAR INITIAL_STEP … TRANSITION … ACTION … END_PROGRAM`.

use super::Wrong;
use super::lexer::{Lexed, Token, lex};
use super::parser::Cursor;
use super::source::{Action, Block, Piece, Pou, Section, Span, Step, Transition, Variable, What};
use super::types::{self, Type};

/// Every program, function block and function of a file, and its types.
pub(super) fn pous(text: &str) -> Result<(Vec<Pou>, Vec<Type>), Wrong> {
    let lexed = lex(text, 0)?;
    let cursor = Cursor::new(&lexed, 0..text.len());
    let mut reader = Reader { text, cursor, heads: Vec::new(), ends: Vec::new(), types: Vec::new() };
    let mut pous = Vec::new();
    while reader.cursor.peek().is_some() {
        if reader.others() {
            continue;
        }
        let pou = reader.pou()?;
        reader.ends.push(reader.cursor.before().end);
        pous.push(pou);
    }
    let Reader { heads, ends, types, .. } = reader;
    comments(text, &lexed, (&heads, &ends), &mut pous);
    Ok((pous, types))
}

struct Reader<'t> {
    text: &'t str,
    cursor: Cursor<'t>,
    /// Of what comments can belong to: from its beginning to the end of its head.
    heads: Vec<(Span, Item)>,
    /// Of each program.
    ends: Vec<usize>,
    types: Vec<Type>,
}

/// By number, in the program of that number.
#[derive(Clone, Copy, Debug)]
enum Item {
    Pou,
    Variable(usize),
    Step(usize),
    Transition(usize),
    Action(usize),
}

const KINDS: [(&str, &str); 3] =
    [("program", "end_program"), ("function_block", "end_function_block"), ("function", "end_function")];

impl Reader<'_> {
    /// What stands beside programs: types, which are kept, configurations and global variables.
    fn others(&mut self) -> bool {
        if self.cursor.word("type") {
            self.types.extend(types::textual(&mut self.cursor, self.text));
            return true;
        }
        let all = [("configuration", "end_configuration"), ("var_global", "end_var")];
        let Some((_, end)) = all.into_iter().find(|(word, _)| self.cursor.word(word)) else { return false };
        while self.cursor.peek().is_some() && !self.cursor.word(end) {
            self.cursor.at += 1;
        }
        true
    }

    fn pou(&mut self) -> Result<Pou, Wrong> {
        let start = self.cursor.here();
        let Some((_, end)) = KINDS.into_iter().find(|(word, _)| self.cursor.word(word)) else {
            return self.cursor.wrong("`PROGRAM`, `FUNCTION_BLOCK` or `FUNCTION`");
        };
        let at = self.cursor.here();
        let mut pou = Pou { name: self.cursor.name()?, at: at.clone(), ..Pou::default() };
        if self.cursor.sign(":") {
            pou.returns = Some(self.cursor.name()?);
        }
        self.heads.push((start.start..self.cursor.before().end, Item::Pou));
        while !self.cursor.word(end) {
            if self.cursor.peek().is_none() {
                return self.cursor.wrong(&format!("`{}`", end.to_uppercase()));
            }
            self.part(&mut pou, end)?;
        }
        Ok(pou)
    }

    fn part(&mut self, pou: &mut Pou, end: &str) -> Result<(), Wrong> {
        let start = self.cursor.here().start;
        let sections = [
            ("var_input", Section::Input),
            ("var_output", Section::Output),
            ("var_in_out", Section::InOut),
            ("var_external", Section::External),
            ("var_temp", Section::Local),
            ("var", Section::Local),
        ];
        if let Some((_, section)) = sections.into_iter().find(|(word, _)| self.cursor.word(word)) {
            return self.variables(pou, section);
        }
        if self.cursor.is_word("initial_step") || self.cursor.is_word("step") {
            let step = self.step()?;
            self.heads.push((start..self.cursor.before().end.min(step.at.end + 1), Item::Step(pou.steps.len())));
            pou.steps.push(step);
        } else if self.cursor.word("transition") {
            let transition = self.transition()?;
            self.heads.push((start..transition.at.end, Item::Transition(pou.transitions.len())));
            pou.transitions.push(transition);
        } else if self.cursor.word("action") {
            let name = self.cursor.name()?;
            // Some write no colon.
            self.cursor.sign(":");
            self.heads.push((start..self.cursor.before().end, Item::Action(pou.actions.len())));
            let body = self.until("end_action")?;
            pou.actions.push(Action { name, note: String::new(), body });
        } else {
            // What is no chart: a function, or a function block of structured text.
            let begin = self.cursor.here().start;
            while self.cursor.peek().is_some() && !self.cursor.is_word(end) {
                self.cursor.at += 1;
            }
            // With comments that stand after the last declaration.
            let from = pou.variables.last().map_or(pou.at.end, |variable| variable.at.end);
            pou.body = self.text[from.min(begin)..self.cursor.here().start].trim().to_owned();
        }
        Ok(())
    }

    /// Everything up to a word, which is skipped.
    fn until(&mut self, word: &str) -> Result<Piece, Wrong> {
        let from = self.cursor.before().end;
        while !self.cursor.is_word(word) {
            if self.cursor.peek().is_none() {
                return self.cursor.wrong(&format!("`{}`", word.to_uppercase()));
            }
            self.cursor.at += 1;
        }
        let to = self.cursor.here().start;
        self.cursor.at += 1;
        Ok(Piece { text: self.text[from..to].to_owned(), at: from..to, language: None })
    }

    fn variables(&mut self, pou: &mut Pou, section: Section) -> Result<(), Wrong> {
        let mut constant = false;
        while ["constant", "retain", "non_retain", "persistent"].iter().any(|word| self.cursor.is_word(word)) {
            constant |= self.cursor.is_word("constant");
            self.cursor.at += 1;
        }
        while !self.cursor.word("end_var") {
            let start = self.cursor.here().start;
            let mut names = Vec::new();
            let mut address = None;
            loop {
                names.push((self.cursor.here(), self.cursor.name()?));
                if self.cursor.word("at") {
                    address = Some(self.cursor.name()?);
                }
                if !self.cursor.sign(",") {
                    break;
                }
            }
            self.cursor.need(":")?;
            let (ty, init) = self.ty()?;
            for (at, name) in names {
                self.heads.push((start..self.cursor.before().end, Item::Variable(pou.variables.len())));
                let (ty, init, address) = (ty.clone(), init.clone(), address.clone());
                pou.variables.push(Variable { name, at, section, constant, ty, init, address, note: String::new() });
            }
        }
        Ok(())
    }

    /// A type with the value after it, up to the semicolon.
    fn ty(&mut self) -> Result<(String, Option<Piece>), Wrong> {
        let from = self.cursor.here().start;
        let (mut to, mut init) = (from, None);
        while !self.cursor.sign(";") {
            if self.cursor.peek().is_none() || self.cursor.is_word("end_var") {
                return self.cursor.wrong("`;`");
            }
            if init.is_none() && self.cursor.sign(":=") {
                init = Some(self.cursor.here().start);
                continue;
            }
            if init.is_none() {
                to = self.cursor.here().end;
            }
            self.cursor.at += 1;
        }
        let end = self.cursor.before().start;
        let init = init.map(|from| Piece { text: self.text[from..end].to_owned(), at: from..end, language: None });
        let ty = self.text[from..to].split_whitespace().collect::<Vec<_>>().join(" ");
        Ok((ty, init))
    }

    fn step(&mut self) -> Result<Step, Wrong> {
        let initial = self.cursor.is_word("initial_step");
        self.cursor.at += 1;
        let at = self.cursor.here();
        let name = self.cursor.name()?;
        self.cursor.need(":")?;
        let mut blocks = Vec::new();
        while !self.cursor.word("end_step") {
            let at = self.cursor.here();
            let what = What::Named(self.cursor.name()?);
            let (mut qualifier, mut time) = ("N".to_owned(), None);
            if self.cursor.sign("(") && !self.cursor.sign(")") {
                qualifier = self.cursor.name()?;
                let mut more = Vec::new();
                while self.cursor.sign(",") {
                    let from = self.cursor.here().start;
                    self.cursor.expr()?;
                    more.push(self.text[from..self.cursor.before().end].to_owned());
                }
                // After the time stand indicators, which nothing depends on.
                let has_time = matches!(&*qualifier.to_uppercase(), "L" | "D" | "SD" | "DS" | "SL");
                time = more.into_iter().next().filter(|_| has_time);
                self.cursor.need(")")?;
            }
            self.cursor.need(";")?;
            blocks.push(Block { at, qualifier, time, what });
        }
        Ok(Step { name, at, initial, note: String::new(), within: None, blocks })
    }

    fn steps(&mut self) -> Result<Vec<String>, Wrong> {
        if !self.cursor.sign("(") {
            return Ok(vec![self.cursor.name()?]);
        }
        let mut names = vec![self.cursor.name()?];
        while self.cursor.sign(",") {
            names.push(self.cursor.name()?);
        }
        self.cursor.need(")")?;
        Ok(names)
    }

    fn transition(&mut self) -> Result<Transition, Wrong> {
        let from_here = self.cursor.before().start;
        let named = !self.cursor.is_word("from") && matches!(self.cursor.peek(), Some(Token::Word(_)));
        let name = if named { Some(self.cursor.name()?) } else { None };
        let mut priority = None;
        if self.cursor.sign("(") {
            self.cursor.need_word("priority")?;
            self.cursor.need(":=")?;
            let Some(Token::Int(value)) = self.cursor.peek() else { return self.cursor.wrong("a number") };
            priority = u64::try_from(*value).ok();
            self.cursor.at += 1;
            self.cursor.need(")")?;
        }
        self.cursor.need_word("from")?;
        let from = self.steps()?;
        self.cursor.need_word("to")?;
        let to = self.steps()?;
        let head = self.cursor.before().end;
        // After `:` stands another language.
        let language = if self.cursor.sign(":") { Some("IL, FBD or LD".to_owned()) } else { None };
        if language.is_none() {
            self.cursor.need(":=")?;
        }
        let mut condition = self.until("end_transition")?;
        condition.language = language;
        Ok(Transition { name, at: from_here..head, note: String::new(), priority, from, to, condition })
    }
}

/// A comment belongs to what ends in front of it on its line, else to what begins after it.
fn comments(text: &str, lexed: &Lexed, (heads, ends): (&[(Span, Item)], &[usize]), pous: &mut [Pou]) {
    for (words, at) in &lexed.comments {
        let on_line = |span: &Span| span.end <= at.start && !text[span.end..at.start].contains('\n');
        let before = heads.iter().rposition(|(span, _)| span.end <= at.start);
        let inside = |begin: usize| !ends.iter().any(|end| (at.start..begin).contains(end));
        let after =
            heads.iter().position(|(span, _)| span.start >= at.end).filter(|index| inside(heads[*index].0.start));
        let found = before.filter(|index| on_line(&heads[*index].0)).or(after);
        let Some(index) = found else { continue };
        // What stands in the body of an action stays there.
        let pou = heads[..=index].iter().filter(|(_, item)| matches!(item, Item::Pou)).count().saturating_sub(1);
        let Some(pou) = pous.get_mut(pou) else { continue };
        let bodies = pou.actions.iter().map(|action| &action.body);
        if bodies.into_iter().any(|body| body.at.contains(&at.start)) {
            continue;
        }
        let note = match heads[index].1 {
            Item::Pou => {
                pou.notes.extend(words.lines().map(|line| line.trim().to_owned()));
                continue;
            }
            Item::Variable(number) => &mut pou.variables[number].note,
            Item::Step(number) => &mut pou.steps[number].note,
            Item::Transition(number) => &mut pou.transitions[number].note,
            Item::Action(number) => &mut pou.actions[number].note,
        };
        if !note.is_empty() {
            note.push(' ');
        }
        note.push_str(&words.split_whitespace().collect::<Vec<_>>().join(" "));
    }
}
