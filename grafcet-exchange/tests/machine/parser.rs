//! Functions, function blocks, statements and expressions.

use super::lexer::{Token, tokens};
use super::{Dialect, Real, Value};

/// A function or a function block.
#[derive(Clone, Debug)]
pub(crate) struct Unit {
    pub(crate) name: String,
    /// Of a function what it returns.
    pub(crate) ty: Option<String>,
    pub(crate) variables: Vec<Declared>,
    pub(crate) body: Vec<Statement>,
}

#[derive(Clone, Debug)]
pub(crate) struct Declared {
    pub(crate) name: String,
    pub(crate) ty: String,
    pub(crate) init: Option<Expression>,
    pub(crate) is_input: bool,
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Statement {
    Assign(String, Expression),
    Call(String, Vec<(String, Expression)>),
    If(Vec<(Expression, Vec<Statement>)>, Vec<Statement>),
    Case(Expression, Vec<(i128, Vec<Statement>)>),
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Expression {
    Literal(Value),
    Name(String),
    Member(String, String),
    Call(String, Vec<(String, Expression)>),
    Not(Box<Expression>),
    Minus(Box<Expression>),
    Binary(&'static str, Box<Expression>, Box<Expression>),
    /// `TO_INT(…)`, of CODESYS.
    To(String, Box<Expression>),
    /// `TIME_TO_DINT(…)`
    Milliseconds(Box<Expression>),
    /// `UINT_TO_WORD(…)`
    Converted(String, String, Box<Expression>),
    /// `SHL`, `SHR`, `MIN`, `MAX`, `SEL`.
    Function(&'static str, Vec<Expression>),
}

/// Words that are no names.
const KEYWORDS: [&str; 24] = [
    "and",
    "or",
    "xor",
    "not",
    "mod",
    "true",
    "false",
    "if",
    "then",
    "elsif",
    "else",
    "end_if",
    "case",
    "of",
    "end_case",
    "var",
    "var_input",
    "var_output",
    "end_var",
    "function",
    "function_block",
    "end_function",
    "end_function_block",
    "ton",
];

/// Functions of the standard, each with the names of its inputs.
const FUNCTIONS: [(&str, &[&str]); 5] = [
    ("shl", &["in", "n"]),
    ("shr", &["in", "n"]),
    ("min", &["in1", "in2"]),
    ("max", &["in1", "in2"]),
    ("sel", &["g", "in0", "in1"]),
];

/// From weak to strong.
const LEVELS: [&[&str]; 7] =
    [&["or"], &["xor"], &["and"], &["=", "<>"], &["<", ">", "<=", ">="], &["+", "-"], &["*", "/", "mod"]];

pub(crate) fn units(text: &str, dialect: Dialect) -> Result<Vec<Unit>, String> {
    let mut parser = Parser { tokens: tokens(text, dialect)?, at: 0, dialect };
    let mut units = Vec::new();
    while parser.at < parser.tokens.len() {
        units.push(parser.unit()?);
    }
    Ok(units)
}

/// Statements alone, in the language of the standard.
pub(crate) fn statements(text: &str) -> Result<Vec<Statement>, String> {
    let dialect = Dialect::Iec;
    let mut parser = Parser { tokens: tokens(text, dialect)?, at: 0, dialect };
    let statements = parser.statements(&[])?;
    if parser.at == parser.tokens.len() { Ok(statements) } else { Err(parser.wrong("a statement")) }
}

struct Parser {
    tokens: Vec<Token>,
    at: usize,
    dialect: Dialect,
}

impl Parser {
    fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.at)
    }

    fn is_word(&self, word: &str) -> bool {
        matches!(self.peek(), Some(Token::Word(found)) if found == word)
    }

    fn wrong(&self, wanted: &str) -> String {
        format!(
            "token {}: {wanted} is expected, found {:?}",
            self.at,
            &self.tokens[self.at..self.tokens.len().min(self.at + 5)]
        )
    }

    fn word(&mut self, word: &str) -> bool {
        let found = self.is_word(word);
        self.at += usize::from(found);
        found
    }

    fn sign(&mut self, sign: &str) -> bool {
        let found = matches!(self.peek(), Some(Token::Sign(found)) if *found == sign);
        self.at += usize::from(found);
        found
    }

    fn need_word(&mut self, word: &str) -> Result<(), String> {
        if self.word(word) { Ok(()) } else { Err(self.wrong(word)) }
    }

    fn need(&mut self, sign: &str) -> Result<(), String> {
        if self.sign(sign) { Ok(()) } else { Err(self.wrong(sign)) }
    }

    fn name(&mut self) -> Result<String, String> {
        match self.peek() {
            Some(Token::Word(word)) if !KEYWORDS.contains(&word.as_str()) => {
                let word = word.clone();
                self.at += 1;
                Ok(word)
            }
            _ => Err(self.wrong("a name")),
        }
    }

    /// Of a block, or of what stands beside it.
    fn outer(&mut self) -> Result<String, String> {
        match (self.dialect, self.peek()) {
            (Dialect::Tia, Some(Token::Quoted(name))) => {
                let name = name.clone();
                self.at += 1;
                Ok(name)
            }
            (Dialect::Tia, _) => Err(self.wrong("a name in quotation marks")),
            _ => self.name(),
        }
    }

    /// Of what belongs to the block.
    fn inner(&mut self) -> Result<String, String> {
        match (self.dialect, self.peek()) {
            (Dialect::Tia, Some(Token::Local(name))) => {
                let name = name.clone();
                self.at += 1;
                Ok(name)
            }
            (Dialect::Tia, _) => Err(self.wrong("a name with #")),
            _ => self.name(),
        }
    }

    fn pragma(&mut self, text: &str) -> bool {
        let found = matches!(self.peek(), Some(Token::Pragma(found)) if found == text);
        self.at += usize::from(found);
        found
    }

    fn unit(&mut self) -> Result<Unit, String> {
        let is_function = self.word("function");
        if !is_function {
            self.need_word("function_block")?;
        }
        let name = self.outer()?;
        let mut ty = None;
        if is_function {
            self.need(":")?;
            ty = Some(self.ty()?);
        }
        if self.dialect == Dialect::Tia {
            if !self.pragma("S7_Optimized_Access := 'TRUE'") || !self.word("version") {
                return Err(self.wrong("the properties of a block"));
            }
            self.need(":")?;
            if !matches!(self.peek(), Some(Token::Real(_))) {
                return Err(self.wrong("a version"));
            }
            self.at += 1;
        }
        let mut variables = Vec::new();
        loop {
            let is_input = self.is_word("var_input");
            if !is_input && !self.is_word("var_output") && !self.is_word("var") {
                break;
            }
            self.at += 1;
            while !self.word("end_var") {
                variables.push(self.variable(is_input)?);
            }
        }
        if self.dialect == Dialect::Tia {
            self.need_word("begin")?;
        }
        let end = if is_function { "end_function" } else { "end_function_block" };
        let body = self.statements(&[end])?;
        self.need_word(end)?;
        Ok(Unit { name, ty, variables, body })
    }

    fn variable(&mut self, is_input: bool) -> Result<Declared, String> {
        let name = self.name()?;
        let is_timer = self.pragma("InstructionName := 'TON_TIME'; LibVersion := '1.0'");
        self.need(":")?;
        let ty = self.ty()?;
        if self.dialect == Dialect::Tia && is_timer != (ty == "ton") {
            return Err(self.wrong("the instruction of a timer, and of nothing else"));
        }
        let init = if self.sign(":=") { Some(self.expression(0)?) } else { None };
        self.need(";")?;
        Ok(Declared { name, ty, init, is_input })
    }

    fn ty(&mut self) -> Result<String, String> {
        if self.dialect == Dialect::Tia {
            if self.word("ton_time") {
                return Ok("ton".to_owned());
            }
            if let Some(Token::Quoted(_)) = self.peek() {
                return self.outer();
            }
            return self.name();
        }
        if self.word("ton") { Ok("ton".to_owned()) } else { self.name() }
    }

    fn statements(&mut self, ends: &[&str]) -> Result<Vec<Statement>, String> {
        let mut statements = Vec::new();
        while let Some(token) = self.peek() {
            if ends.iter().any(|end| self.is_word(end)) || ends.contains(&"end_case") && matches!(token, Token::Int(_))
            {
                break;
            }
            if self.sign(";") {
                continue;
            }
            if self.region(&mut statements)? {
                continue;
            }
            statements.push(self.statement()?);
            self.need(";")?;
        }
        Ok(statements)
    }

    /// What stands in a region stands where it is; a warning does nothing.
    fn region(&mut self, statements: &mut Vec<Statement>) -> Result<bool, String> {
        match (self.dialect, self.peek().cloned()) {
            (Dialect::Tia, Some(Token::Word(word))) if word == "region" => {
                self.at += 1;
                statements.extend(self.statements(&["end_region"])?);
                self.need_word("end_region")?;
                Ok(true)
            }
            (Dialect::Codesys, Some(Token::Pragma(pragma))) if pragma.starts_with("region \"") => {
                self.at += 1;
                loop {
                    if self.pragma("endregion") {
                        return Ok(true);
                    }
                    if self.sign(";") {
                        continue;
                    }
                    statements.push(self.statement()?);
                    self.need(";")?;
                }
            }
            (Dialect::Codesys, Some(Token::Pragma(pragma))) if pragma.starts_with("warning '") => {
                self.at += 1;
                Ok(true)
            }
            _ => Ok(false),
        }
    }

    fn statement(&mut self) -> Result<Statement, String> {
        if self.word("if") {
            let mut branches = Vec::new();
            loop {
                let condition = self.expression(0)?;
                self.need_word("then")?;
                branches.push((condition, self.statements(&["elsif", "else", "end_if"])?));
                if !self.word("elsif") {
                    break;
                }
            }
            let otherwise = if self.word("else") { self.statements(&["end_if"])? } else { Vec::new() };
            self.need_word("end_if")?;
            return Ok(Statement::If(branches, otherwise));
        }
        if self.word("case") {
            let on = self.expression(0)?;
            self.need_word("of")?;
            let mut arms = Vec::new();
            while !self.word("end_case") {
                let Some(Token::Int(number)) = self.peek().cloned() else { return Err(self.wrong("a number")) };
                self.at += 1;
                self.need(":")?;
                arms.push((number, self.statements(&["end_case"])?));
            }
            return Ok(Statement::Case(on, arms));
        }
        let name = self.inner()?;
        if self.sign("(") {
            return Ok(Statement::Call(name, self.arguments()?));
        }
        self.need(":=")?;
        Ok(Statement::Assign(name, self.expression(0)?))
    }

    fn arguments(&mut self) -> Result<Vec<(String, Expression)>, String> {
        let mut arguments = Vec::new();
        while !self.sign(")") {
            if !arguments.is_empty() {
                self.need(",")?;
            }
            let name = self.name()?;
            self.need(":=")?;
            arguments.push((name, self.expression(0)?));
        }
        Ok(arguments)
    }

    fn expression(&mut self, level: usize) -> Result<Expression, String> {
        let Some(operators) = LEVELS.get(level) else { return self.unary() };
        let mut left = self.expression(level + 1)?;
        loop {
            let found = operators.iter().copied().find(|operator| match self.peek() {
                Some(Token::Word(word)) => word == operator,
                Some(Token::Sign(sign)) => sign == operator,
                _ => false,
            });
            let Some(operator) = found else { return Ok(left) };
            self.at += 1;
            left = Expression::Binary(operator, Box::new(left), Box::new(self.expression(level + 1)?));
        }
    }

    fn unary(&mut self) -> Result<Expression, String> {
        if self.word("not") {
            return Ok(Expression::Not(Box::new(self.unary()?)));
        }
        if self.sign("-") {
            return Ok(Expression::Minus(Box::new(self.unary()?)));
        }
        if self.sign("(") {
            let inner = self.expression(0)?;
            self.need(")")?;
            return Ok(inner);
        }
        for (word, value) in [("true", true), ("false", false)] {
            if self.word(word) {
                return Ok(Expression::Literal(Value::Bool(value)));
            }
        }
        let literal = match self.peek() {
            Some(Token::Int(number)) => Some(Value::Int(*number)),
            Some(Token::Hex(bits)) => Some(Value::Bits(None, *bits)),
            Some(Token::Time(ms)) => Some(Value::Time(*ms)),
            Some(Token::Real(bits)) => Some(Value::Real(Real::new(f64::from_bits(*bits), None))),
            _ => None,
        };
        if let Some(value) = literal {
            self.at += 1;
            return Ok(Expression::Literal(value));
        }
        if let (Dialect::Tia, Some(Token::Quoted(_))) = (self.dialect, self.peek()) {
            let name = self.outer()?;
            self.need("(")?;
            return Ok(Expression::Call(name, self.arguments()?));
        }
        if let Some(standard) = self.standard()? {
            return Ok(standard);
        }
        let name = self.inner()?;
        if self.sign(".") {
            return Ok(Expression::Member(name, self.name()?));
        }
        if self.sign("(") {
            return Ok(Expression::Call(name, self.arguments()?));
        }
        Ok(Expression::Name(name))
    }

    /// A conversion or a function of the standard.
    fn standard(&mut self) -> Result<Option<Expression>, String> {
        let Some(Token::Word(word)) = self.peek().cloned() else { return Ok(None) };
        if let Some((function, inputs)) = FUNCTIONS.into_iter().find(|(name, _)| *name == word) {
            self.at += 1;
            let mut given = Vec::new();
            for (index, input) in inputs.iter().enumerate() {
                self.need(if index == 0 { "(" } else { "," })?;
                given.push(self.input(input)?);
            }
            self.need(")")?;
            return Ok(Some(Expression::Function(function, given)));
        }
        let is_bits = |name: &str| super::bits::length(name).is_some();
        let parts = word.split_once("_to_").filter(|(from, to)| is_bits(from) != is_bits(to) || word == "time_to_dint");
        let narrow = word.strip_prefix("to_").filter(|_| self.dialect == Dialect::Codesys);
        if parts.is_none() && narrow.is_none() {
            return Ok(None);
        }
        self.at += 1;
        self.need("(")?;
        let inner = Box::new(self.expression(0)?);
        self.need(")")?;
        Ok(Some(match (parts, narrow) {
            (_, Some(ty)) => Expression::To(ty.to_owned(), inner),
            (Some(("time", _)) | None, _) => Expression::Milliseconds(inner),
            (Some((from, to)), _) => Expression::Converted(from.to_owned(), to.to_owned(), inner),
        }))
    }

    /// An input of such a function: TIA wants its name, the others have it by its place.
    fn input(&mut self, name: &str) -> Result<Expression, String> {
        if self.dialect == Dialect::Tia {
            self.need_word(name)?;
            self.need(":=")?;
        }
        self.expression(0)
    }
}
