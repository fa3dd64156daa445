//! Expressions: names found, the forms that are not Rust replaced by placeholders, the meaning as a tree.

use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::ToTokens;
use syn::{BinOp, Lit, UnOp};

use super::scope::Meaning;
use super::{Resolver, habits};
use crate::diagnostic::Mark;
use crate::list::List;
use crate::model::{Binary, Edge, Expr, LetId, Name, Place, Read, TimeRef, Tree, Ty, Unary, placeholder};
use crate::raw::plain;
use crate::visit::Locals;

/// Resolves one expression of the user.
pub(super) fn resolve(expr: &syn::Expr, resolver: &mut Resolver<'_>) -> Expr {
    resolve_with_places(expr, resolver).0
}

/// The same, and where everything that it reads is mentioned, in source order.
pub(super) fn resolve_with_places(expr: &syn::Expr, resolver: &mut Resolver<'_>) -> (Expr, Vec<Seen>) {
    let mut lower = Lower::new(resolver);
    let mut tokens = expr.clone();
    let before = lower.resolver.sink.count();
    let tree = lower.lower(&mut tokens);
    let broken = lower.resolver.sink.count() > before;
    let (reads, places, text) = (lower.reads, lower.places, super::text::of(expr));
    // An expression with a mistake equals only its own text.
    let tree = if broken {
        Tree::Opaque { text: text.clone(), reads: reads.clone(), call: None, whole: false, open: false, of: None }
    } else {
        tree
    };
    (Expr { tree, tokens, reads, text, mark: Mark::of(expr) }, places)
}

/// Resolves a condition.
pub(super) fn resolve_condition(expr: &syn::Expr, resolver: &mut Resolver<'_>) -> Expr {
    resolve_after(habits::of_condition, expr, resolver)
}

/// Resolves what a `let` names.
pub(super) fn resolve_named(expr: &syn::Expr, resolver: &mut Resolver<'_>) -> Expr {
    resolve_after(habits::of_named, expr, resolver)
}

