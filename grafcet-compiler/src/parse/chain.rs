//! `A -[x]-> B -[y]-> (C, D);`

use proc_macro2::{Delimiter, Ident};

use super::input::Turns;
use super::{Error, Input, Result, decl, recover, transition, words};
use crate::ast::{Any, Arrow, Attrs, Chain, Node};
use crate::diagnostic::{Mark, Sink};

/// Whether a chain of transitions begins here.
pub(super) fn begins(input: &Input) -> bool {
    if input.at_group(Delimiter::Parenthesis) {
        return true;
    }
    let next = input.next();
    // `0 -[x]-> 1` and `{A, B} -[x]-> C`
    if (input.number().is_some() || input.at_group(Delimiter::Brace)) && at_arrow(&next) {
        return true;
    }
    match input.word() {
        Some("any") if next.at_word("except") => true,
        // `always => a` is half a property.
        Some(word) if words::ITEMS.contains(&word) => at_arrow(&next) && !next.at("=>"),
        Some(_) if decl::lists(input) => false,
        Some(_) => at_arrow(&next) || [",", ";", ".", "::"].iter().any(|sign| next.at(sign)),
        None => at_arrow(input),
    }
}

/// Whether a step or several are next, and an arrow after them.
pub(super) fn draws(input: &Input) -> bool {
    (input.word().is_some() || input.at_group(Delimiter::Parenthesis)) && at_arrow(&input.next())
}

/// Whether an arrow, or something that was meant as one, is next.
fn at_arrow(input: &Input) -> bool {
    let double = input.at("=") && input.next().at_group(Delimiter::Bracket) || input.at("==>") || input.at("=>");
    double || input.at("->") || input.at("<-") || input.at("--") || input.at_group(Delimiter::Bracket) || {
        // `never -x > 3` is a property, `-x->` an arrow.
        let next = input.next();
        input.at("-") && (next.at_group(Delimiter::Bracket) || next.at("-") || head_follows(next))
    }
}

/// Whether an arrow's head follows before the end of the item.
fn head_follows(mut input: Input) -> bool {
    for _ in 0..32 {
        if input.at("->") {
            return true;
        }
        if input.at(";") || !input.bump() {
            return false;
        }
    }
    false
}

/// The chain at `input`, in several parts where a link could not be parsed: what is left is as good as before.
pub(super) fn parse(input: &mut Input, attrs: &Attrs, sink: &mut Sink) -> Result<Vec<Chain>> {
    let start = *input;
    let chain = |first| Chain { attrs: attrs.clone(), first, rest: Vec::new() };
    let mut parts = Vec::new();
    let mut current = chain(if at_arrow(input) && !at_list(input) {
        Node::Forgotten(input.next().next().since(input))
    } else {
        first(input, sink)?
    });
    let mut turns = Turns::default();
    while turns.more(input) && at_arrow(input) {
        let start = *input;
        let arrow = arrow(input, sink)?;
        let next = if at_arrow(input) && !at_list(input) {
            Node::Missing(Mark { start: input.last(), end: input.span() })
        } else if input.is_empty() || input.at(";") || input.on_new_line() && words::item_begins(input) {
            Node::Forgotten(input.since(&start))
        } else {
            node(input, sink)?
        };
        match arrow {
            Some(arrow) => current.rest.push((arrow, next)),
            None => parts.push(std::mem::replace(&mut current, chain(next))),
        }
    }
    if parts.is_empty() && current.rest.is_empty() {
        return Err(alone(input, &start));
    }
    parts.push(current);
    Ok(parts)
}

fn alone(input: &Input, start: &Input) -> Error {
    let mark = input.since(start);
    if input.at(";") || input.is_empty() {
        return Error::new(
            mark,
            "a step alone says nothing here; draw a transition, `A -[condition]-> B;`, or declare it, `step A;`",
        );
    }
    input.error(format!("expected an arrow `-[condition]->`, found {}", input.found()))
}

/// What a chain begins with: also `any`, `any except (A, B)`.
fn first(input: &mut Input, sink: &mut Sink) -> Result<Node> {
    let start = *input;
    let next = input.next();
    if !input.at_word("any") || !next.at_word("except") && !at_arrow(&next) {
        return node(input, sink);
    }
    input.bump();
    let mut except = Vec::new();
    if input.at_word("except") {
        input.bump();
        except = match node(input, sink)? {
            Node::Step(name) => vec![name],
            Node::Group(names, _) => names,
            _ => Vec::new(),
        };
        if except.is_empty() {
            sink.notation(input.since(&start), "`except` leaves steps out; name them, or write `any` alone");
        }
    }
    Ok(Node::Any(Any { mark: input.since(&start), except }))
}

const PARALLEL: &str = "parallel steps stand in parentheses: `(A, B)`";

/// Whether parallel steps are listed in brackets.
fn at_list(input: &Input) -> bool {
    let Some(mut inside) = { *input }.enter(Delimiter::Bracket) else { return false };
    let named = inside.names("a step").is_ok_and(|names| names.len() > 1);
    named && !input.next().at("->")
}

/// `(B -[x]-> E, C)`
fn group(mut inside: Input) -> Result<Vec<Ident>> {
    let mut ahead = inside;
    while ahead.bump() {
        if ahead.at("->") || ahead.at("-") && ahead.next().at_group(Delimiter::Bracket) {
            return Err(ahead.error(
                "a list names steps alone; draw each branch as a chain of its own, and join where they end: \
                 `B -[x]-> E; (E, C) -[y]-> A;`",
            ));
        }
    }
    inside.names("a step")
}

