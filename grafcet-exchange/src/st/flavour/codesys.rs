//! CODESYS: regions and warnings as pragmas, and a word where a number gets narrower.

use std::collections::BTreeMap;

use super::words::{Word, words};
use super::{change, named, parts};
use crate::st::syntax::{Program, Stub, comment, declare, nothing, push, statements};

/// What is narrower than the numbers that CODESYS computes with.
const NARROW: [&str; 5] = ["SINT", "USINT", "INT", "UINT", "REAL"];

pub(super) fn text(mut program: Program) -> String {
    named(&mut program.header, "for CODESYS 3.5");
    program.header.push("In CODESYS the declaration of a block, up to its last END_VAR, and what follows have editors of their own, and neither has the last line.".to_owned());
    let all = [&program.inputs, &program.outputs, &program.variables];
    let narrow: BTreeMap<String, String> = all
        .into_iter()
        .flatten()
        .filter(|variable| NARROW.contains(&variable.ty.as_str()))
        .map(|variable| (variable.name.clone(), variable.ty.clone()))
        .collect();
    change(&mut program.body, &|target, value| {
        let Some(ty) = target.and_then(|target| narrow.get(target)) else { return };
        if words(value).iter().any(|word| matches!(word, Word::Operator(_))) {
            *value = format!("TO_{ty}({value})");
        }
    });
    let mut text = String::new();
    for line in &program.header {
        push(&mut text, 0, &comment(line));
    }
    for stub in &program.stubs {
        text.push('\n');
        to_write(stub, &mut text);
    }
    text.push('\n');
    push(&mut text, 0, &format!("FUNCTION_BLOCK {}", program.name));
    let sections = [("VAR_INPUT", &program.inputs), ("VAR_OUTPUT", &program.outputs), ("VAR", &program.variables)];
    for (keyword, variables) in sections {
        declare(&mut text, keyword, variables);
    }
    for (heading, part) in parts(&program.body) {
        text.push('\n');
        if let Some(heading) = heading {
            push(&mut text, 0, &format!("{{region \"{heading}\"}}"));
        }
        statements(&mut text, 0, part);
        if heading.is_some() {
            push(&mut text, 0, "{endregion}");
        }
    }
    push(&mut text, 0, "END_FUNCTION_BLOCK");
    text
}

/// A build warns as long as nobody has written it.
fn to_write(stub: &Stub, text: &mut String) {
    let (begin, end, value) = match &stub.ty {
        Some(ty) => {
            let nothing = nothing(ty);
            (format!("FUNCTION {} : {ty}", stub.name), "END_FUNCTION", format!("{} := {nothing};", stub.name))
        }
        None => (format!("FUNCTION_BLOCK {}", stub.name), "END_FUNCTION_BLOCK", ";".to_owned()),
    };
    push(text, 0, &begin);
    declare(text, "VAR_INPUT", &stub.inputs);
    push(text, 0, &format!("{{warning '{} is to be written'}}", stub.name));
    push(text, 0, &comment(&format!("in Rust: {}", stub.rust)));
    push(text, 0, &value);
    push(text, 0, end);
}
