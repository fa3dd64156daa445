//! The tokens of a call, taken apart: the chart, and the plants after it.

use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};

use crate::list::List;

/// A chart and its plants, of which there is one at least.
pub(crate) struct Call {
    pub(crate) chart: TokenStream,
    /// Its name, where it has one.
    name: Option<Ident>,
    /// What stands between its braces.
    pub(crate) body: TokenStream,
    pub(crate) plants: Vec<Written>,
    /// What stands after and is none.
    pub(crate) rest: TokenStream,
}

/// A plant as it is written.
pub(crate) struct Written {
    /// `test,` of `#[cfg(test)]`: under what it is a type.
    pub(crate) cfgs: TokenStream,
    /// Its other attributes, and `pub`.
    pub(crate) before: TokenStream,
    /// `plant`
    pub(crate) keyword: Ident,
    pub(crate) name: Ident,
    pub(crate) body: Group,
}

impl Call {
    /// None for a call without plants.
    pub(crate) fn of(tokens: &TokenStream) -> Option<Self> {
        let all = tokens.clone().into_iter().list();
        let end = all.iter().position(is_braces)?;
        let TokenTree::Group(body) = &all[end] else { return None };
        let (mut plants, mut at) = (Vec::new(), end + 1);
        while let Some((plant, after)) = plant(&all, at) {
            plants.push(plant);
            at = after;
        }
        let is_chart = !is_word(all.get(end.wrapping_sub(2)), "plant");
        (is_chart && !plants.is_empty()).then(|| Self {
            chart: all[..=end].iter().cloned().map(TokenStream::from).tokens(),
            name: name(all.get(end.wrapping_sub(1))),
            body: body.stream(),
            plants,
            rest: all[at..].iter().cloned().map(TokenStream::from).tokens(),
        })
    }

    /// The chart, and what does not belong to the call.
    pub(crate) fn chart_and_rest(&self) -> TokenStream {
        let mut tokens = self.chart.clone();
        tokens.extend(self.rest.clone());
        tokens
    }

    /// What in front of a plant has its name: the types of both would be called the same.
    pub(super) fn namesake(&self, plant: usize) -> Option<&'static str> {
        let name = &self.plants[plant].name;
        if self.name.as_ref() == Some(name) {
            return Some("the chart");
        }
        self.plants[..plant].iter().any(|other| other.name == *name).then_some("a plant")
    }

    /// The partial grafcets of the chart, those within enclosing steps among them.
    pub(super) fn partials(&self) -> Vec<String> {
        fn within(tokens: TokenStream, names: &mut Vec<String>) {
            let all = tokens.into_iter().list();
            for (at, token) in all.iter().enumerate() {
                match (token, all.get(at + 1), all.get(at + 2)) {
                    (TokenTree::Ident(word), Some(TokenTree::Ident(name)), Some(body))
                        if word == "partial" && is_braces(body) =>
                    {
                        names.push(name.to_string());
                    }
                    (TokenTree::Group(group), ..) => within(group.stream(), names),
                    _ => {}
                }
            }
        }
        let mut names = Vec::new();
        within(self.body.clone(), &mut names);
        names
    }

    pub(crate) fn names(&self) -> Vec<String> {
        self.plants.iter().map(|plant| plant.name.to_string()).list()
    }
}

/// The plant that begins here, and where the tokens after it begin.
fn plant(all: &[TokenTree], from: usize) -> Option<(Written, usize)> {
    let (mut cfgs, mut before, mut at) = (TokenStream::new(), TokenStream::new(), from);
    loop {
        match &all[at..] {
            [TokenTree::Punct(hash), TokenTree::Group(group), ..] if hash.as_char() == '#' => {
                match &group.stream().into_iter().list()[..] {
                    [word, TokenTree::Group(when)] if is_word(Some(word), "cfg") => {
                        let when = when.stream();
                        cfgs.extend(quote::quote!(#when,));
                    }
                    _ => before.extend([all[at].clone(), all[at + 1].clone()]),
                }
                at += 2;
            }
            [TokenTree::Ident(word), TokenTree::Ident(name), TokenTree::Group(body), ..]
                if word == "plant" && body.delimiter() == Delimiter::Brace =>
            {
                let (keyword, name, body) = (word.clone(), name.clone(), body.clone());
                return Some((Written { cfgs, before, keyword, name, body }, at + 3));
            }
            [TokenTree::Ident(word), ..] if word == "pub" => {
                before.extend([all[at].clone()]);
                at += 1;
            }
            [TokenTree::Group(group), ..] if group.delimiter() == Delimiter::Parenthesis => {
                before.extend([all[at].clone()]);
                at += 1;
            }
            _ => return None,
        }
    }
}

fn name(token: Option<&TokenTree>) -> Option<Ident> {
    match token {
        Some(TokenTree::Ident(name)) => Some(name.clone()),
        _ => None,
    }
}

fn is_braces(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace)
}

pub(super) fn is_word(token: Option<&TokenTree>, word: &str) -> bool {
    matches!(token, Some(TokenTree::Ident(ident)) if ident == word)
}

pub(super) fn is_sign(token: Option<&TokenTree>, sign: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == sign)
}
