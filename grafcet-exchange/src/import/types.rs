//! Types that a file declares: enums, and other names for types.

use std::collections::BTreeSet;

use roxmltree::Document;

use super::Wrong;
use super::lexer::{Token, lex};
use super::names::{Names, camel};
use super::parser::Cursor;
use super::source::{Pou, same};
use super::xml::{child, children, is};

/// A type as it stands in a file.
#[derive(Clone, Debug)]
pub(super) struct Type {
    pub(super) name: String,
    pub(super) what: Declared,
}

#[derive(Clone, Debug)]
pub(super) enum Declared {
    /// Values, with the numbers that stand there, and the name of the initial one.
    Enum(Vec<(String, Option<i128>)>, Option<String>),
    /// Another name for a type.
    Alias(String),
}

/// An enum in Rust.
#[derive(Clone, Debug)]
pub(super) struct Enum {
    pub(super) name: String,
    pub(super) rust: String,
    /// In the file, in Rust, and its number.
    pub(super) values: Vec<(String, String, i128)>,
    /// Where they are not counted from zero.
    pub(super) numbered: bool,
    /// By its place among the values.
    pub(super) initial: usize,
}

impl Enum {
    pub(super) fn value(&self, name: &str) -> Option<String> {
        let (_, rust, _) = self.values.iter().find(|(there, ..)| same(there, name))?;
        Some(format!("{}::{rust}", self.rust))
    }

    /// The declaration.
    pub(super) fn lines(&self) -> Vec<String> {
        let mut lines = vec!["#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]".to_owned()];
        lines.push(format!("pub enum {} {{", self.rust));
        for (index, (_, rust, number)) in self.values.iter().enumerate() {
            lines.extend((index == self.initial).then(|| "    #[default]".to_owned()));
            let number = if self.numbered { format!(" = {number}") } else { String::new() };
            lines.push(format!("    {rust}{number},"));
        }
        lines.push("}".to_owned());
        lines
    }

    /// What is called otherwise than in the file.
    pub(super) fn renamed(&self) -> Vec<(String, String)> {
        let mut renamed = vec![(self.name.clone(), self.rust.clone())];
        renamed.extend(self.values.iter().map(|(there, here, _)| (there.clone(), format!("{}::{here}", self.rust))));
        renamed.retain(|(there, here)| here.rsplit("::").next() != Some(there));
        renamed
    }
}

/// After `TYPE`, up to `END_TYPE`. What is no enum and no other name is passed over.
pub(super) fn textual(cursor: &mut Cursor<'_>, text: &str) -> Vec<Type> {
    let mut types = Vec::new();
    while cursor.peek().is_some() && !cursor.word("end_type") {
        let begin = cursor.at;
        if let Some(one) = one(cursor, text) {
            types.push(one);
            continue;
        }
        // A structure has semicolons of its own.
        cursor.at = begin;
        let mut structures = 0_usize;
        while cursor.peek().is_some() && !cursor.is_word("end_type") {
            structures += usize::from(cursor.is_word("struct"));
            structures = structures.saturating_sub(usize::from(cursor.is_word("end_struct")));
            let ends = cursor.sign(";");
            cursor.at += usize::from(!ends);
            if ends && structures == 0 {
                break;
            }
        }
    }
    types
}

/// `Mode : (Off, Auto := 3) INT := Off;`, `Speed : INT;`
fn one(cursor: &mut Cursor<'_>, text: &str) -> Option<Type> {
    let name = cursor.name().ok()?;
    cursor.need(":").ok()?;
    if let Some(values) = values(cursor) {
        if !matches!(cursor.peek(), Some(Token::Sign(":=" | ";"))) {
            cursor.name().ok()?;
        }
        let initial = if cursor.sign(":=") { Some(short(&cursor.name().ok()?)) } else { None };
        cursor.need(";").ok()?;
        return Some(Type { name, what: Declared::Enum(values, initial) });
    }
    let from = cursor.here().start;
    let other = cursor.name().ok()?;
    let plain = text.get(from..cursor.before().end)?.eq_ignore_ascii_case(&other) && !same(&other, "struct");
    cursor.need(";").ok()?;
    plain.then_some(Type { name, what: Declared::Alias(other) })
}

/// `(Off, Auto := 3)`
fn values(cursor: &mut Cursor<'_>) -> Option<Vec<(String, Option<i128>)>> {
    if !cursor.sign("(") {
        return None;
    }
    let mut values = Vec::new();
    loop {
        let name = short(&cursor.name().ok()?);
        let mut number = None;
        if cursor.sign(":=") {
            let minus = cursor.sign("-");
            let Some(Token::Int(value)) = cursor.peek() else { return None };
            number = Some(if minus { -value } else { *value });
            cursor.at += 1;
        }
        values.push((name, number));
        if !cursor.sign(",") {
            break;
        }
    }
    cursor.sign(")").then_some(values)
}

