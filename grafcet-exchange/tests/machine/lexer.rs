//! Tokens of structured text, as each dialect writes them.

use super::Dialect;

#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Token {
    /// In small letters.
    Word(String),
    Int(i128),
    /// `16#FF`
    Hex(u64),
    /// `2.5E-3`, as its bits.
    Real(u64),
    /// Milliseconds.
    Time(u64),
    Sign(&'static str),
    /// `#name`, of TIA.
    Local(String),
    /// `"name"`, of TIA.
    Quoted(String),
    /// What stands in braces.
    Pragma(String),
}

const SIGNS: [&str; 17] = [":=", "<=", ">=", "<>", "=", "<", ">", "+", "-", "*", "/", "(", ")", ",", ";", ":", "."];

pub(super) fn tokens(text: &str, dialect: Dialect) -> Result<Vec<Token>, String> {
    let mut tokens = Vec::new();
    let mut rest = text;
    loop {
        rest = rest.trim_start();
        let Some(first) = rest.chars().next() else { return Ok(tokens) };
        if let Some(comment) = rest.strip_prefix("//") {
            rest = comment.find('\n').map_or("", |end| &comment[end..]);
        } else if dialect == Dialect::Tia && (first == '#' || first == '"') {
            let inner = &rest[1..];
            let end = inner.find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(inner.len());
            let name = inner[..end].to_lowercase();
            tokens.push(if first == '#' { Token::Local(name) } else { Token::Quoted(name) });
            rest = &inner[end..];
            if first == '"' {
                rest = rest.strip_prefix('"').ok_or_else(|| format!("a quotation mark is missing: {inner}"))?;
            }
        } else if dialect != Dialect::Iec && first == '{' {
            let end = rest.find('}').ok_or("a brace is not closed")?;
            tokens.push(Token::Pragma(rest[1..end].trim().to_owned()));
            rest = &rest[end + 1..];
        } else if dialect == Dialect::Tia && rest.starts_with("REGION ") {
            // Its name goes to the end of the line.
            tokens.push(Token::Word("region".to_owned()));
            rest = rest.find('\n').map_or("", |end| &rest[end..]);
        } else if first.is_ascii_alphabetic() || first == '_' {
            let end = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(rest.len());
            let word = rest[..end].to_lowercase();
            if word == "t" && rest[end..].starts_with('#') {
                let from = end + 1;
                let length = rest[from..].find(|c: char| !c.is_ascii_alphanumeric()).unwrap_or(rest.len() - from);
                tokens.push(Token::Time(time(&rest[from..from + length])?));
                rest = &rest[from + length..];
            } else {
                if word.ends_with('_') || word.contains("__") || word.starts_with('_') {
                    return Err(format!("`{word}` is no identifier"));
                }
                tokens.push(Token::Word(word));
                rest = &rest[end..];
            }
        } else if let Some(end) = real(rest) {
            let number: f64 = rest[..end].parse().map_err(|error| format!("{}: {error}", &rest[..end]))?;
            tokens.push(Token::Real(number.to_bits()));
            rest = &rest[end..];
        } else if let Some(digits) = rest.strip_prefix("16#") {
            let end = digits.find(|c: char| !c.is_ascii_hexdigit()).unwrap_or(digits.len());
            let bits =
                u64::from_str_radix(&digits[..end], 16).map_err(|error| format!("{}: {error}", &digits[..end]))?;
            tokens.push(Token::Hex(bits));
            rest = &digits[end..];
        } else if first.is_ascii_digit() {
            let end = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
            tokens.push(Token::Int(rest[..end].parse().map_err(|error| format!("{}: {error}", &rest[..end]))?));
            rest = &rest[end..];
        } else if let Some(sign) = SIGNS.into_iter().find(|sign| rest.starts_with(*sign)) {
            tokens.push(Token::Sign(sign));
            rest = &rest[sign.len()..];
        } else {
            return Err(format!("`{first}` is no sign of structured text"));
        }
    }
}

/// Where a real literal ends: `integer . integer [E [+|-] integer]`.
fn real(text: &str) -> Option<usize> {
    let digits = |from: usize| {
        let end = text[from..].find(|c: char| !c.is_ascii_digit()).map_or(text.len(), |end| from + end);
        (end > from).then_some(end)
    };
    let point = digits(0)?;
    if !text[point..].starts_with('.') {
        return None;
    }
    let end = digits(point + 1)?;
    if !text[end..].starts_with(['E', 'e']) {
        return Some(end);
    }
    let sign = usize::from(text[end + 1..].starts_with(['+', '-']));
    digits(end + 1 + sign)
}

/// `1h30m`: from long to short units, each once.
fn time(text: &str) -> Result<u64, String> {
    const UNITS: [(&str, u64); 5] = [("d", 86_400_000), ("h", 3_600_000), ("m", 60_000), ("s", 1_000), ("ms", 1)];
    let (mut ms, mut rest, mut next) = (0, text, 0);
    while !rest.is_empty() {
        let digits = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
        let number: u64 = rest[..digits].parse().map_err(|error| format!("T#{text}: {error}"))?;
        rest = &rest[digits..];
        let letters = rest.find(|c: char| c.is_ascii_digit()).unwrap_or(rest.len());
        let unit = rest[..letters].to_lowercase();
        rest = &rest[letters..];
        let place = UNITS.iter().position(|(name, _)| *name == unit).filter(|place| *place >= next);
        let place = place.ok_or_else(|| format!("T#{text} is no time"))?;
        ms += number * UNITS[place].1;
        next = place + 1;
    }
    if text.is_empty() { Err("T# without a time".to_owned()) } else { Ok(ms) }
}
