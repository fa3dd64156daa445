//! Expressions and statements of structured text.

use super::Wrong;
use super::lexer::{Lexed, Token, lex};
use super::source::{Piece, Span};

#[derive(Clone, PartialEq, Debug)]
pub(super) enum Expr {
    Bool(bool),
    Int(i128),
    Real(String),
    /// In nanoseconds.
    Time(u64),
    Name(String),
    /// `step.X`, and the value of an enum, `Mode.Auto`
    Member(String, String),
    /// A bit of a word, `w.3`
    Bit(String, i128),
    /// `Mode#Auto`
    Typed(String, String),
    Call(String, Arguments),
    Not(Box<Expr>),
    Minus(Box<Expr>),
    Binary(Op, Box<Expr>, Box<Expr>),
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Op {
    Or,
    Xor,
    And,
    Equal,
    Differs,
    Less,
    AtMost,
    More,
    AtLeast,
    Add,
    Sub,
    Mul,
    Div,
    Mod,
}

/// What an arm of `CASE` stands for.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Label {
    One(Expr),
    /// With both ends.
    Range(Expr, Expr),
}

/// Of a call: by name, or by place.
pub(super) type Arguments = Vec<(Option<String>, Expr)>;

/// An arm of `CASE`.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Arm {
    pub(super) labels: Vec<Label>,
    pub(super) body: Vec<Statement>,
}

#[derive(Clone, PartialEq, Debug)]
pub(super) enum Statement {
    Assign(String, Expr),
    /// Of a function block.
    Call(String, Arguments),
    If(Vec<(Expr, Vec<Statement>)>, Vec<Statement>),
    /// The last body is that of `ELSE`.
    Case(Expr, Vec<Arm>, Vec<Statement>),
    /// A variable, its first and its last value, and what it is counted by.
    For(String, [Expr; 2], Option<Expr>, Vec<Statement>),
    While(Expr, Vec<Statement>),
    /// With the condition that ends it.
    Repeat(Vec<Statement>, Expr),
    Exit,
    Continue,
}

impl Statement {
    pub(super) fn bodies_mut(&mut self) -> Vec<&mut Vec<Statement>> {
        match self {
            Self::Assign(..) | Self::Call(..) | Self::Exit | Self::Continue => Vec::new(),
            Self::If(branches, otherwise) => branches.iter_mut().map(|(_, then)| then).chain([otherwise]).collect(),
            Self::Case(_, arms, otherwise) => arms.iter_mut().map(|arm| &mut arm.body).chain([otherwise]).collect(),
            Self::For(.., body) | Self::While(_, body) | Self::Repeat(body, _) => vec![body],
        }
    }

    /// The bodies in it.
    pub(super) fn bodies(&self) -> Vec<&Vec<Statement>> {
        match self {
            Self::Assign(..) | Self::Call(..) | Self::Exit | Self::Continue => Vec::new(),
            Self::If(branches, otherwise) => branches.iter().map(|(_, then)| then).chain([otherwise]).collect(),
            Self::Case(_, arms, otherwise) => arms.iter().map(|arm| &arm.body).chain([otherwise]).collect(),
            Self::For(.., body) | Self::While(_, body) | Self::Repeat(body, _) => vec![body],
        }
    }
}

/// From weak to strong.
const LEVELS: [&[(&str, Op)]; 7] = [
    &[("or", Op::Or)],
    &[("xor", Op::Xor)],
    &[("and", Op::And), ("&", Op::And)],
    &[("=", Op::Equal), ("<>", Op::Differs), ("==", Op::Equal), ("!=", Op::Differs)],
    &[("<", Op::Less), ("<=", Op::AtMost), (">", Op::More), (">=", Op::AtLeast)],
    &[("+", Op::Add), ("-", Op::Sub)],
    &[("*", Op::Mul), ("/", Op::Div), ("mod", Op::Mod)],
];

/// Nothing that people write is nested so deep.
pub(super) const DEEPEST: usize = 100;

/// An expression, with or without what ends a statement after it.
pub(super) fn expression(text: &Piece) -> Result<Expr, Wrong> {
    let lexed = lex(&text.text, text.at.start)?;
    let mut cursor = Cursor::new(&lexed, text.at.clone());
    // Some tools write `:=` in front of a condition.
    cursor.sign(":=");
    let expr = cursor.expr()?;
    cursor.sign(";");
    cursor.end()?;
    Ok(expr)
}

