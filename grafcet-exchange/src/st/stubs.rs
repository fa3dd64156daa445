//! Functions of the program, which a person has to write.

use std::collections::BTreeSet;

use grafcet_compiler::model::Read;

use super::expr::{At, Kind, Scope, kind_of, refuse};
use super::syntax::{Stub, Variable};
use super::text::Text;
use crate::Refused;

impl Scope<'_> {
    /// A function that a person has to write.
    pub(super) fn opaque(&mut self, text: &str, reads: &[Read], wanted: &Kind, at: &At<'_>) -> Result<Text, Refused> {
        let mut inputs = Vec::new();
        let mut given = BTreeSet::new();
        for read in reads {
            let Read::Name(name) = read else {
                let what = format!("`{text}`, which reads more than declared values,");
                return Err(refuse(at, &what, "move the rest out of it"));
            };
            let Some(kind) = kind_of(self.model, *name) else {
                return Err(refuse(at, &format!("`{text}`"), "the type of what it reads is one of the program"));
            };
            let value = self.read(*read, at)?.text;
            if given.insert(*name) {
                inputs.push((Variable::new(self.name(*name), kind.name()), value));
            }
        }
        if *wanted == Kind::Number {
            return Err(refuse(
                at,
                &format!("`{text}`, whose type the chart does not tell,"),
                "compare it with a declared value",
            ));
        }
        let name = match self.called.get(text) {
            Some(name) => name.clone(),
            None => {
                let name = self.names.own(&function(text));
                self.called.insert(text.to_owned(), name.clone());
                let inputs = inputs.iter().map(|(variable, _)| variable.clone()).collect();
                let ty = Some(wanted.name().to_owned());
                self.stubs.push(Stub { name: name.clone(), ty, inputs, rust: text.to_owned() });
                name
            }
        };
        let given: Vec<String> =
            inputs.iter().map(|(variable, value)| format!("{} := {value}", variable.name)).collect();
        Ok(Text::word(format!("{name}({})", given.join(", "))))
    }
}

/// `valid` of `sensors::valid(level)`.
fn function(text: &str) -> String {
    let before = text.split(['(', '{', '[', ' ']).next().unwrap_or_default();
    let name = before.rsplit([':', '.']).next().unwrap_or_default().trim_end_matches('!');
    if name.is_empty() { "rust".to_owned() } else { name.to_owned() }
}
