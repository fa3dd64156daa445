//! Rust of the user, with its own tokens, after bindings of what it reads.

use proc_macro2::{Span, TokenStream};
use quote::{ToTokens, quote_spanned};

use super::Printer;
use crate::codegen::rust::{bare, plain_name, with_bindings, without_parens};
use crate::codegen::{names, writes};
use crate::list::List;
use crate::model::{Name, Place, Read, placeholder};
use crate::place::{self, quote};
use crate::program::{Expr, Run, User};

/// Whether an expression of the user is an input alone.
pub(super) fn is_input(user: &User<'_>) -> bool {
    let input = matches!(user.binds[..], [(Read::Name(Name::Input(_)), Expr::Input(_))]);
    input && plain_name(without_parens(user.tokens)).is_some()
}

impl<'m> Printer<'_, 'm> {
    /// An expression of the user.
    pub(super) fn user(&self, user: &User<'m>) -> TokenStream {
        let tokens = without_parens(user.tokens);
        // An input alone needs no binding: the user's own token names the field.
        if let (true, Some(name)) = (is_input(user), plain_name(tokens)) {
            // Located there, so that a type error stands there.
            return quote_spanned!(Span::call_site().located_at(name.span())=> inputs_.#name);
        }
        if !user.binds.is_empty() && self.cx.is_logic(user.tree) {
            return self.cx.with_inputs(tokens.to_token_stream());
        }
        with_bindings(&self.bindings(&user.binds, &[], user.tree.is_opaque()), tokens)
    }

    /// A block of the user: what it may write is a copy, which is taken over after it.
    pub(super) fn run(&self, run: &Run<'m>) -> TokenStream {
        let mut tokens = run.code.tokens.clone();
        let written: Vec<Place> = run.writes.iter().map(|write| write.name).list();
        let bindings = self.bindings(&run.binds, &written, true);
        let (mut flags, mut takes) = (TokenStream::new(), TokenStream::new());
        for write in &run.writes {
            let name = self.cx.model.place_name(write.name);
            let take = self.put(write.to, &name.to_token_stream());
            let Some(noted) = write.noted else {
                takes.extend(take);
                continue;
            };
            // No local of the program begins like this.
            let noticed = names::local(&format!("__{}", names::written(name)));
            let tell = self.put(noted, &quote!(true));
            let ty = self.cx.model.place_ty(write.name);
            let always = writes::always(&tokens, name);
            match (!always).then(|| writes::noted(&tokens, name, ty, &noticed)).flatten() {
                Some(block) => {
                    tokens = block;
                    flags.extend(quote!(let mut #noticed = false;));
                    takes.extend(quote!(if #noticed { #take #tell }));
                }
                None => takes.extend(quote!(#take #tell)),
            }
        }
        // The braces are the user's: they keep the block's own names apart from the ones written back.
        quote!({ #bindings #flags #[allow(unused_braces)] #tokens #takes })
    }

    /// `let on = inputs.on;` for everything that is read. In Rust that is not looked into (`opaque`) a name that is mentioned may stand
    /// for something of its own.
    fn bindings(&self, binds: &[(Read, Expr<'m>)], written: &[Place], opaque: bool) -> TokenStream {
        let unused = opaque.then(|| quote!(#[allow(unused_variables)]));
        let mut tokens = TokenStream::new();
        for (read, value) in binds {
            let value = bare(self.value(value));
            let place = written.iter().find(|place| Read::Name(Name::from(**place)) == *read);
            if let Some(place) = place {
                let name = self.cx.model.place_name(*place);
                // A block may mention a name in a way that does not write it.
                tokens.extend(quote!(#[allow(unused_mut, unused_variables)] let mut #name = #value;));
                continue;
            }
            let name = match read {
                Read::Name(name) => self.cx.model.value_name(*name).clone(),
                other => placeholder::ident(*other, place::mixed()).unwrap_or_else(|| names::local("unnamed")),
            };
            tokens.extend(quote!(#unused let #name = #value;));
        }
        tokens
    }
}