pub(super) fn statements(text: &Piece) -> Result<Vec<Statement>, Wrong> {
    let lexed = lex(&text.text, text.at.start)?;
    let mut cursor = Cursor::new(&lexed, text.at.clone());
    let statements = cursor.statements()?;
    cursor.end()?;
    Ok(statements)
}

/// A place among tokens.
pub(super) struct Cursor<'t> {
    tokens: &'t [(Token, Span)],
    pub(super) at: usize,
    pub(super) depth: usize,
    /// Of all of it, where there is no token.
    whole: Span,
}

impl<'t> Cursor<'t> {
    pub(super) fn new(lexed: &'t Lexed, whole: Span) -> Self {
        Self { tokens: &lexed.tokens, at: 0, depth: 0, whole }
    }

    pub(super) fn peek(&self) -> Option<&'t Token> {
        self.tokens.get(self.at).map(|(token, _)| token)
    }

    /// Of the next token, or after the last one.
    pub(super) fn here(&self) -> Span {
        let last = || self.tokens.last().map_or(self.whole.clone(), |(_, span)| span.end..span.end);
        self.tokens.get(self.at).map_or_else(last, |(_, span)| span.clone())
    }

    /// Of the last token.
    pub(super) fn before(&self) -> Span {
        self.at.checked_sub(1).and_then(|at| self.tokens.get(at)).map_or_else(|| self.here(), |(_, span)| span.clone())
    }

    pub(super) fn wrong<T>(&self, wanted: &str) -> Result<T, Wrong> {
        let found = match self.peek() {
            None => "the end".to_owned(),
            Some(Token::Word(word)) => format!("`{word}`"),
            Some(Token::Sign(sign)) => format!("`{sign}`"),
            Some(Token::Text(text)) => format!("the text '{text}'"),
            Some(Token::Int(number)) => format!("`{number}`"),
            Some(Token::Real(number)) => format!("`{number}`"),
            Some(Token::Time(_)) => "a time".to_owned(),
        };
        Err(Wrong { at: self.here(), message: format!("expected {wanted}, found {found}") })
    }

    pub(super) fn is_word(&self, word: &str) -> bool {
        matches!(self.peek(), Some(Token::Word(found)) if found.eq_ignore_ascii_case(word))
    }

    pub(super) fn word(&mut self, word: &str) -> bool {
        let found = self.is_word(word);
        self.at += usize::from(found);
        found
    }

    pub(super) fn sign(&mut self, sign: &str) -> bool {
        let found = matches!(self.peek(), Some(Token::Sign(found)) if *found == sign);
        self.at += usize::from(found);
        found
    }

    pub(super) fn need_word(&mut self, word: &str) -> Result<(), Wrong> {
        if self.word(word) { Ok(()) } else { self.wrong(&format!("`{word}`")) }
    }

    pub(super) fn need(&mut self, sign: &str) -> Result<(), Wrong> {
        if self.sign(sign) { Ok(()) } else { self.wrong(&format!("`{sign}`")) }
    }

    pub(super) fn name(&mut self) -> Result<String, Wrong> {
        match self.peek() {
            Some(Token::Word(word)) => {
                self.at += 1;
                Ok(word.clone())
            }
            _ => self.wrong("a name"),
        }
    }

    pub(super) fn end(&self) -> Result<(), Wrong> {
        if self.peek().is_none() { Ok(()) } else { self.wrong("the end") }
    }

    pub(super) fn expr(&mut self) -> Result<Expr, Wrong> {
        self.level(0)
    }

    fn level(&mut self, level: usize) -> Result<Expr, Wrong> {
        let Some(operators) = LEVELS.get(level) else { return self.unary() };
        let mut left = self.level(level + 1)?;
        let mut long = 0;
        loop {
            let found = operators.iter().find(|(word, _)| {
                if word.chars().all(char::is_alphabetic) { self.word(word) } else { self.sign(word) }
            });
            let Some((_, op)) = found else { return Ok(left) };
            long += 1;
            if long > 20 * DEEPEST {
                return self.wrong("an expression that is shorter");
            }
            left = Expr::Binary(*op, Box::new(left), Box::new(self.level(level + 1)?));
        }
    }

    fn unary(&mut self) -> Result<Expr, Wrong> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return self.wrong("an expression that is nested less deep");
        }
        let expr = if self.word("not") {
            Expr::Not(Box::new(self.unary()?))
        } else if self.sign("-") {
            match self.unary()? {
                Expr::Int(value) => Expr::Int(-value),
                inner => Expr::Minus(Box::new(inner)),
            }
        } else if self.sign("(") {
            let inner = self.expr()?;
            self.need(")")?;
            inner
        } else {
            self.primary()?
        };
        self.depth -= 1;
        Ok(expr)
    }

    fn primary(&mut self) -> Result<Expr, Wrong> {
        let value = match self.peek() {
            Some(Token::Int(value)) => Expr::Int(*value),
            Some(Token::Real(value)) => Expr::Real(value.clone()),
            Some(Token::Time(value)) => Expr::Time(*value),
            Some(Token::Word(_)) => {
                let name = self.name()?;
                return self.named(name);
            }
            _ => return self.wrong("a value"),
        };
        self.at += 1;
        Ok(value)
    }

    fn named(&mut self, name: String) -> Result<Expr, Wrong> {
        if name.eq_ignore_ascii_case("true") {
            return Ok(Expr::Bool(true));
        }
        if name.eq_ignore_ascii_case("false") {
            return Ok(Expr::Bool(false));
        }
        if self.sign("(") {
            return Ok(Expr::Call(name, self.arguments()?));
        }
        if self.sign(".") {
            if let Some(Token::Int(bit)) = self.peek() {
                self.at += 1;
                return Ok(Expr::Bit(name, *bit));
            }
            return Ok(Expr::Member(name, self.name()?));
        }
        Ok(match name.split_once('#') {
            Some((ty, value)) => Expr::Typed(ty.to_owned(), value.to_owned()),
            None => Expr::Name(name),
        })
    }

    /// After the parenthesis.
    fn arguments(&mut self) -> Result<Arguments, Wrong> {
        let at = self.here();
        let (arguments, outputs) = self.arguments_and_outputs()?;
        if outputs.is_empty() {
            return Ok(arguments);
        }
        Err(Wrong { at, message: "what a call writes with `=>` within an expression is not translated".to_owned() })
    }

    /// The same, and by the name of an output what it is written to.
    pub(super) fn arguments_and_outputs(&mut self) -> Result<(Arguments, Vec<(String, String)>), Wrong> {
        let (mut arguments, mut outputs) = (Vec::new(), Vec::new());
        while !self.sign(")") {
            let next = self.tokens.get(self.at + 1).map(|(token, _)| token);
            if next == Some(&Token::Sign("=>")) {
                let name = self.name()?;
                self.need("=>")?;
                // An output that is not connected.
                if !matches!(self.peek(), Some(Token::Sign("," | ")"))) {
                    outputs.push((name, self.name()?));
                }
            } else {
                let named = next == Some(&Token::Sign(":="));
                let name = if named {
                    let name = self.name()?;
                    self.need(":=")?;
                    Some(name)
                } else {
                    None
                };
                arguments.push((name, self.expr()?));
            }
            if !self.sign(",") {
                self.need(")")?;
                break;
            }
        }
        Ok((arguments, outputs))
    }

    /// Whether an arm of `CASE` begins here: `1, 3..5:`, `Mode.Auto:`.
    pub(super) fn is_label(&self) -> bool {
        let token = |at: usize| self.tokens.get(at).map(|(token, _)| token);
        let sign = |at: usize, sign: &'static str| token(at) == Some(&Token::Sign(sign));
        let mut at = self.at;
        loop {
            at += usize::from(sign(at, "-"));
            match token(at) {
                Some(Token::Word(_)) if sign(at + 1, ".") => at += 3,
                Some(Token::Word(_) | Token::Int(_)) => at += 1,
                _ => return false,
            }
            if !sign(at, ",") && !sign(at, "..") {
                return sign(at, ":");
            }
            at += 1;
        }
    }
}
