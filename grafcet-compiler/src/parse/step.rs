//! `initial step Off { N red; }`, macro-steps and enclosing steps.

use proc_macro2::{Delimiter, Ident, Span};

use super::input::Turns;
use super::recover::{self, Items};
use super::{Error, Input, Result, association, attrs, body, force, foreign, partial, time, words};
use crate::ast::{Attrs, Partial, Step, StepBody, StepKind, TimeArg, Within};
use crate::diagnostic::Sink;

/// The words in front of `step`, each where it stands.
#[derive(Default)]
struct Words {
    initial: Option<Span>,
    is_final: Option<Span>,
    linked: Option<Span>,
    entry: Option<Span>,
    exit: Option<Span>,
    macro_step: Option<Span>,
    enclosing: Option<Span>,
}

impl Words {
    fn slot(&mut self, word: &str) -> Option<&mut Option<Span>> {
        Some(match word {
            "initial" => &mut self.initial,
            "final" => &mut self.is_final,
            "linked" => &mut self.linked,
            "entry" => &mut self.entry,
            "exit" => &mut self.exit,
            "macro" => &mut self.macro_step,
            "enclosing" => &mut self.enclosing,
            _ => return None,
        })
    }
}

/// A step of any kind; the first of its words is next.
pub(super) fn parse(input: &mut Input, attrs: Attrs, sink: &mut Sink) -> Result<Step> {
    let words = words(input, sink);
    if let Some(number) = input.number() {
        sink.notation(
            input.span(),
            format!("the name of a step begins with a letter: write `S{number}`, here and in the chains"),
        );
    }
    let name = input.step_name("the name of the step")?;
    let within = within(input, &name, sink)?;
    let kind = match (words.macro_step, words.enclosing) {
        (Some(span), None) => StepKind::Macro(span, body::parse(braces(input, &name, "macro-step")?, sink)),
        (None, Some(span)) => {
            let (body, partials) = step_body(braces(input, &name, "enclosing step")?, true, sink);
            StepKind::Enclosing(span, body, partials)
        }
        (Some(_), Some(span)) => {
            return Err(Error::new(span, "a step is a macro-step or an enclosing step, not both"));
        }
        (None, None) => StepKind::Plain(plain(input, &name, sink)?),
    };
    let Words { initial, is_final, linked, entry, exit, .. } = words;
    Ok(Step { attrs, initial, is_final, linked, entry, exit, name, within, kind })
}

/// `within 10s`, if that is next.
fn within(input: &mut Input, name: &Ident, sink: &mut Sink) -> Result<Option<Within>> {
    let mut found = None;
    let mut turns = Turns::default();
    while turns.more(input) && input.eat_word("within") {
        let keyword = input.last();
        let time = match input.literal() {
            Some(literal) => time::parse(input, literal, sink).map(TimeArg::Literal),
            None if input.at_name() => input.eat_ident().map(TimeArg::Name),
            None => {
                let message = format!("after `within` stands how long `{name}` may take: `step {name} within 10s`");
                return Err(Error::new(keyword, message));
            }
        };
        if found.is_some() {
            sink.notation(keyword, format!("`{name}` has one time that it may take; keep one `within`"));
        }
        found = Some(Within { keyword, time });
    }
    Ok(found)
}

/// Everything up to the name.
fn words(input: &mut Input, sink: &mut Sink) -> Words {
    let (mut found, mut turns) = (Words::default(), Turns::default());
    while turns.more(input) {
        let Some(word) = input.word() else { break };
        let last = input.next().word().is_none() && !input.next().at_attribute();
        let meant = match words::meant(word) {
            Some(meant) if last && meant != "step" => break,
            Some(meant) if meant == "step" || found.slot(meant).is_some() => meant,
            _ => break,
        };
        // The first word was reported where the item was recognised.
        if meant != word && !found.is_empty() {
            words::report(input, meant, sink);
        }
        input.bump();
        let Some(slot) = found.slot(meant) else {
            found.after_step(input, sink);
            return found;
        };
        if slot.replace(input.last()).is_some() {
            sink.notation(input.last(), format!("`{word}` stands here twice; remove one"));
        }
        if words::is_initial_step(word) {
            return found;
        }
    }
    if input.at_attribute() {
        // The name is not found, which says why.
        return found;
    }
    sink.notation(input.last(), "after this `step` is missing, as in `initial step Off;`");
    found
}

