//! Rust of the user, with its own tokens, after bindings of what it reads.

use proc_macro2::TokenStream;
use quote::ToTokens;

use super::Printer;
use crate::codegen::rust::{bare, plain_name};
use crate::codegen::{names, writes};
use crate::list::List;
use crate::model::{Name, Place, Read};
use crate::place::quote;
use crate::program::{Expr, Run, User};
use crate::visit::without_parens;

/// Whether an expression of the user is an input alone.
pub(super) fn is_input(user: &User<'_>) -> bool {
    let input = matches!(user.binds[..], [(Read::Name(Name::Input(_)), Expr::Input(_))]);
    input && plain_name(without_parens(user.tokens)).is_some()
}

impl<'m> Printer<'_, 'm> {
    /// An expression of the user.
    pub(super) fn user(&self, user: &User<'m>) -> TokenStream {
        let bindings = || self.bindings(&user.binds, &[], user.tree.is_opaque());
        self.cx.bound((user.tokens, user.tree), is_input(user), !user.binds.is_empty(), &bindings)
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

    /// Everything that is read; what is `written` as a copy.
    fn bindings(&self, binds: &[(Read, Expr<'m>)], written: &[Place], opaque: bool) -> TokenStream {
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
            tokens.extend(self.cx.binding(*read, &value, opaque));
        }
        tokens
    }
}
