//! Functions that the standard has for what Rust writes as a method or as an `if`: `MIN`, `MAX`, `SEL`.

use grafcet_compiler::model::{Computed, How, Tree};

use super::expr::{At, Kind, Scope};
use super::text::Text;
use crate::Refused;

/// Whether there is a function for it.
pub(super) fn is_one(computed: &Computed) -> bool {
    matches!((computed.how, &computed.operands[..]), (How::Min | How::Max, [_, _]) | (How::Clamp | How::If, [_, _, _]))
}

/// The operands that are of its own type.
pub(super) fn values(computed: &Computed) -> &[Tree] {
    if computed.how == How::If { &computed.operands[1..] } else { &computed.operands }
}

impl Scope<'_> {
    /// A PLC evaluates both values of a `SEL`, of which one is taken.
    pub(super) fn function(&mut self, computed: &Computed, wanted: &Kind, at: &At<'_>) -> Result<Text, Refused> {
        let value = |scope: &mut Self, tree: &Tree| scope.tree(tree, wanted, at).map(|text| text.text);
        let texts = values(computed).iter().map(|tree| value(self, tree)).collect::<Result<Vec<String>, _>>()?;
        let pair = |function: &str, one: &str, other: &str| format!("{function}(IN1 := {one}, IN2 := {other})");
        Ok(Text::word(match (computed.how, &texts[..]) {
            (How::If, [then, otherwise]) => {
                let condition = self.tree(&computed.operands[0], &Kind::Bool, at)?.text;
                format!("SEL(G := {condition}, IN0 := {otherwise}, IN1 := {then})")
            }
            (How::Clamp, [value, low, high]) => pair("MIN", &pair("MAX", value, low), high),
            (How::Max, [one, other]) => pair("MAX", one, other),
            (_, texts) => pair("MIN", &texts[0], &texts[1]),
        }))
    }
}
