//! The items between the braces of a chart, a partial grafcet or a macro-step.

use proc_macro2::{Delimiter, Ident, Punct};

use super::input::Turns;
use super::recover::{self, Items};
use super::{Input, Result, attrs, chain, decl, foreign, named, partial, property, setting, step, words};
use crate::ast::{Body, DeclKind, Item};
use crate::diagnostic::Sink;
use crate::list::PushAll;

/// All of a body. What cannot be parsed is reported and left out.
pub(super) fn parse(mut input: Input, sink: &mut Sink) -> Body {
    let mut body = Body { levels: attrs::inner(&mut input, sink), ..Body::default() };
    let mut turns = Turns::default();
    while turns.more(&input) {
        let start = input;
        if let Err(error) = item(&mut input, &mut body.items, sink) {
            error.report(sink);
            body.broken.push_all(recover::names(start));
            body.lost_step |= recover::may_be_step(start);
            body.nameless_steps += usize::from(recover::is_nameless_step(start));
            recover::skip(&mut input, &start, Items::OfChart);
            body.lost.push_all(start.names_until(&input));
        }
        recover::moved(&mut input, &start, sink);
    }
    body
}

fn item(input: &mut Input, items: &mut Vec<Item>, sink: &mut Sink) -> Result<()> {
    foreign::comments(input, sink);
    let outer = attrs::outer(input, sink);
    label(input, sink);
    if property::relates(input) {
        let attrs = outer.levels_only("a property", sink);
        items.push(Item::Property(property::relation(input, attrs, sink)?));
        return Ok(());
    }
    if chain::begins(input) {
        let attrs = outer.attrs;
        items.push_all(chain::parse(input, &attrs, sink)?.into_iter().map(Item::Chain));
        recover::semicolon(input, Items::OfChart, sink);
        return Ok(());
    }
    let Some(word) = input.word() else {
        if input.is_empty() {
            return Err(outer.of_nothing(input));
        }
        return Err(input.error(match input.punct().map(Punct::as_char) {
            Some(';') => "this `;` ends nothing; remove it".to_owned(),
            Some('*') if input.next().at("-") => "all steps are `any`: `any -[x]-> A;`".to_owned(),
            Some('*') => "the step that is active first is declared as that: `initial step A;`".to_owned(),
            _ => format!("expected a declaration, a step or a chain of transitions, found {}", input.found()),
        }));
    };
    if word.to_lowercase().starts_with("end_") {
        let message = format!("nothing is closed with `{word}`: an item ends with `;` or with its braces; remove this");
        sink.notation(input.span(), message);
        input.bump();
        input.eat(";");
        return Ok(());
    }
    branches(input)?;
    let meant = keyword(word, input, sink)?;
    items.push(match meant {
        "input" => Item::Decl(decl::parse(input, DeclKind::Input, outer.attrs, sink)?),
        "output" => Item::Decl(decl::parse(input, DeclKind::Output, outer.attrs, sink)?),
        "var" => Item::Decl(decl::parse(input, DeclKind::Var, outer.attrs, sink)?),
        "param" => Item::Decl(decl::parse(input, DeclKind::Param, outer.attrs, sink)?),
        "action" => Item::Action(decl::action(input, outer.attrs, sink)?),
        "let" => Item::Let(named::parse(input, outer.levels_only("a `let`", sink), sink)?),
        "never" | "always" | "home" => {
            Item::Property(property::parse(input, meant, outer.levels_only("a property", sink), sink)?)
        }
        "clock" | "max_evolutions" | "budget" | "assume" | "optimize" | "encoding" | "forceable" | "modes" => {
            outer.refuse("a setting", sink);
            Item::Setting(setting::parse(input, meant, sink)?)
        }
        "partial" => Item::Partial(partial::parse(input, outer.attrs, sink)?),
        _ => Item::Step(step::parse(input, outer.attrs, sink)?),
    });
    Ok(())
}

