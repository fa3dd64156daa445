//! Rust blocks after a qualifier, an event or `=>`.

use proc_macro2::Ident;
use syn::punctuated::Punctuated;
use syn::{BinOp, Block, Stmt};

use super::Resolver;
use super::expr::Lower;
use super::scope::Meaning;
use crate::list::{List, PushAll};
use crate::methods;
use crate::model::{Binary, Code, Name, Place, Read, Statement, Tree};
use crate::visit::{self, Locals, Visit};

/// Resolves one block of the user.
pub(super) fn resolve(block: &Block, resolver: &mut Resolver<'_>) -> Code {
    let mut writes = Writes::new(resolver);
    visit::block(&mut writes, &mut block.clone());
    let Writes { places, unsure, by_reference, others, handed, .. } = writes;
    for name in others.into_iter().filter(|name| !handed.contains(name)) {
        resolver.refuse_target(&name);
    }

    let mut lower = Lower::new(resolver);
    let mut tokens = block.clone();
    visit::block(&mut lower, &mut tokens);
    let reads = std::mem::take(&mut lower.reads);
    let statements = statements(&mut block.clone(), &mut lower);
    let mut code = Code { tokens, statements, reads, writes: places, unsure: Vec::new(), text: super::text::of(block) };
    code.unsure.push_all(unsure.into_iter().filter(|(place, _)| !code.writes.contains(place)));
    if by_reference {
        // `ref mut x` in a pattern: whatever is matched may be written through it.
        let read = code.reads.iter().filter_map(|read| place_of(*read)).filter(|place| !code.writes.contains(place));
        code.unsure.push_all(read.map(|place| (place, "ref mut".to_owned())).list());
    }
    for (place, _) in &code.unsure {
        if !code.writes.contains(place) {
            code.writes.push(*place);
        }
    }
    code
}

fn place_of(read: Read) -> Option<Place> {
    match read {
        Read::Name(Name::Output(id)) => Some(Place::Output(id)),
        Read::Name(Name::Var(id)) => Some(Place::Var(id)),
        _ => None,
    }
}

/// The statements of a block, where all of them are understood.
fn statements(block: &mut Block, lower: &mut Lower<'_, '_>) -> Option<Vec<Statement>> {
    block.stmts.iter_mut().map(|stmt| statement(stmt, lower)).collect()
}

fn statement(stmt: &mut Stmt, lower: &mut Lower<'_, '_>) -> Option<Statement> {
    let Stmt::Expr(expr, _) = stmt else { return None };
    match expr {
        syn::Expr::Assign(assign) => {
            let place = lower.place(&assign.left)?;
            Some(Statement::Assign(place, lower.lower(&mut assign.right)))
        }
        syn::Expr::Binary(binary) => {
            let operator = compound(&binary.op)?;
            let place = lower.place(&binary.left)?;
            let old = lower.lower(&mut binary.left);
            let value = lower.lower(&mut binary.right);
            Some(Statement::Assign(place, Tree::Binary(operator, Box::new(old), Box::new(value))))
        }
        syn::Expr::If(branch) => {
            // `if let` binds names, also for what follows in the condition.
            lower.locals.enter();
            let condition = lower.lower(&mut branch.cond);
            let then = statements(&mut branch.then_branch, lower);
            lower.locals.leave();
            let then = then?;
            let otherwise = match &mut branch.else_branch {
                None => Vec::new(),
                Some((_, expr)) => match &mut **expr {
                    syn::Expr::Block(block) => statements(&mut block.block, lower)?,
                    other => vec![statement(&mut Stmt::Expr(other.clone(), None), lower)?],
                },
            };
            Some(Statement::If(condition, then, otherwise))
        }
        _ => None,
    }
}

/// Macros that look at their arguments as a function by `&` would.
const READING: &[&str] = &[
    "assert",
    "assert_eq",
    "assert_ne",
    "debug_assert",
    "debug_assert_eq",
    "debug_assert_ne",
    "print",
    "println",
    "eprint",
    "eprintln",
    "format",
    "format_args",
    "panic",
    "trace",
    "debug",
    "info",
    "warn",
    "error",
];

/// The operator of a compound assignment.
fn compound(op: &BinOp) -> Option<Binary> {
    Some(match op {
        BinOp::AddAssign(_) => Binary::Add,
        BinOp::SubAssign(_) => Binary::Sub,
        BinOp::MulAssign(_) => Binary::Mul,
        BinOp::DivAssign(_) => Binary::Div,
        BinOp::RemAssign(_) => Binary::Rem,
        BinOp::BitXorAssign(_) => Binary::BitXor,
        BinOp::BitAndAssign(_) => Binary::BitAnd,
        BinOp::BitOrAssign(_) => Binary::BitOr,
        BinOp::ShlAssign(_) => Binary::Shl,
        BinOp::ShrAssign(_) => Binary::Shr,
        _ => return None,
    })
}

