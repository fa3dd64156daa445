//! `in {Off, Auto, Manual}` after the type of a declaration.

use proc_macro2::{Delimiter, Span};

use super::input::Turns;
use super::{Input, Result};
use crate::ast::{Variant, Variants};

/// What stands after `in`, which is `keyword`.
pub(super) fn parse(input: &mut Input, keyword: Span) -> Result<Variants> {
    let Some(mut inside) = input.enter(Delimiter::Brace) else {
        return Err(input.error(format!(
            "expected the variants of an enum in braces, as in `in {{Off, Auto}}`, or the range of a param, as in `in 1..=8`, found {}",
            input.found()
        )));
    };
    if inside.is_empty() {
        return Err(inside.error("expected the variants of the enum, as in `in {Off, Auto}`"));
    }
    let (mut list, mut turns) = (Vec::new(), Turns::default());
    while turns.more(&inside) {
        let name = inside.name("a variant")?;
        if inside.at("::") {
            let message =
                format!("only the variant's own name stands here, as in `in {{Off, Auto}}`: leave out `{name}::`");
            return Err(inside.error(message));
        }
        let data = [Delimiter::Parenthesis, Delimiter::Brace].into_iter().find_map(|delimiter| inside.enter(delimiter));
        if let Some(mut data) = data {
            if !data.eat("..") || !data.is_empty() {
                return Err(data.error(format!("what `{name}` carries is not looked into: write `{name}(..)`")));
            }
            list.push(Variant { name, has_data: true });
        } else {
            list.push(Variant { name, has_data: false });
        }
        if !inside.eat(",") && !inside.is_empty() {
            return Err(inside.error(format!("expected `,`, found {}", inside.found())));
        }
    }
    Ok(Variants { keyword, list })
}
