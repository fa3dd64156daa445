//! Values of enums whose variants the chart lists: `input mode: Mode in {Off, Auto, Manual};`
//!
//! A variant is a number to whoever reasons about conditions: its place in the list. That the list is the whole enum, and that
//! the paths in comparisons mean it, is left to a `match` in the generated code.

use proc_macro2::Ident;
use syn::parse::ParseStream;
use syn::{Pat, Path, Token};

use super::expr::{Lower, single_name};
use super::scope::Meaning;
use super::{Resolver, text};
use crate::ast::{self, DeclKind};
use crate::model::{Binary, Name, Read, Tree, Ty, Variants};

impl Resolver<'_> {
    /// Takes down what stands after `in` of a declaration.
    pub(super) fn variants(&mut self, decl: &ast::Decl, names: Vec<Name>, ty: &Ty) {
        let Some(variants) = &decl.variants else { return };
        if decl.kind == DeclKind::Output {
            let message = "the variants of an output are not looked at: conditions read inputs, variables and parameters; leave \
                           this out";
            return self.sink.notation(variants.keyword, message);
        }
        for (index, variant) in variants.list.iter().enumerate() {
            if variants.list[..index].iter().any(|other| other.name == variant.name) {
                self.sink.notation(&variant.name, format!("`{}` is listed twice; delete one of them", variant.name));
            }
        }
        let path = match ty {
            Ty::Other(syn::Type::Path(path)) if path.qself.is_none() && !ty.is_float() => Some(&path.path),
            _ => None,
        };
        let Some(path) = path else {
            let message = "only an enum has variants; give its name, as in `Mode in {Off, Auto}`, or leave this out";
            return self.sink.notation(variants.keyword, message);
        };
        let mut path = path.clone();
        for segment in &mut path.segments {
            segment.arguments = syn::PathArguments::None;
        }
        let list = variants.list.clone();
        self.model.variants.push(Variants { names, path, list, others: Vec::new(), compared: None });
    }
}

impl Lower<'_, '_> {
    /// Whether a value of a type of the program is compared with a step: with a variant that is called so, most likely.
    pub(super) fn compares_with_step(&mut self, operator: Binary, binary: &syn::ExprBinary) -> bool {
        let meaning = |expr: &syn::Expr| {
            let name = single_name(expr).filter(|name| !self.locals.contains(name))?;
            Some((self.resolver.scope.get(&name)?, name))
        };
        let (left, right) = (meaning(&binary.left), meaning(&binary.right));
        let ((Some((Meaning::Value(value), _)), Some((Meaning::Step(_) | Meaning::Macro(_), step)))
        | (Some((Meaning::Step(_) | Meaning::Macro(_), step)), Some((Meaning::Value(value), _)))) = (left, right)
        else {
            return false;
        };
        let Ty::Other(syn::Type::Path(ty)) = self.resolver.model.ty(value) else { return false };
        let Some(enumeration) = ty.path.segments.last().map(|last| last.ident.to_string()) else { return false };
        if !matches!(operator, Binary::Eq | Binary::Ne) || self.resolver.model.ty(value).is_float() {
            return false;
        }
        let message = format!(
            "`{step}` is a step here, also where a variant of `{enumeration}` is called so; write the variant with its enum: \
             `{enumeration}::{step}`"
        );
        self.resolver.sink.notation(&step, message);
        true
    }

    /// The operands of a comparison, where one of them may be a value with listed variants.
    pub(super) fn compared(&mut self, operator: Binary, binary: &syn::ExprBinary, sides: (Tree, Tree)) -> (Tree, Tree) {
        let (left, right) = sides;
        let right = self.against(operator, &left, &binary.right, right);
        let left = self.against(operator, &right, &binary.left, left);
        (left, right)
    }