/// The places a block may write.
struct Writes<'r, 's> {
    resolver: &'r Resolver<'s>,
    locals: Locals,
    /// Assigned or borrowed mutably.
    places: Vec<Place>,
    /// Handed to something that may write them, and to what: a method that nobody knows, or a macro.
    unsure: Vec<(Place, String)>,
    /// A pattern borrows mutably what it is compared with.
    by_reference: bool,
    /// What is assigned or borrowed mutably and is no place.
    others: Vec<Ident>,
    /// What macros are handed: they may declare a variable of that name.
    handed: Vec<Ident>,
}

impl<'r, 's> Writes<'r, 's> {
    fn new(resolver: &'r Resolver<'s>) -> Self {
        Self {
            resolver,
            locals: Locals::default(),
            places: Vec::new(),
            unsure: Vec::new(),
            by_reference: false,
            others: Vec::new(),
            handed: Vec::new(),
        }
    }

    fn place(&self, name: &Ident) -> Option<Place> {
        match self.resolver.scope.get(name) {
            _ if self.locals.contains(name) => None,
            Some(Meaning::Value(Name::Output(id))) => Some(Place::Output(id)),
            Some(Meaning::Value(Name::Var(id))) => Some(Place::Var(id)),
            _ => None,
        }
    }

    fn note(&mut self, expr: &syn::Expr) {
        if let Some(name) = methods::root(expr) {
            self.note_name(name);
        }
    }

    fn note_name(&mut self, name: &Ident) {
        match self.place(name) {
            Some(place) if self.places.contains(&place) => {}
            Some(place) => self.places.push(place),
            None if self.locals.contains(name) => {}
            // An assignment to a `let` is refused wherever it stands.
            None if matches!(self.resolver.scope.get(name), Some(Meaning::Let(_))) => {}
            None => self.others.push(name.clone()),
        }
    }

    fn note_unsure(&mut self, name: &Ident, what: &str) {
        if let Some(place) = self.place(name) {
            if !self.unsure.iter().any(|(known, _)| *known == place) {
                self.unsure.push((place, what.to_owned()));
            }
        }
    }

    fn note_call(&mut self, call: &syn::ExprMethodCall) {
        let Some(name) = methods::root(&call.receiver) else { return };
        let Some(place) = self.place(name) else { return };
        if !methods::only_reads(call, self.resolver.model.place_ty(place)) {
            self.note_unsure(name, &format!("{}.{}(…)", super::text::of(&call.receiver), call.method));
        }
    }

    fn note_tokens(&mut self, tokens: proc_macro2::TokenStream, call: &str) {
        for tree in tokens {
            match tree {
                proc_macro2::TokenTree::Group(group) => self.note_tokens(group.stream(), call),
                proc_macro2::TokenTree::Ident(name) => {
                    self.note_unsure(&name, call);
                    self.handed.push(name);
                }
                _ => {}
            }
        }
    }
}

impl Visit for Writes<'_, '_> {
    fn expr(&mut self, expr: &mut syn::Expr) {
        match expr {
            syn::Expr::Assign(assign) => {
                for name in methods::targets(&assign.left) {
                    self.note_name(name);
                }
            }
            syn::Expr::Binary(binary) if compound(&binary.op).is_some() => self.note(&binary.left),
            syn::Expr::Reference(reference) if reference.mutability.is_some() => self.note(&reference.expr),
            syn::Expr::RawAddr(address) if matches!(address.mutability, syn::PointerMutability::Mut(_)) => {
                self.note(&address.expr);
            }
            syn::Expr::MethodCall(call) => self.note_call(call),
            _ => {}
        }
        visit::inside(self, expr);
    }

    fn locals(&mut self) -> &mut Locals {
        &mut self.locals
    }

    fn call(&mut self, call: &mut syn::Macro) {
        let name = call.path.segments.last().map(|segment| segment.ident.to_string()).unwrap_or_default();
        let arguments = Punctuated::<syn::Expr, syn::Token![,]>::parse_terminated;
        if let (true, Ok(arguments)) = (READING.contains(&&*name), call.parse_body_with(arguments)) {
            for mut argument in arguments {
                match &mut argument {
                    // A name for the text: `{n}`, `n = count`.
                    syn::Expr::Assign(named) => self.expr(&mut named.right),
                    argument => self.expr(argument),
                }
            }
            return;
        }
        let text = format!("{}!(…)", super::text::of(&call.path));
        self.note_tokens(call.tokens.clone(), &text);
    }

    fn binding(&mut self, pattern: &syn::PatIdent) {
        self.by_reference |= pattern.by_ref.is_some() && pattern.mutability.is_some();
    }
}