/// A step, or several in parentheses.
fn node(input: &mut Input, sink: &mut Sink) -> Result<Node> {
    let start = *input;
    let other = [Delimiter::Brace, Delimiter::Bracket].into_iter().find(|delimiter| input.at_group(*delimiter));
    let node = if let Some(inside) = input.enter(other.unwrap_or(Delimiter::Parenthesis)) {
        let steps = group(inside)?;
        if other.is_some() {
            sink.notation(input.since(&start), PARALLEL);
        }
        Node::Group(steps, input.since(&start))
    } else {
        if input.at_word("step") && input.next().word().is_some() {
            let message =
                "a chain names its steps, and declares none; remove `step`, and declare the step on a line of its own";
            sink.notation(input.span(), message);
            input.bump();
        }
        Node::Step(input.step_name("a step or steps in parentheses")?)
    };
    if input.at(",") || input.at("&") || input.at("&&") {
        return Err(Error::new(input.since(&start), PARALLEL));
    }
    if condition_after(input) {
        return Err(input.error("the condition of a transition stands in its arrow: `A -[condition]-> B;`"));
    }
    if input.at("::") {
        return Err(input.error("a transition stays inside its partial grafcet; name a step of this one"));
    }
    if input.at(".") {
        return Err(input.error("a chain names the steps themselves, without `.X`"));
    }
    Ok(node)
}

/// `A -> B: x`, `A -> B if x` and `A -> B [x] / action`
fn condition_after(input: &Input) -> bool {
    let next = input.next();
    let spoken = input.at_word("if") || input.word().is_some_and(|word| recover::is_conditional(&word.to_lowercase()));
    let guard = input.at_group(Delimiter::Bracket) && (next.is_empty() || next.at(";") || next.at("/"));
    spoken || guard || input.at(":") && !input.at("::")
}

/// One arrow. A transition that could not be parsed is reported here, and is `None`.
fn arrow(input: &mut Input, sink: &mut Sink) -> Result<Option<Arrow>> {
    let start = *input;
    let (mut headed, mut doubled) = (false, false);
    if input.eat("->") {
        let mark = input.since(&start);
        if !input.at_group(Delimiter::Bracket) {
            return Ok(Some(Arrow::Bare(mark)));
        }
        sink.notation(mark, "the head of an arrow stands after its condition: `-[x]->`");
        headed = true;
    } else if input.eat("<-") {
        return Err(Error::new(start.span(), "arrows point forward: write `B -[x]-> A` in place of `A <-[x]- B`"));
    } else if input.eat("-") {
        doubled = self::doubled(input, &start, sink);
    } else if input.eat("==>") || input.eat("=>") {
        sink.notation(input.since(&start), "between two steps a transition is drawn with its condition: `A -[x]-> B`");
        return Ok(None);
    } else if input.eat("=") {
        sink.notation(input.since(&start), "an arrow is drawn with single dashes: `-[x]->`");
    } else {
        sink.notation(input.span(), "in front of this `-` is missing: a transition is drawn `-[x]->`");
    }
    let Some(inside) = input.enter(Delimiter::Bracket) else {
        return without_brackets(input, &start, sink);
    };
    if !headed || input.at("-") {
        head(input, &start, doubled, sink)?;
    }
    Ok(Some(Arrow::Transition(transition::parse(inside, input.since(&start), sink))))
}

/// `--[x]`, which is reported: whether it is that.
fn doubled(input: &mut Input, start: &Input, sink: &mut Sink) -> bool {
    let first = *input;
    while input.at("-") && !input.at("->") && input.bump() {}
    let doubled = !input.is_at(&first) && input.at_group(Delimiter::Bracket);
    if doubled {
        sink.notation(input.since(start), "an arrow has single dashes: `-[x]->`");
    }
    doubled
}

/// What should be `->` after the brackets. That dashes are `doubled` is said once.
fn head(input: &mut Input, start: &Input, doubled: bool, sink: &mut Sink) -> Result<()> {
    let brackets = input.last();
    if input.eat("->") {
        return Ok(());
    }
    // `-[x]-[y]->`: the dash belongs to the next arrow. `-[x]- -[y]->` has one to spare.
    if input.at("-") && input.next().at_group(Delimiter::Bracket) {
        return Ok(());
    }
    let before = *input;
    while input.at("-") && !input.at("->") && !input.next().at_group(Delimiter::Bracket) && input.bump() {}
    if input.at("-") && !input.at("->") {
        return Ok(());
    }
    let message = if input.eat("->") {
        if doubled {
            return Ok(());
        }
        "an arrow has single dashes: `-[x]->`"
    } else if input.eat(">") || input.eat("=>") {
        "the head of an arrow is `->`: `-[x]->`"
    } else if input.is_at(&before) && !(input.word().is_some() || input.at_group(Delimiter::Parenthesis)) {
        return Err(Error::new(
            Mark::from(start.span()).to(brackets),
            "this arrow has no head and leads nowhere: write `-[x]-> B`",
        ));
    } else {
        sink.notation(Mark::from(start.span()).to(input.last()), "the head of this arrow is missing: write `-[x]->`");
        return Ok(());
    };
    sink.notation(input.since(&before), message);
    Ok(())
}

/// `-x->`, `-(x)->`, `-->`
fn without_brackets(input: &mut Input, start: &Input, sink: &mut Sink) -> Result<Option<Arrow>> {
    let ahead = *input;
    if !head_follows(ahead) {
        return Err(Error::new(input.since(start), "a transition is drawn `-[condition]->`"));
    }
    while !input.eat("->") && input.bump() {}
    let message = if ahead.at("->") {
        "between two steps a transition has its condition in brackets: `-[x]->`, or `-[true]->` for always"
    } else {
        "the condition of a transition stands in brackets: `-[x]->`"
    };
    sink.notation(input.since(start), message);
    Ok(None)
}
