//! Statements.

use proc_macro2::{Literal, TokenStream};
use syn::Lifetime;

use super::Printer;
use super::expr::{kind_type, kind_variant};
use super::scope::Scope;
use crate::list::List;
use crate::place::{self, quote};
use crate::program::{Arm, Expr, Fence, Initial, Phase, PlaceId, Role, Statement, Type, Value};

/// The place in the text of the program, in the order of [`Scope`].
struct Lines<'s> {
    scope: &'s Scope,
    next: usize,
    /// What is left is a block with a label.
    in_block: bool,
}

impl<'m> Printer<'_, 'm> {
    pub(super) fn block(&self, statements: &[Statement<'m>], scope: &Scope) -> TokenStream {
        self.list(statements, &mut Lines { scope, next: 0, in_block: false })
    }

    fn list(&self, statements: &[Statement<'m>], lines: &mut Lines<'_>) -> TokenStream {
        let mut tokens = TokenStream::new();
        let mut rest = statements;
        while let Some((statement, after)) = rest.split_first() {
            if let Some((record, count)) = self.record(rest) {
                tokens.extend(record);
                lines.next += count;
                rest = &rest[count..];
                continue;
            }
            rest = after;
            if let Statement::Part(_, body) = statement {
                tokens.extend(self.list(body, lines));
                continue;
            }
            let number = lines.next;
            lines.next += 1;
            for place in &lines.scope.before[number] {
                let (ty, name, value) = (self.ty(*place), self.layout.name(*place), self.initial(*place));
                if lines.scope.settled[place.0] {
                    tokens.extend(quote!(let #name: #ty;));
                    continue;
                }
                let mutable = lines.scope.mutable[place.0].then(|| quote!(mut));
                // A constant of the user's has its place in the source, where a lint would stand.
                let written = matches!(self.info(*place).initial, Initial::Constant(_));
                let allowed = written.then(|| quote!(#[allow(unused_assignments)]));
                tokens.extend(quote!(#allowed let #mutable #name: #ty = #value;));
            }
            if let (Statement::Set(place, value), Some(Statement::Set(next, _))) = (statement, after.first()) {
                if self.layout.is_mark(*next) {
                    tokens.extend(self.put_unmarked(*place, &self.set_to(*place, value)));
                    continue;
                }
            }
            tokens.extend(self.statement(statement, number, lines));
        }
        tokens
    }

    /// Statements that give each output a constant are one constant, and how many they are.
    fn record(&self, statements: &[Statement<'m>]) -> Option<(TokenStream, usize)> {
        let (model, name) = (self.cx.model, &self.cx.names.outputs);
        let count = model.outputs.len();
        let first = statements.get(..count).filter(|_| count > 1)?;
        let mut fields = TokenStream::new();
        for (statement, (id, output)) in first.iter().zip(model.outputs.iter()) {
            let Statement::Set(place, Expr::Value(value)) = statement else { return None };
            let is_next = self.program.places[place.0].role == Role::Output(id) && self.layout.is_result(*place);
            let (name, value) = (is_next.then_some(&output.name)?, self.constant(*value, Type::Bool));
            fields.extend(quote!(#name: #value,));
        }
        Some((quote!(outputs_ = const { #name { #fields } };), count))
    }

    fn statement(&self, statement: &Statement<'m>, number: usize, lines: &mut Lines<'_>) -> TokenStream {
        match statement {
            Statement::Set(place, value) => {
                let (kinds, tokens) = match (self.info(*place).ty, value) {
                    (ty @ Type::Kind { .. }, Expr::Table(of, table)) => self.kinds(ty, *of, table),
                    (Type::User(_), Expr::Table(of, table)) => (TokenStream::new(), self.numbers(*place, *of, table)),
                    _ => (TokenStream::new(), self.set_to(*place, value)),
                };
                if !lines.scope.declares[number] {
                    return self.set(*place, value, &tokens);
                }
                let (ty, name) = (self.ty(*place), self.layout.name(*place));
                let mutable = lines.scope.mutable[place.0].then(|| quote!(mut));
                quote!(#kinds let #mutable #name: #ty = #tokens;)
            }
            Statement::If(condition, then, otherwise) => self.branches(condition, then, otherwise, lines),
            Statement::Match(place, arms, otherwise) => self.arms(*place, arms, otherwise, lines),
            Statement::Loop { body, rounds } => self.repeated(body, *rounds, lines),
            Statement::Break if lines.in_block => {
                let label = label();
                quote!(break #label;)
            }
            Statement::Break => quote!(break;),
            Statement::Run(run) => self.run(run),
            Statement::Call(action, phase, args) => {
                let (name, phase) = (&self.cx.model.actions[*action].name, self.value(phase));
                let args = args.iter().map(|arg| self.value(arg)).list();
                quote!(actions_.#name(#phase, #(#args),*);)
            }
            Statement::Fence(fence) => self.fence(*fence),
            Statement::Part(..) | Statement::Mark(_) => TokenStream::new(),
        }
    }

    /// Nothing is moved across it.
    pub(super) fn fence(&self, fence: Fence) -> TokenStream {
        let p = &self.cx.p;
        match fence {
            Fence::Inputs => quote!(let inputs_ = #p::core::hint::black_box(inputs_);),
            Fence::Memory => {
                let atomic = quote!(#p::core::sync::atomic);
                quote!(#atomic::compiler_fence(#atomic::Ordering::SeqCst);)
            }
            Fence::Armv6m => quote!(#p::fence_on_armv6m();),
            Fence::BeyondArmv6m => quote!(#p::fence_beyond_armv6m();),
        }
    }

    /// A loop; where there is one round, a block that can be left.
    fn repeated(&self, body: &[Statement<'m>], rounds: u32, lines: &mut Lines<'_>) -> TokenStream {
        let once = match body.split_last() {
            Some((Statement::Break, once)) if rounds == 1 => Some(once),
            _ => None,
        };
        let outside = std::mem::replace(&mut lines.in_block, once.is_some());
        let tokens = self.list(once.unwrap_or(body), lines);
        // What has not been printed is counted, too.
        lines.next += usize::from(once.is_some());
        lines.in_block = outside;
        if once.is_none() {
            return quote!(loop { #tokens });
        }
        let label = label();
        quote!(#label: { #tokens })
    }

    /// `if a { … } else if b { … } else { … }`
    fn branches(
        &self,
        condition: &Expr<'m>,
        then: &[Statement<'m>],
        otherwise: &[Statement<'m>],
        lines: &mut Lines<'_>,
    ) -> TokenStream {
        let condition = self.condition(condition);
        let then = self.list(then, lines);
        let otherwise = self.list(otherwise, lines);
        if otherwise.is_empty() {
            quote!(if #condition { #then })
        } else {
            quote!(if #condition { #then } else { #otherwise })
        }
    }

    fn arms(
        &self,
        place: PlaceId,
        arms: &[Arm<'m>],
        otherwise: &[Statement<'m>],
        lines: &mut Lines<'_>,
    ) -> TokenStream {
        let ty = self.program.places[place.0].ty;
        let mut tokens = TokenStream::new();
        for (values, body) in arms {
            let (values, body) = (values.iter().map(|value| self.constant(*value, ty)).list(), self.list(body, lines));
            tokens.extend(quote!(#(#values)|* => { #body }));
        }
        let otherwise = self.list(otherwise, lines);
        if !self.layout.is_complete(self.program, ty, arms) {
            tokens.extend(quote!(_ => { #otherwise }));
        }
        let value = self.get(place);
        quote!(match #value { #tokens })
    }

    /// A value as an expression and as a pattern.
    pub(super) fn constant(&self, value: Value, ty: Type<'m>) -> TokenStream {
        let p = &self.cx.p;
        match value {
            Value::Bool(value) => quote!(#value),
            Value::Int(kind) if matches!(ty, Type::Kind { .. }) => {
                let (kinds, kind) = (kind_type(ty), kind_variant(kind));
                quote!(#kinds::#kind)
            }
            Value::Int(number) => {
                let number = Literal::i128_unsuffixed(number);
                quote!(#number)
            }
            Value::Ticks(0) => quote!(#p::Ticks::ZERO),
            Value::Ticks(ticks) => quote!(#p::Ticks::new(#ticks)),
            Value::Step(step) => match ty {
                Type::State(region) => self.variant(step, region),
                _ => step.map_or_else(|| quote!(false), |step| self.cx.variant(step)),
            },
            Value::Start(_) => match ty {
                Type::State(region) => self.start(region),
                _ => quote!(false),
            },
            Value::Phase(Phase::First) => quote!(#p::Phase::First),
            Value::Phase(Phase::Repeated) => quote!(#p::Phase::Repeated),
            Value::Phase(Phase::Final) => quote!(#p::Phase::Final),
            Value::Other(_) => quote!(#p::core::default::Default::default()),
        }
    }
}

fn label() -> Lifetime {
    Lifetime::new("'once", place::mixed())
}