/// `Auto` of `Mode#Auto`
fn short(name: &str) -> String {
    name.rsplit('#').next().unwrap_or(name).to_owned()
}

/// The `dataType`s of PLCopen XML.
pub(super) fn of_xml(text: &str) -> Vec<Type> {
    let Ok(document) = Document::parse(text) else { return Vec::new() };
    let declared = document.descendants().filter(|node| is(node, "dataType"));
    let one = |node: roxmltree::Node<'_, '_>| {
        let name = node.attribute("name")?.to_owned();
        let base = child(node, "baseType")?.first_element_child()?;
        let initial = child(node, "initialValue").and_then(|value| child(value, "simpleValue"));
        let initial = initial.and_then(|value| value.attribute("value")).map(short);
        let what = match base.tag_name().name() {
            "enum" => {
                let all = children(child(base, "values")?, "value");
                let one = |value: roxmltree::Node<'_, '_>| {
                    let number = value.attribute("value").and_then(|number| number.trim().parse().ok());
                    Some((value.attribute("name")?.trim().to_owned(), number))
                };
                Declared::Enum(all.map(one).collect::<Option<_>>()?, initial.map(|name| after(&name, '.')))
            }
            "derived" => Declared::Alias(base.attribute("name")?.to_owned()),
            "array" | "struct" | "subrangeSigned" | "subrangeUnsigned" | "string" | "wstring" | "pointer" => {
                return None;
            }
            other => Declared::Alias(other.to_owned()),
        };
        Some(Type { name, what })
    };
    declared.filter_map(one).collect()
}

fn after(name: &str, sign: char) -> String {
    name.rsplit(sign).next().unwrap_or(name).to_owned()
}

/// Each variable gets the type that another name stands for, and each program the enums of the file, those that stand at a variable among them.
pub(super) fn settle(pous: &mut [Pou], mut types: Vec<Type>) -> Result<(), Wrong> {
    for pou in &mut *pous {
        for variable in pou.variables.iter_mut().filter(|variable| variable.ty.starts_with('(')) {
            let lexed = lex(&variable.ty, 0)?;
            let mut cursor = Cursor::new(&lexed, variable.at.clone());
            let Some(values) = values(&mut cursor).filter(|_| cursor.end().is_ok()) else { continue };
            let name = format!("{}_{}", pou.name, variable.name);
            types.push(Type { name: name.clone(), what: Declared::Enum(values, None) });
            variable.ty = name;
        }
    }
    let mut taken: BTreeSet<String> =
        pous.iter().filter(|pou| !pou.steps.is_empty()).map(|pou| camel(&pou.name)).collect();
    let mut enums: Vec<Enum> = Vec::new();
    for one in &types {
        let Declared::Enum(values, initial) = &one.what else { continue };
        if !values.is_empty() && !enums.iter().any(|other| same(&other.name, &one.name)) {
            let mut rust = camel(&one.name);
            while !taken.insert(rust.clone()) {
                rust.push_str("Type");
            }
            enums.push(in_rust(&one.name, rust, values, initial.as_deref()));
        }
    }
    for pou in pous {
        for variable in &mut pou.variables {
            // Names for names, but not for ever.
            for _ in 0..types.len() {
                let other = types.iter().find(|one| same(&one.name, &variable.ty));
                let Some(Type { what: Declared::Alias(other), .. }) = other else { break };
                variable.ty.clone_from(other);
            }
        }
        pou.enums.clone_from(&enums);
    }
    Ok(())
}

fn in_rust(name: &str, rust: String, values: &[(String, Option<i128>)], initial: Option<&str>) -> Enum {
    let mut names = Names::new();
    let mut next = 0;
    let mut done = Vec::new();
    for (value, number) in values {
        let number = number.unwrap_or(next);
        next = number.saturating_add(1);
        done.push((value.clone(), names.step(value), number));
    }
    let counted = done.iter().zip(0..).all(|((.., number), index)| *number == index);
    // Rust has no two variants of one number.
    let numbers: BTreeSet<i128> = done.iter().map(|(.., number)| *number).collect();
    let fits = numbers.len() == done.len() && numbers.iter().all(|number| i32::try_from(*number).is_ok());
    let initial = initial.and_then(|name| values.iter().position(|(other, _)| same(other, name)));
    Enum { name: name.to_owned(), rust, values: done, numbered: !counted && fits, initial: initial.unwrap_or(0) }
}
