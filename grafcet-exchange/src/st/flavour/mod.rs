//! The language as single tools have it. A program is made once, in the words of the standard; what a tool writes otherwise is changed in its text.
//!
//! - `words`: the words of expressions
//! - `codesys`, `tia`: the tools

mod codesys;
mod tia;
mod words;

use self::words::{Word, words};
use super::Flavour;
use super::syntax::{Program, Statement};

/// The program as a tool takes it.
pub(super) fn text(mut program: Program, flavour: Flavour) -> String {
    // TIA wants the inputs of functions by their names.
    if flavour != Flavour::Tia {
        change(&mut program.body, &|_, value| *value = positional(value));
    }
    match flavour {
        Flavour::Iec => program.text(),
        Flavour::Codesys => codesys::text(program),
        Flavour::Tia => tia::text(program),
    }
}

/// The first line of the header says in which language it is.
fn named(header: &mut [String], language: &str) {
    if let Some(first) = header.first_mut() {
        *first = first.replacen("(IEC 61131-3)", language, 1);
    }
}

/// The parts of a body: the heading of each, and what it does.
fn parts(body: &[Statement]) -> Vec<(Option<&str>, &[Statement])> {
    let (mut parts, mut rest) = (Vec::new(), body);
    while let [first, after @ ..] = rest {
        let (heading, part) = match first {
            Statement::Comment(heading) => (Some(heading.as_str()), after),
            Statement::Gap => {
                rest = after;
                continue;
            }
            _ => (None, rest),
        };
        let end = part.iter().position(|one| *one == Statement::Gap).unwrap_or(part.len());
        parts.push((heading, &part[..end]));
        rest = &part[end..];
    }
    parts
}

/// Functions of the standard with their inputs in order: `SHL(w, 2)`.
fn positional(text: &str) -> String {
    let words = words(text);
    let (mut done, mut open, mut at) = (String::new(), Vec::new(), 0);
    while let Some(word) = words.get(at) {
        let rest: String = words[at + 1..].iter().take(4).map(Word::text).collect();
        match word.text() {
            "(" => {
                let called = at.checked_sub(1).map(|before| words[before]);
                open.push(matches!(called, Some(Word::Called("SHL" | "SHR" | "MIN" | "MAX" | "SEL"))));
            }
            ")" => _ = open.pop(),
            _ => {}
        }
        if matches!(word, Word::Part(_)) && rest == " := " && open.last() == Some(&true) {
            at += 5;
            continue;
        }
        done.push_str(word.text());
        at += 1;
    }
    done
}

/// All texts of the statements, each by what it is: the target of an assignment or none, and the text of its value.
fn change(statements: &mut [Statement], change: &dyn Fn(Option<&mut String>, &mut String)) {
    for statement in statements {
        match statement {
            Statement::Assign(target, value) => change(Some(target), value),
            Statement::Call(call) => change(None, call),
            Statement::If(branches, otherwise) => {
                for (condition, then) in branches {
                    change(None, condition);
                    self::change(then, change);
                }
                self::change(otherwise, change);
            }
            Statement::Case(on, arms) => {
                change(None, on);
                for arm in arms {
                    self::change(&mut arm.body, change);
                }
            }
            Statement::Comment(_) | Statement::Gap => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::positional;

    #[test]
    fn inputs_in_order() {
        let text = "SHL(IN := f(IN := (a + 1), N := b), N := T_a.ET) = MAX(IN1 := T_a.ET, IN2 := (b)) AND g(N := c)";
        assert_eq!(positional(text), "SHL(f(IN := (a + 1), N := b), T_a.ET) = MAX(T_a.ET, (b)) AND g(N := c)");
    }
}
