//! SCL of TIA Portal: an external source. What belongs to a block has `#` in front, what stands beside it quotation marks around it.

use std::collections::BTreeSet;

use super::words::{Word, words};
use super::{change, named, parts};
use crate::st::syntax::{Program, Stub, Variable, comment, declare, nothing, push, statements};

/// Types of 64 bits.
const WIDE: [&str; 2] = ["LINT", "ULINT"];

pub(super) fn text(mut program: Program) -> String {
    named(&mut program.header, "for TIA Portal (SCL)");
    program.header.extend(notes(&program));
    let outside: BTreeSet<String> = program.stubs.iter().map(|stub| stub.name.clone()).collect();
    let functions: BTreeSet<String> =
        program.stubs.iter().filter(|stub| stub.ty.is_some()).map(|stub| stub.name.clone()).collect();
    let inside: BTreeSet<String> = [&program.inputs, &program.outputs, &program.variables]
        .into_iter()
        .flatten()
        .map(|variable| variable.name.clone())
        .collect();
    let marked = |text: &str| -> String {
        let one = |word: Word<'_>| match word {
            Word::Called(name) if functions.contains(name) => format!("\"{name}\""),
            Word::Name(name) | Word::Called(name) if inside.contains(name) => format!("#{name}"),
            other => other.text().to_owned(),
        };
        words(text).into_iter().map(one).collect()
    };
    change(&mut program.body, &|target, value| {
        for text in target.into_iter().chain([value]) {
            *text = marked(text);
        }
    });
    for variable in &mut program.variables {
        declared(variable, &outside);
    }
    let mut text = String::new();
    for line in &program.header {
        push(&mut text, 0, &comment(line));
    }
    for stub in &program.stubs {
        text.push('\n');
        to_write(stub, &mut text);
    }
    text.push('\n');
    begin(&mut text, &format!("FUNCTION_BLOCK \"{}\"", program.name));
    let sections = [("VAR_INPUT", &program.inputs), ("VAR_OUTPUT", &program.outputs), ("VAR", &program.variables)];
    for (keyword, variables) in sections {
        declare(&mut text, keyword, variables);
    }
    text.push('\n');
    push(&mut text, 0, "BEGIN");
    for (index, (heading, part)) in parts(&program.body).into_iter().enumerate() {
        if index > 0 {
            text.push('\n');
        }
        let depth = usize::from(heading.is_some());
        if let Some(heading) = heading {
            push(&mut text, 0, &format!("REGION {heading}"));
        }
        statements(&mut text, depth, part);
        if heading.is_some() {
            push(&mut text, 0, "END_REGION");
        }
    }
    push(&mut text, 0, "END_FUNCTION_BLOCK");
    text
}

/// What has to be known of it there.
fn notes(program: &Program) -> Vec<String> {
    let mut notes = vec!["An external source: add it to the project, and let blocks be generated from it.".to_owned()];
    let all = || [&program.inputs, &program.outputs, &program.variables].into_iter().flatten();
    if all().any(|variable| variable.ty == "TON") {
        notes.push("A timer there reads the clock whenever its ET is read, and not only when it is called: within a scan it can go on.".to_owned());
    }
    if all().any(|variable| WIDE.contains(&variable.ty.as_str())) {
        notes.push("Numbers of 64 bits: an S7-1500 has them, an S7-1200 has not.".to_owned());
    }
    notes
}

fn declared(variable: &mut Variable, outside: &BTreeSet<String>) {
    if variable.ty == "TON" {
        variable.name.push_str(" {InstructionName := 'TON_TIME'; LibVersion := '1.0'}");
        "TON_TIME".clone_into(&mut variable.ty);
    } else if outside.contains(&variable.ty) {
        variable.ty = format!("\"{}\"", variable.ty);
    }
}

fn begin(text: &mut String, title: &str) {
    push(text, 0, title);
    push(text, 0, "{ S7_Optimized_Access := 'TRUE' }");
    push(text, 0, "VERSION : 0.1");
}

fn to_write(stub: &Stub, text: &mut String) {
    let (title, end, value) = match &stub.ty {
        Some(ty) => {
            let nothing = nothing(ty);
            let title = format!("FUNCTION \"{}\" : {ty}", stub.name);
            (title, "END_FUNCTION", format!("#{} := {nothing};", stub.name))
        }
        None => (format!("FUNCTION_BLOCK \"{}\"", stub.name), "END_FUNCTION_BLOCK", ";".to_owned()),
    };
    begin(text, &title);
    declare(text, "VAR_INPUT", &stub.inputs);
    push(text, 0, "BEGIN");
    push(text, 1, &comment(&format!("TO BE WRITTEN, in Rust: {}", stub.rust)));
    push(text, 1, &value);
    push(text, 0, end);
}
