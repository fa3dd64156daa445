//! `return`, `break`, `continue` and `?` in Rust of the user: what they leave must be the user's own. In generated code
//! they would leave the cycle half-way, with outputs of no situation, or turn one of its loops for ever.

use proc_macro2::{Span, TokenStream, TokenTree};
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;
use syn::{Expr, Label, Lifetime, Macro, Token};

use super::{Error, Input, Result};
use crate::diagnostic::Mark;
use crate::visit::{self, Locals, Visit};

/// Refuses what would leave generated code in Rust that was cut out between two places.
pub(super) fn check(from: &Input, to: &Input, walk: impl FnOnce(&mut Leaving)) -> Result<()> {
    // Few charts have such words: only these are walked through.
    if !from.may_leave_until(to) {
        return Ok(());
    }
    let mut leaving = Leaving::default();
    walk(&mut leaving);
    Error::several(leaving.notes).map_or(Ok(()), Err)
}

/// Something of the user's own that can be left.
struct Around {
    label: Option<String>,
    is_loop: bool,
}

#[derive(Default)]
pub(super) struct Leaving {
    around: Vec<Around>,
    /// How many `try` blocks are open, which `?` leaves.
    tries: usize,
    notes: Vec<(Mark, String)>,
    locals: Locals,
}

impl Leaving {
    fn note(&mut self, at: Span, message: String) {
        self.notes.push((at.into(), message));
    }

    fn returns(&mut self, at: Span) {
        self.note(
            at,
            "`return` would leave the chart's cycle half-way; end with the value, as in `if … { … } else { … }`, or move \
             this into a function"
                .to_owned(),
        );
    }

    fn questions(&mut self, at: Span) {
        if self.tries == 0 {
            self.note(
                at,
                "`?` would leave the chart's cycle half-way; say what happens otherwise, such as `.unwrap_or(…)`, or move \
                 this into a function"
                    .to_owned(),
            );
        }
    }

    /// `break` or `continue`.
    fn jumps(&mut self, word: &str, at: Span, label: Option<&Lifetime>) {
        let own = match label {
            Some(label) => self.around.iter().any(|around| around.label.as_ref() == Some(&label.to_string())),
            None => self.around.iter().any(|around| around.is_loop),
        };
        if !own {
            let of = label.map_or_else(|| "no loop".to_owned(), |label| format!("nothing called `{label}`"));
            self.note(
                at,
                format!(
                    "there is {of} around this `{word}`, which would act on the code that is generated; write `if … {{ … }} else {{ … }}`, \
                     or move this into a function"
                ),
            );
        }
    }

    fn within(&mut self, label: Option<&Label>, is_loop: bool, walk: impl FnOnce(&mut Self)) {
        self.around.push(Around { label: label.map(|label| label.name.to_string()), is_loop });
        walk(self);
        self.around.pop();
    }

    /// Inside a macro call whose tokens are no list of expressions: words alone tell.
    fn tokens(&mut self, tokens: TokenStream) {
        let mut operand = false;
        for tree in tokens {
            match &tree {
                TokenTree::Group(group) => self.tokens(group.stream()),
                TokenTree::Ident(word) if word == "return" => self.returns(word.span()),
                TokenTree::Ident(word) if word == "break" || word == "continue" => {
                    self.jumps(&word.to_string(), word.span(), None);
                }
                TokenTree::Punct(sign) if sign.as_char() == '?' && operand => self.questions(sign.span()),
                _ => {}
            }
            operand = !matches!(&tree, TokenTree::Punct(_));
        }
    }
}

impl Visit for Leaving {
    fn expr(&mut self, expr: &mut Expr) {
        match expr {
            // Their own functions, which nothing in them leaves further.
            Expr::Closure(_) | Expr::Async(_) | Expr::Const(_) => {}
            Expr::Return(leaves) => {
                self.returns(leaves.return_token.span);
                visit::inside(self, expr);
            }
            Expr::Try(tried) => {
                self.questions(tried.question_token.span());
                visit::inside(self, expr);
            }
            Expr::Break(jump) => {
                self.jumps("break", jump.break_token.span, jump.label.as_ref());
                visit::inside(self, expr);
            }
            Expr::Continue(jump) => self.jumps("continue", jump.continue_token.span, jump.label.as_ref()),
            Expr::TryBlock(_) => {
                self.tries += 1;
                visit::inside(self, expr);
                self.tries -= 1;
            }
            Expr::Loop(repeated) => {
                let label = repeated.label.clone();
                self.within(label.as_ref(), true, |leaving| visit::inside(leaving, expr));
            }
            Expr::While(repeated) => {
                let label = repeated.label.clone();
                self.within(label.as_ref(), true, |leaving| visit::inside(leaving, expr));
            }
            Expr::ForLoop(repeated) => {
                self.expr(&mut repeated.expr);
                let label = repeated.label.clone();
                self.within(label.as_ref(), true, |leaving| visit::block(leaving, &mut repeated.body));
            }
            Expr::Block(labelled) => {
                let label = labelled.label.clone();
                self.within(label.as_ref(), false, |leaving| visit::inside(leaving, expr));
            }
            other => visit::inside(self, other),
        }
    }

    fn locals(&mut self) -> &mut Locals {
        &mut self.locals
    }

    fn call(&mut self, call: &mut Macro) {
        match call.parse_body_with(Punctuated::<Expr, Token![,]>::parse_terminated) {
            Ok(arguments) => arguments.into_iter().for_each(|mut argument| self.expr(&mut argument)),
            Err(_) => self.tokens(call.tokens.clone()),
        }
    }
}
