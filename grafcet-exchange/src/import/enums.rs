//! Values of enums, and types by their names.

use super::expr::{Kind, Rust, Scope};
use super::parser::Expr;
use super::source::same;

impl Scope<'_> {
    /// The enum that has a value of this name: the one that is wanted, else the only one.
    pub(super) fn listed(&self, name: &str, wanted: Option<Kind>) -> Option<usize> {
        let mut all = self.enums.iter().enumerate().filter(|(_, one)| one.value(name).is_some()).map(|(of, _)| of);
        if let Some(Kind::Enum(of)) = wanted {
            return all.find(|one| *one == of);
        }
        let first = all.next()?;
        all.next().is_none().then_some(first)
    }

    pub(super) fn variant(&mut self, of: usize, name: &str) -> Result<Rust, String> {
        let value = self.enums.get(of).and_then(|one| one.value(name));
        self.used.insert(of);
        value.map(Rust::word).ok_or_else(|| format!("`{}` has no value `{name}`", self.enums[of].name))
    }

    /// The initial value of an enum.
    pub(super) fn first(&mut self, of: usize) -> String {
        self.used.insert(of);
        let one = &self.enums[of];
        format!("{}::{}", one.rust, one.values[one.initial].1)
    }

    /// The value of an enum that has a number.
    pub(super) fn numbered(&mut self, value: i128, wanted: Option<Kind>) -> Result<Rust, String> {
        let Some(Kind::Enum(of)) = wanted else { return Err("no enum".to_owned()) };
        let found = self.enums[of].values.iter().find(|(.., number)| *number == value);
        match found.map(|(there, ..)| there.clone()) {
            Some(name) => self.variant(of, &name),
            None => Err(format!("`{}` has no value with the number {value}", self.enums[of].name)),
        }
    }

    /// The type in Rust.
    pub(super) fn type_of(&self, kind: Kind) -> String {
        match kind {
            Kind::Bool => "bool".to_owned(),
            Kind::Time => "time".to_owned(),
            Kind::Number(name) => name.to_owned(),
            Kind::Enum(of) => self.enums[of].rust.clone(),
        }
    }

    /// Of a type of the standard or of the file.
    pub(super) fn kind_of(&self, ty: &str) -> Option<Kind> {
        Kind::of(ty).or_else(|| self.enums.iter().position(|one| same(&one.name, ty)).map(Kind::Enum))
    }

    /// A value of a type that is wanted, widened where nothing of it can be lost.
    pub(super) fn operand(&mut self, expr: &Expr, wanted: Option<Kind>) -> Result<Rust, String> {
        match (self.kind(expr), wanted) {
            (Some(own), Some(wanted)) if own != wanted => {
                if self.common(Some(own), Some(wanted))? != Some(wanted) {
                    return Err(self.two_types(own, wanted));
                }
                let value = self.expr(expr, Some(own))?.0;
                Ok(Rust::word(format!("{}::from({value})", self.type_of(wanted))))
            }
            _ => self.expr(expr, wanted),
        }
    }

    /// The type of what is computed of two.
    pub(super) fn common(&self, one: Option<Kind>, other: Option<Kind>) -> Result<Option<Kind>, String> {
        match (one, other) {
            (Some(one), Some(other)) if one == other || is_wider(one, other) => Ok(Some(one)),
            (Some(one), Some(other)) if is_wider(other, one) => Ok(Some(other)),
            (Some(one), Some(other)) => Err(self.two_types(one, other)),
            _ => Ok(one.or(other)),
        }
    }

    fn two_types(&self, one: Kind, other: Kind) -> String {
        let (one, other) = (self.type_of(one), self.type_of(other));
        format!("{one} and {other} are two types, and Rust would need to be told how one becomes the other")
    }
}

/// Whether the first one has all values of the second, so that Rust makes one of the other.
fn is_wider(one: Kind, other: Kind) -> bool {
    let (Kind::Number(one), Kind::Number(other)) = (one, other) else { return false };
    let width = |name: &str| name[1..].parse::<u32>().unwrap_or_default();
    let (wide, narrow) = (width(one), width(other));
    match (&one[..1], &other[..1]) {
        ("i", "i" | "u") | ("u", "u") | ("f", "f") => wide > narrow,
        // As many bits as a float keeps exactly.
        ("f", "i" | "u") => wide >= 2 * narrow,
        _ => false,
    }
}