/// `t1: A -[x]-> B`
fn label(input: &mut Input, sink: &mut Sink) {
    let (start, mut chain) = (*input, input.next());
    let labelled = input.word().is_some() && !chain.at("::") && chain.eat(":") && chain::draws(&chain);
    if let (true, Some(name)) = (labelled, input.word()) {
        let first = chain.word().unwrap_or("A");
        let message = format!("the name of a transition stands in its brackets: `{first} -[{name}: condition]-> …`");
        *input = chain;
        sink.notation(input.since(&start), message);
    }
}

/// `if a { … } else { … }`, which is one mistake to its end.
fn branches(input: &mut Input) -> Result<()> {
    let branching = ["if", "match", "switch", "case", "while", "for", "loop"].iter().any(|word| input.at_word(word));
    if !branching || input.next().at(":") {
        return Ok(());
    }
    let (start, mut ahead, mut turns) = (*input, *input, Turns::default());
    while turns.more(&ahead) && !ahead.at(";") {
        // The last braces end the item: they are left to whoever looks for the next one.
        if ahead.at_group(Delimiter::Brace) && !ahead.next().at_word("else") {
            *input = ahead;
            break;
        }
        ahead.bump();
    }
    let message =
        "each branch is a transition of its own, as `A -[x]-> B; A -[else]-> C;`, and a loop is one that leads back";
    Err(start.error(message))
}

/// The word of the notation an item begins with. One that is only meant is reported, and taken for it.
fn keyword(word: &str, input: &Input, sink: &mut Sink) -> Result<&'static str> {
    if let Some(item) = words::ITEMS.iter().find(|item| word == **item) {
        return Ok(item);
    }
    let next = input.next();
    foreign::of_rust(input, word)?;
    let lower = word.to_lowercase();
    if lower == "transition" || lower == "transitions" {
        return Err(input.error("a transition is drawn between its steps: `A -[condition]-> B;`"));
    }
    if word == "any" && !next.at(":") {
        return Err(input.error("what `any` leaves out stands after `except`: `any except (A, B) -[x]-> C;`"));
    }
    let claims = matches!(words::meant(word), Some("never" | "always"));
    let listed = next.at_group(Delimiter::Brace) || decl::lists_after_colon(&next);
    if listed && matches!(words::meant(word), Some("input" | "output" | "var" | "param"))
        || claims && (next.at("!") || next.at_group(Delimiter::Parenthesis))
        || next.word().is_some()
        || next.literal().is_some() && !super::association::is_qualifier(word)
    {
        if let Some(meant) = words::meant(word) {
            words::report(input, meant, sink);
            return Ok(meant);
        }
    }
    Err(input.error(if next.at_word("step") {
        format!("`step` stands in front of the name: `step {word}`")
    } else if next.at_word("implies") {
        "an implication is written `=>`: `always a => b;`".to_owned()
    } else if word == "eventually" || word == "finally" {
        "what comes some time follows from something: `a leads_to b;`".to_owned()
    } else if next.at(":") && syn::parse_str::<Ident>(word).is_err() {
        format!("`{word}` is a keyword of Rust; what is declared here has another name: `input level: u8;`")
    } else if next.at(":") || decl::lists(input) {
        format!("say what `{word}` is: `input {word}: bool;`, `output {word}: bool;` or `var {word}: bool = false;`")
    } else if next.at_assign() || super::association::is_qualifier(word) || word == "force" {
        "what a step does stands in its braces: `step A { N q; }`".to_owned()
    } else if next.at("-") || next.at("=>") || next.at("+") {
        "a transition is drawn between its steps: `A -[condition]-> B;`".to_owned()
    } else if next.at_group(Delimiter::Brace) {
        format!("say what `{word}` is: `step {word} {{ … }}` or `partial {word} {{ … }}`")
    } else {
        format!("expected a declaration, a step or a chain of transitions, found `{word}`")
    }))
}