/// Resolves an expression after a look at how it is written.
fn resolve_after(habits: fn(&syn::Expr, &mut Resolver<'_>), expr: &syn::Expr, resolver: &mut Resolver<'_>) -> Expr {
    let (before, alone) = (resolver.sink.count(), resolver.alone.len());
    habits(expr, resolver);
    let broken = resolver.sink.count() > before;
    let mut condition = resolve(expr, resolver);
    resolver.alone.truncate(alone);
    if broken {
        let (text, reads) = (condition.text.clone(), condition.reads.clone());
        condition.tree = Tree::Opaque { text, reads, call: None, whole: false, open: false, of: None };
    }
    condition
}

pub(super) fn without_field(step: &str) -> String {
    format!("`{step}` is a step; write `{step}.X` for its activity or `{step}.T` for its time")
}

/// Something that an expression reads, and where it says so.
pub(super) struct Seen {
    pub(super) read: Read,
    pub(super) mark: Mark,
    /// The `let` that stands there for it.
    pub(super) within: Option<LetId>,
}

/// Rewrites expressions in place and takes note of what they read.
pub(super) struct Lower<'r, 's> {
    pub(super) resolver: &'r mut Resolver<'s>,
    pub(super) reads: Vec<Read>,
    /// Every mention.
    pub(super) places: Vec<Seen>,
    /// Names that Rust binds where the walk stands: by `let`, a closure or a pattern.
    pub(super) locals: Locals,
    /// Something of what is being read may have another value in each evaluation.
    pub(super) differs: bool,
}

impl<'r, 's> Lower<'r, 's> {
    pub(super) fn new(resolver: &'r mut Resolver<'s>) -> Self {
        Self { resolver, reads: Vec::new(), places: Vec::new(), locals: Locals::default(), differs: false }
    }

    /// Rewrites `expr` and returns its meaning.
    pub(super) fn lower(&mut self, expr: &mut syn::Expr) -> Tree {
        self.resolver.scale.enter();
        let tree = self.tree(expr);
        self.resolver.scale.leave();
        tree
    }

    fn tree(&mut self, expr: &mut syn::Expr) -> Tree {
        match expr {
            syn::Expr::Paren(paren) => self.lower(&mut paren.expr),
            syn::Expr::Unary(unary) => {
                let operator = match unary.op {
                    UnOp::Not(_) => Unary::Not,
                    UnOp::Neg(_) => Unary::Neg,
                    _ => return self.opaque(expr),
                };
                let operand = self.lower(&mut unary.expr);
                match (operator, operand) {
                    (Unary::Neg, Tree::Int(value)) => Tree::Int(-value),
                    (operator, operand) => Tree::Unary(operator, Box::new(operand)),
                }
            }
            syn::Expr::Binary(binary) => {
                if let Some(parts) = self.delay_parts(binary) {
                    return self.delay(parts, expr);
                }
                let Some(operator) = operator(&binary.op) else {
                    return if self.refuses_write(&binary.left) { Tree::Bool(true) } else { self.opaque(expr) };
                };
                if self.compares_with_step(operator, binary) {
                    return Tree::Bool(true);
                }
                let left = self.lower(&mut binary.left);
                let right = self.lower(&mut binary.right);
                self.units(binary, &left, &right);
                let (left, right) = self.compared(operator, binary, (left, right));
                Tree::Binary(operator, Box::new(left), Box::new(right))
            }
            syn::Expr::Lit(lit) => match literal(&lit.lit) {
                Some(tree) => tree,
                None => self.time_literal(expr),
            },
            syn::Expr::Path(_) => self.path(expr),
            syn::Expr::Field(_) => self.field(expr),
            syn::Expr::Call(_) => self.call(expr),
            syn::Expr::Macro(_) => {
                let told = self.matched(expr);
                let opaque = self.opaque(expr);
                told.unwrap_or(opaque)
            }
            syn::Expr::Assign(assign) if self.refuses_write(&assign.left) => Tree::Bool(true),
            _ => self.opaque(expr),
        }
    }

    /// The output or variable on the left of an assignment.
    pub(super) fn place(&self, expr: &syn::Expr) -> Option<Place> {
        let name = single_name(expr).filter(|name| !self.locals.contains(name))?;
        match self.resolver.scope.get(&name)? {
            Meaning::Value(Name::Output(id)) => Some(Place::Output(id)),
            Meaning::Value(Name::Var(id)) => Some(Place::Var(id)),
            _ => None,
        }
    }

    pub(super) fn note(&mut self, read: Read) {
        if !self.reads.contains(&read) {
            self.reads.push(read);
        }
    }

    /// Puts the placeholder of `read` in the place of `expr`.
    pub(super) fn replace(&mut self, expr: &mut syn::Expr, read: Read) -> Tree {
        self.note(read);
        let mark = Mark::of(&*expr);
        self.places.push(Seen { read, mark, within: None });
        if let Some(name) = placeholder::ident(read, mark.start) {
            *expr = syn::Expr::Verbatim(name.into_token_stream());
        }
        match read {
            Read::Elapsed(time, step) => Tree::Elapsed(time, step),
            Read::MacroElapsed(time, id) => Tree::MacroElapsed(time, id),
            read => Tree::Read(read),
        }
    }

    /// `rising(e)`, `falling(e)`; any other call is Rust.
    fn call(&mut self, expr: &mut syn::Expr) -> Tree {
        let syn::Expr::Call(call) = &mut *expr else { return self.opaque(expr) };
        let Some(function) = single_name(&call.func) else { return self.opaque(expr) };
        let local = self.locals.contains(&function);
        if let (false, Some(Meaning::Action(_))) = (local, self.resolver.scope.get(&function)) {
            return self.path(&mut call.func);
        }
        if let (false, None, Some(message)) = (local, self.resolver.scope.get(&function), habits::function(&function)) {
            self.resolver.sink.notation(&function, message);
            return Tree::Bool(true);
        }
        if !local && function == "blink" {
            return self.blink(expr);
        }
        if local || function != "rising" && function != "falling" {
            let (text, differs) = (super::text::of(&*call), local || !self.is_pure_function(&call.func));
            let is_value = !local && self.can_be_called(&function);
            // The name of a function is Rust's, unless a declared value is called; its arguments are ours.
            let arguments = |lower: &mut Self| {
                if is_value {
                    lower.path(&mut call.func);
                }
                call.args.iter_mut().for_each(|argument| drop(lower.lower(argument)));
            };
            return self.rust(text, differs, arguments);
        }
        let [argument] = &*call.args.iter().list() else {
            let message = format!("`{function}` takes one boolean expression: `{function}(a)`");
            self.resolver.sink.notation(Mark::of(&*call), message);
            return Tree::Bool(true);
        };
        if self.refuses_locals(argument, "an edge") {
            return Tree::Bool(true);
        }
        let of = resolve_condition(argument, self.resolver);
        let edge = self.resolver.edge(Edge { of });
        let read = if function == "rising" { Read::Rising(edge) } else { Read::Falling(edge) };
        self.replace(expr, read)
    }

    /// Whether a name is that of a declared value which may be a function; none of Rust's own types is one.
    fn can_be_called(&self, name: &Ident) -> bool {
        let Some(Meaning::Value(value)) = self.resolver.scope.get(name) else { return false };
        match self.resolver.model.ty(value) {
            Ty::Other(syn::Type::Path(path)) => {
                !matches!(path.path.get_ident(), Some(name) if name == "f32" || name == "f64" || name == "char")
            }
            Ty::Other(ty) => !matches!(ty, syn::Type::Array(_) | syn::Type::Slice(_) | syn::Type::Tuple(_)),
            _ => false,
        }
    }

    /// What is followed from cycle to cycle cannot look at names that live inside an expression.
    pub(super) fn refuses_locals(&mut self, of: &syn::Expr, what: &str) -> bool {
        let local = self.local_in(of.to_token_stream());
        if let Some(name) = &local {
            let message = format!(
                "`{name}` lives inside this expression, and {what} is followed from cycle to cycle: it can only look at \
                 declared names"
            );
            self.resolver.sink.notation(name, message);
        }
        local.is_some()
    }

    /// The first name in `tokens` that is bound here.
    pub(super) fn local_in(&self, tokens: TokenStream) -> Option<Ident> {
        let mut dot = false;
        tokens.into_iter().find_map(|tree| {
            let after_dot = std::mem::replace(&mut dot, matches!(&tree, TokenTree::Punct(p) if p.as_char() == '.'));
            match tree {
                TokenTree::Group(group) => self.local_in(group.stream()),
                TokenTree::Ident(name) if !after_dot && self.locals.contains(&name) => Some(name),
                _ => None,
            }
        })
    }

    /// `5s` alone; a literal of Rust stays.
    fn time_literal(&mut self, expr: &mut syn::Expr) -> Tree {
        let syn::Expr::Lit(lit) = &*expr else { return self.opaque(expr) };
        match self.resolver.literal_time(&lit.lit) {
            Some(ticks) => self.replace(expr, Read::Ticks(ticks)),
            None => Tree::Opaque {
                text: super::text::of(&*expr),
                reads: Vec::new(),
                call: None,
                whole: false,
                open: false,
                of: None,
            },
        }
    }
}

/// `relay` of the expression `relay`.
pub(super) fn single_name(expr: &syn::Expr) -> Option<Ident> {
    match expr {
        syn::Expr::Path(path) if path.qself.is_none() && path.attrs.is_empty() => path.path.get_ident().cloned(),
        _ => None,
    }
}

/// `Feed` or `Production::Feed` in front of `.X`.
pub(super) fn step_path(expr: &syn::Expr) -> Option<Vec<Ident>> {
    let syn::Expr::Path(path) = expr else { return None };
    let segments = &path.path.segments;
    let plain = path.qself.is_none() && segments.iter().all(|s| s.arguments.is_none());
    (plain && segments.len() <= 2).then(|| segments.iter().map(|s| s.ident.clone()).list())
}

/// Constants, types and variants of the surrounding Rust begin with an upper-case letter.
pub(super) fn looks_like_a_variable(name: &Ident) -> bool {
    !plain(name).trim_start_matches('_').starts_with(char::is_uppercase)
}

pub(super) fn literal(lit: &Lit) -> Option<Tree> {
    match lit {
        Lit::Bool(value) => Some(Tree::Bool(value.value)),
        Lit::Int(value) => {
            let suffix = value.suffix();
            let rust =
                suffix.is_empty() || suffix.starts_with(['i', 'u']) && !suffix.starts_with("us") || suffix == "usize";
            rust.then(|| value.base10_parse().ok().map(Tree::Int)).flatten()
        }
        _ => None,
    }
}

fn operator(op: &BinOp) -> Option<Binary> {
    Some(match op {
        BinOp::And(_) => Binary::And,
        BinOp::Or(_) => Binary::Or,
        BinOp::BitAnd(_) => Binary::BitAnd,
        BinOp::BitOr(_) => Binary::BitOr,
        BinOp::BitXor(_) => Binary::BitXor,
        BinOp::Eq(_) => Binary::Eq,
        BinOp::Ne(_) => Binary::Ne,
        BinOp::Lt(_) => Binary::Lt,
        BinOp::Le(_) => Binary::Le,
        BinOp::Gt(_) => Binary::Gt,
        BinOp::Ge(_) => Binary::Ge,
        BinOp::Add(_) => Binary::Add,
        BinOp::Sub(_) => Binary::Sub,
        BinOp::Mul(_) => Binary::Mul,
        BinOp::Div(_) => Binary::Div,
        BinOp::Rem(_) => Binary::Rem,
        BinOp::Shl(_) => Binary::Shl,
        BinOp::Shr(_) => Binary::Shr,
        _ => return None,
    })
}

/// Whether a declared value counts time.
pub(super) fn time_name(value: Name, resolver: &Resolver<'_>) -> Option<TimeRef> {
    match value {
        Name::Param(id) => matches!(resolver.model.params[id].ty, Ty::Time(_)).then_some(TimeRef::Param(id)),
        Name::Var(id) => matches!(resolver.model.vars[id].ty, Ty::Time(_)).then_some(TimeRef::Var(id)),
        Name::Input(_) | Name::Output(_) => None,
    }
}
