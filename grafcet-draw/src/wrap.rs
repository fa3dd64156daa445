//! Texts in squares.

use crate::wording::NAME;

/// How many squares a text takes. Characters of the wide scripts take two.
pub(crate) fn width(text: &str) -> i32 {
    let squares = text.chars().map(|c| if c >= '\u{1100}' && !('\u{2000}'..'\u{2e80}').contains(&c) { 2 } else { 1 });
    squares.sum()
}

/// A text in lines of at most `width_limit` squares, broken at blanks, but for longer words; what is beyond `most` lines is
/// an ellipsis, unless it is one line, which takes no more room. One line stays one.
pub(crate) fn wrap(text: &str, width_limit: i32, most: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        for piece in pieces(word, width_limit.max(NAME)) {
            match lines.last_mut() {
                Some(line) if line.is_empty() => *line = piece,
                Some(line) if width(line) + 1 + width(&piece) <= width_limit => {
                    line.push(' ');
                    line.push_str(&piece);
                }
                _ => lines.push(piece),
            }
        }
    }
    if lines.len() > most + usize::from(most > 1) {
        lines.truncate(most);
        if let Some(last) = lines.last_mut() {
            while width(last) + 1 > width_limit && last.pop().is_some() {}
            last.push('…');
        }
    }
    lines
}

/// A word that is too long for a line, cut.
fn pieces(word: &str, limit: i32) -> Vec<String> {
    let mut pieces = vec![String::new()];
    for c in word.chars() {
        let full = pieces.last().is_some_and(|piece| width(piece) >= limit);
        if full {
            pieces.push(String::new());
        }
        if let Some(piece) = pieces.last_mut() {
            piece.push(c);
        }
    }
    pieces
}