impl Words {
    /// `step initial A`
    fn after_step(&mut self, input: &mut Input, sink: &mut Sink) {
        let named = input.next().word().is_some_and(|word| word != "within");
        let Some((word, slot)) = input.word().filter(|_| named).and_then(|word| Some((word, self.slot(word)?))) else {
            return;
        };
        slot.get_or_insert(input.span());
        sink.notation(input.span(), format!("`{word}` stands in front of `step`: `{word} step A;`"));
        input.bump();
    }

    fn is_empty(&self) -> bool {
        let Self { initial, is_final, linked, entry, exit, macro_step, enclosing } = self;
        [initial, is_final, linked, entry, exit, macro_step, enclosing].iter().all(|slot| slot.is_none())
    }
}

fn braces<'a>(input: &mut Input<'a>, name: &Ident, what: &str) -> Result<Input<'a>> {
    let Some(inside) = input.enter(Delimiter::Brace) else {
        return Err(input.error(format!("expected the braces of the {what} `{name}`, found {}", input.found())));
    };
    input.eat(";");
    Ok(inside)
}

fn plain(input: &mut Input, name: &Ident, sink: &mut Sink) -> Result<StepBody> {
    if input.at_group(Delimiter::Brace) {
        return Ok(step_body(braces(input, name, "step")?, false, sink).0);
    }
    if input.eat(";") {
        return Ok(StepBody::default());
    }
    if input.at(":") && words::item_begins(&input.next()) {
        sink.notation(input.span(), "a step without a body ends with `;`, not with `:`");
        input.bump();
        return Ok(StepBody::default());
    }
    if input.is_empty() || input.on_new_line() || words::item_begins(input) {
        sink.notation(input.last(), "`;` is missing after this; a step ends with `;` or has a body in braces");
        return Ok(StepBody::default());
    }
    Err(input.error(if input.at_attribute() {
        attrs::MISPLACED.to_owned()
    } else if input.at(",") {
        "each step is declared on its own: `step A; step B;`".to_owned()
    } else if input.at(":") {
        format!("what a step does stands in braces: `step {name} {{ N q; }}`")
    } else if let Some(word) = input.word().filter(|word| Words::default().slot(word).is_some()) {
        format!("`{word}` stands in front of `step`: `{word} step {name};`")
    } else {
        format!("expected `{{` or `;` after the name of the step, found {}", input.found())
    }))
}

/// The lines of a step, and the partial grafcets where it encloses some.
fn step_body(mut input: Input, encloses: bool, sink: &mut Sink) -> (StepBody, Vec<Partial>) {
    let mut body = StepBody::default();
    let mut partials = Vec::new();
    let mut turns = Turns::default();
    while turns.more(&input) {
        let start = input;
        if let Err(error) = line(&mut input, &mut body, encloses.then_some(&mut partials), sink) {
            error.report(sink);
            recover::skip(&mut input, &start, Items::OfStep);
        }
        recover::moved(&mut input, &start, sink);
    }
    (body, partials)
}

fn line(input: &mut Input, body: &mut StepBody, partials: Option<&mut Vec<Partial>>, sink: &mut Sink) -> Result<()> {
    foreign::comments(input, sink);
    let outer = attrs::outer(input, sink);
    if input.is_empty() {
        outer.refuse("the end of a step", sink);
        return Ok(());
    }
    let named = input.next().at_name();
    if input.at_word("partial") && named {
        let partial = partial::parse(input, outer.attrs, sink)?;
        match partials {
            Some(partials) => partials.push(partial),
            None => sink.notation(&partial.name, "only an `enclosing step` holds partial grafcets"),
        }
        return Ok(());
    }
    outer.refuse("a line of a step", sink);
    if input.eat(";") {
        sink.notation(input.last(), "this `;` ends nothing; remove it");
    } else if input.at_word("force") && (named || input.next().at_group(Delimiter::Brace)) {
        body.forces.push(force::parse(input)?);
    } else {
        body.associations.push(association::parse(input, sink)?);
    }
    Ok(())
}