    /// What a value is compared with.
    fn against(&mut self, operator: Binary, value: &Tree, written: &syn::Expr, other: Tree) -> Tree {
        let Tree::Read(Read::Name(name)) = value else { return other };
        if self.resolver.model.variants_of(*name).is_none() {
            return other;
        }
        let variant = match written {
            syn::Expr::Path(path) if path.qself.is_none() && matches!(operator, Binary::Eq | Binary::Ne) => {
                self.variant(*name, &path.path, false)
            }
            _ => None,
        };
        if let Some(index) = variant {
            let known = self.resolver.model.variants.iter_mut().find(|variants| variants.names.contains(name));
            if let Some(known) = known {
                known.compared.get_or_insert(index);
            }
            return number(index);
        }
        // A number that the user wrote is none of ours.
        match other {
            Tree::Int(_) => Tree::Opaque {
                text: text::of(written),
                reads: Vec::new(),
                call: None,
                whole: false,
                open: false,
                of: None,
            },
            other => other,
        }
    }

    /// `matches!(mode, Mode::Auto | Mode::Manual)`; none where that is not all that it asks.
    pub(super) fn matched(&mut self, expr: &syn::Expr) -> Option<Tree> {
        let syn::Expr::Macro(call) = expr else { return None };
        if call.mac.path.segments.last()?.ident != "matches" {
            return None;
        }
        let (value, pattern) = call.mac.parse_body_with(value_and_pattern).ok()?;
        let value = single_name(&value).filter(|name| !self.locals.contains(name))?;
        let Some(Meaning::Value(name)) = self.resolver.scope.get(&value) else { return None };
        self.resolver.model.variants_of(name)?;
        let mut found = Vec::new();
        self.pattern(name, &pattern, &mut found)?;
        let value = || Box::new(Tree::Read(Read::Name(name)));
        let is = |index: usize| Tree::Binary(Binary::Eq, value(), Box::new(number(index)));
        found.into_iter().map(is).reduce(|a, b| Tree::Binary(Binary::Or, Box::new(a), Box::new(b)))
    }

    /// The variants that a pattern takes, whatever they carry.
    fn pattern(&mut self, name: Name, pattern: &Pat, found: &mut Vec<usize>) -> Option<()> {
        match pattern {
            Pat::Or(or) => or.cases.iter().try_for_each(|case| self.pattern(name, case, found)),
            Pat::Paren(paren) => self.pattern(name, &paren.pat, found),
            Pat::Path(path) if path.qself.is_none() => {
                found.push(self.variant(name, &path.path, false)?);
                Some(())
            }
            Pat::TupleStruct(tuple) if tuple.elems.iter().all(|part| matches!(part, Pat::Rest(_) | Pat::Wild(_))) => {
                found.push(self.variant(name, &tuple.path, true)?);
                Some(())
            }
            Pat::Struct(fields) if fields.fields.is_empty() => {
                found.push(self.variant(name, &fields.path, true)?);
                Some(())
            }
            _ => None,
        }
    }

    /// The place of `Mode::Auto` in the list of a value's variants.
    fn variant(&mut self, name: Name, path: &Path, with_data: bool) -> Option<usize> {
        let mut of = path.clone();
        let last = of.segments.pop()?;
        of.segments.pop_punct();
        let plain = last.arguments.is_none() && of.segments.iter().all(|segment| segment.arguments.is_none());
        let variants = self.resolver.model.variants.iter_mut().find(|variants| variants.names.contains(&name))?;
        let same = |a: Option<&Ident>, b: Option<&Ident>| a.is_some() && a == b;
        let ty = |path: &Path| path.segments.last().map(|segment| segment.ident.clone());
        if !plain || !same(ty(&of).as_ref(), ty(&variants.path).as_ref()) {
            return None;
        }
        let index = variants.list.iter().position(|variant| variant.name == last.ident)?;
        if variants.list[index].has_data != with_data && !with_data {
            return None;
        }
        let written = text::of(&of);
        if written != text::of(&variants.path) && !variants.others.iter().any(|other| text::of(other) == written) {
            variants.others.push(of);
        }
        Some(index)
    }
}

fn number(index: usize) -> Tree {
    Tree::Int(i128::try_from(index).unwrap_or(0))
}

/// `mode, Mode::Auto | Mode::Manual`, without a guard.
fn value_and_pattern(input: ParseStream<'_>) -> syn::Result<(syn::Expr, Pat)> {
    let value = input.parse()?;
    input.parse::<Token![,]>()?;
    let pattern = Pat::parse_multi_with_leading_vert(input)?;
    input.parse::<Option<Token![,]>>()?;
    if input.is_empty() { Ok((value, pattern)) } else { Err(input.error("a guard")) }
}
