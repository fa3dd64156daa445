//! The calls of `grafcet!` in tokens.

use proc_macro2::{Span, TokenStream, TokenTree};

/// Where each call of `grafcet!` is, and what stands between its braces, also within functions and the arguments of other macros. What a `macro_rules!` would
/// write is no call.
#[must_use]
pub fn calls(tokens: &TokenStream) -> Vec<(Span, TokenStream)> {
    let mut found = Vec::new();
    collect(tokens, &mut found);
    found
}

fn collect(tokens: &TokenStream, found: &mut Vec<(Span, TokenStream)>) {
    // The two tokens in front, of which a name and `!` begin a call.
    let mut before: [Option<TokenTree>; 2] = [None, None];
    let mut defines = false;
    for tree in tokens.clone() {
        if let TokenTree::Group(group) = &tree {
            if defines {
                defines = false;
            } else if let ([Some(name), _], true) = (&before, is_called(&before, "grafcet")) {
                found.push((name.span(), group.stream()));
            } else {
                collect(&group.stream(), found);
            }
        }
        // `macro_rules! name { … }`
        defines |= is_called(&before, "macro_rules") && matches!(tree, TokenTree::Ident(_));
        before = [before[1].take(), Some(tree)];
    }
}

fn is_called(before: &[Option<TokenTree>; 2], name: &str) -> bool {
    matches!(before, [Some(TokenTree::Ident(word)), Some(TokenTree::Punct(mark))] if word == name && mark.as_char() == '!')
}

/// The name of the chart that these tokens begin with: `Motor` of `pub sfc Motor { … }`; none where this is not the begin of a chart.
#[must_use]
pub fn chart_name(tokens: &TokenStream) -> Option<String> {
    let mut all = tokens.clone().into_iter();
    let is_keyword = |tree: &TokenTree| matches!(tree, TokenTree::Ident(word) if *word == "sfc" || *word == "grafcet");
    all.by_ref().find(is_keyword)?;
    match all.next()? {
        TokenTree::Ident(name) => Some(name.to_string().trim_start_matches("r#").to_owned()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::{calls, chart_name};

    fn names(text: &str) -> Vec<String> {
        let tokens = text.parse().unwrap_or_else(|error| panic!("{text}: {error}"));
        calls(&tokens).iter().map(|(_, call)| chart_name(call).unwrap_or_default()).collect()
    }

    #[test]
    fn calls_stand_anywhere_but_in_macro_rules() {
        let text = "
            grafcet! { /// A chart of `sfc Other`.
                #[derive(Hash)] pub(crate) sfc A { } }
            mod inner { fn f() { grafcet::grafcet!(grafcet B { step sfc; }); } }
            wrap! { x; grafcet! [ sfc C { } ] }
            macro_rules! m { () => { grafcet! { sfc Never { } } }; }
            grafcet! { sfc D { } plant E { } }
            fn grafcet() {} if grafcet != (f) {}";
        assert_eq!(names(text), ["A", "B", "C", "D"]);
    }

    #[test]
    fn what_has_no_name_is_found_all_the_same() {
        assert_eq!(names("grafcet! { sfc { } } grafcet! {}"), ["", ""]);
    }
}
