//! `pub sfc Motor { … }`

use proc_macro2::{Delimiter, Ident, Span};
use quote::ToTokens;
use syn::Visibility;
use syn::parse::Parse;

use super::{Error, Input, Result, attrs, body};
use crate::ast::{Chart, Dialect};
use crate::diagnostic::Sink;
use crate::plant;
use crate::similar;

/// The one chart of a call.
pub(super) fn chart(mut input: Input, sink: &mut Sink) -> Option<Chart> {
    let attrs = attrs::of_chart(&mut input, sink);
    let (vis, (dialect, keyword, is_plant), name, inside) = match header(&mut input, sink) {
        Ok(header) => header,
        Err(error) => {
            error.report(sink);
            return None;
        }
    };
    let body = body::parse(inside, sink);
    if !input.is_empty() {
        let nameless = input.at_word("plant") && input.next().at_group(Delimiter::Brace);
        let second = ["pub", "sfc", "grafcet", "#"].iter().any(|word| input.at_word(word) || input.at(word));
        let message = if second {
            "a macro call holds one chart; write a second `grafcet! { … }` for this one".to_owned()
        } else if nameless {
            "after `plant` stands its name: `plant Cylinder { … }`".to_owned()
        } else {
            format!("the chart ends with its `}}`; {} does not belong to it", input.found())
        };
        input.error(message).report(sink);
    }
    let incomplete = sink.has_errors();
    Some(Chart { attrs, vis, dialect, keyword, name, body, incomplete, is_plant, plants: Vec::new() })
}

type Header<'a> = (Visibility, (Dialect, Span, bool), Ident, Input<'a>);

fn header<'a>(input: &mut Input<'a>, sink: &mut Sink) -> Result<Header<'a>> {
    let vis = visibility(input)?;
    let (keyword, is_plant) = (input.span(), input.at_word(plant::KEYWORD));
    let dialect = dialect(input, sink)?;
    if input.at_word("pub") {
        return Err(input.error("`pub` stands in front of the dialect: `pub sfc Motor { … }`"));
    }
    let name = input.name("the name of the chart, as in `sfc Motor { … }`")?;
    if syn::parse2::<Ident>(name.to_token_stream()).is_err() {
        let message = format!("`{name}` is a keyword of Rust; the chart becomes a type and needs another name");
        return Err(Error::new(&name, message));
    }
    if input.at("<") {
        return Err(
            input.error("a chart has no generic parameters; its inputs, outputs and variables have concrete types")
        );
    }
    let Some(inside) = input.enter(Delimiter::Brace) else {
        return Err(input.error(format!("expected `{{` after the name of the chart, found {}", input.found())));
    };
    Ok((vis, (dialect, keyword, is_plant), name, inside))
}

fn visibility(input: &mut Input) -> Result<Visibility> {
    if input.at_word("pub") {
        let restricted = usize::from(input.next().at_group(Delimiter::Parenthesis));
        return input.rust_tokens(1 + restricted, Visibility::parse);
    }
    Ok(Visibility::Inherited)
}

fn dialect(input: &mut Input, sink: &mut Sink) -> Result<Dialect> {
    let expected =
        "a chart begins with its dialect, `sfc` (IEC 61131-3) or `grafcet` (IEC 60848), as in `pub sfc Motor { … }`";
    let written = input.word().unwrap_or_default();
    let (dialect, ours) = match written.to_lowercase().as_str() {
        "sfc" => (Dialect::Sfc, "sfc"),
        plant::KEYWORD => (Dialect::Sfc, plant::KEYWORD),
        "grafcet" | "graphcet" | "grafset" => (Dialect::Grafcet, "grafcet"),
        "plant" if input.next().word().is_some() => {
            return Err(input.error("a plant stands after the chart that moves it, in the same call"));
        }
        // A chart by another name is read on, so that it still gives its types.
        "ablaufsprache" | "ablaufkette" if input.next().word().is_some() => (Dialect::Sfc, "sfc"),
        other if input.next().word().is_some() && input.next().next().at_group(Delimiter::Brace) => {
            sink.notation(input.span(), format!("{expected}; found {}", input.found()));
            input.bump();
            return Ok(if similar::distance(other, "sfc") < 2 { Dialect::Sfc } else { Dialect::Grafcet });
        }
        _ => return Err(input.error(format!("{expected}; found {}", input.found()))),
    };
    if written != ours {
        sink.notation(input.span(), format!("the dialect is written `{ours}`"));
    }
    input.bump();
    Ok(dialect)
}
