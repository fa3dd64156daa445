//! Texts of expressions, with parentheses where they need them.

/// How strongly operators hold together.
pub(crate) mod strength {
    pub(crate) const OR: u8 = 1;
    pub(crate) const XOR: u8 = 2;
    pub(crate) const AND: u8 = 3;
    pub(crate) const EQUAL: u8 = 4;
    pub(crate) const ORDER: u8 = 5;
    pub(crate) const SUM: u8 = 6;
    pub(crate) const PRODUCT: u8 = 7;
    pub(crate) const UNARY: u8 = 9;
    pub(crate) const WORD: u8 = 10;
}

/// A text and how strongly it holds together.
#[derive(Clone)]
pub(crate) struct Text {
    pub(crate) text: String,
    pub(crate) strength: u8,
}

impl Text {
    pub(crate) fn word(text: impl Into<String>) -> Self {
        Self { text: text.into(), strength: strength::WORD }
    }

    /// A comparison.
    pub(crate) fn order(text: impl Into<String>) -> Self {
        Self { text: text.into(), strength: strength::ORDER }
    }

    /// In parentheses where what is around it holds more strongly.
    pub(crate) fn within(self, strength: u8) -> String {
        if self.strength < strength { format!("({})", self.text) } else { self.text }
    }
}

/// All of them; `TRUE` of none.
pub(crate) fn all(parts: Vec<Text>) -> Text {
    joined(parts, "AND", strength::AND, "TRUE")
}

/// One of them; `FALSE` of none.
pub(crate) fn any(parts: Vec<Text>) -> Text {
    joined(parts, "OR", strength::OR, "FALSE")
}

pub(crate) fn not(part: Text) -> Text {
    Text { text: format!("NOT {}", part.within(strength::UNARY)), strength: strength::UNARY }
}

fn joined(parts: Vec<Text>, word: &str, strength: u8, none: &str) -> Text {
    let parts: Vec<Text> = parts.into_iter().filter(|part| part.text != neutral(word)).collect();
    if parts.len() < 2 {
        return parts.into_iter().next().unwrap_or_else(|| Text::word(none));
    }
    let parts: Vec<String> = parts.into_iter().map(|part| part.within(strength)).collect();
    Text { text: parts.join(&format!(" {word} ")), strength }
}

fn neutral(word: &str) -> &'static str {
    if word == "AND" { "TRUE" } else { "FALSE" }
}
