//! Elements of XML, as text.

/// An element with attributes, and with words or children in it.
#[derive(Clone, Debug)]
pub(super) struct Element {
    name: String,
    attributes: Vec<(String, String)>,
    words: Option<String>,
    children: Vec<Element>,
}

impl Element {
    pub(super) fn new(name: &str) -> Self {
        Self { name: name.to_owned(), attributes: Vec::new(), words: None, children: Vec::new() }
    }

    /// One attribute more.
    pub(super) fn with(mut self, name: &str, value: impl std::fmt::Display) -> Self {
        self.attributes.push((name.to_owned(), format!("{value}")));
        self
    }

    pub(super) fn words(self, words: impl Into<String>) -> Self {
        Self { words: Some(words.into()), ..self }
    }

    /// One child more.
    pub(super) fn child(mut self, child: Self) -> Self {
        self.children.push(child);
        self
    }

    pub(super) fn children(mut self, children: impl IntoIterator<Item = Self>) -> Self {
        self.children.extend(children);
        self
    }

    pub(super) fn text(&self) -> String {
        let mut text = String::new();
        self.write(&mut text, 0);
        text
    }

    fn write(&self, text: &mut String, depth: usize) {
        let indent = "  ".repeat(depth);
        text.push_str(&indent);
        text.push('<');
        text.push_str(&self.name);
        for (name, value) in &self.attributes {
            text.extend([" ", name, "=\"", &escaped(value), "\""]);
        }
        match &self.words {
            Some(words) => text.extend([">", &escaped(words), "</", &self.name, ">\n"]),
            None if self.children.is_empty() => text.push_str("/>\n"),
            None => {
                text.push_str(">\n");
                for child in &self.children {
                    child.write(text, depth + 1);
                }
                text.extend([&*indent, "</", &self.name, ">\n"]);
            }
        }
    }
}

/// Without what has a meaning in XML, and without what it does not have at all.
fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for letter in text.chars() {
        match letter {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\n' | '\t' => escaped.push(letter),
            _ if letter.is_control() || matches!(letter, '\u{fffe}' | '\u{ffff}') => escaped.push(' '),
            _ => escaped.push(letter),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::Element;

    #[test]
    fn what_has_a_meaning_is_escaped() {
        let element = Element::new("a").with("b", "\"<&").child(Element::new("c").words("x < y\u{0}"));
        assert_eq!(element.text(), "<a b=\"&quot;&lt;&amp;\">\n  <c>x &lt; y </c>\n</a>\n");
    }
}
