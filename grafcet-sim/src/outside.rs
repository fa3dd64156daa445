//! What the program around a chart has to tell: Rust that the chart's source does not.

use grafcet_compiler::model::{Binary, Computed, Effect, How, Model, Read, Statement, Tree};

use crate::chart::Chart;
use crate::interp::is_literal;
use crate::names::{Kind, Signal, kind, kind_of};

impl Chart {
    /// What a simulation asks its [`Program`](crate::Program) for: functions and constants of the program, each under its own text, and what values
    /// it has by what it is compared with, or given to. A condition is a `bool`; a number of which nothing more is known, an `i64`.
    #[must_use]
    pub fn outside(&self) -> Vec<Signal> {
        let model = self.model();
        let mut search = SignalSearch { model, found: Vec::new() };
        for transition in model.transitions.values() {
            // What `modes;` makes of a condition asks what is written.
            search.tree(transition.own_condition(), &Kind::Bool);
            search.tree(&transition.condition.tree, &Kind::Bool);
            transition.clearing.iter().for_each(|effect| search.effect(effect));
        }
        for association in model.associations.values() {
            let conditions = association.condition.iter().chain(&association.event);
            conditions.for_each(|condition| search.tree(&condition.tree, &Kind::Bool));
            search.effect(&association.effect);
        }
        let sampled = model.edges.values().map(|edge| &edge.of).chain(model.delays.values().map(|delay| &delay.of));
        sampled.for_each(|condition| search.tree(&condition.tree, &Kind::Bool));
        search.found
    }

    /// The blocks of Rust that a simulation does not look into, as written: what they write, a [`Program`](crate::Program) has to tell.
    #[must_use]
    pub fn blocks(&self) -> Vec<String> {
        let model = self.model();
        let mut texts = Vec::new();
        for effect in model.effects() {
            let Effect::Block(code) = effect else { continue };
            if code.statements.is_none() && !texts.contains(&code.text) {
                texts.push(code.text.clone());
            }
        }
        texts
    }
}

/// Looks for what the program around has to tell.
struct SignalSearch<'m> {
    model: &'m Model,
    found: Vec<Signal>,
}

impl SignalSearch<'_> {
    fn effect(&mut self, effect: &Effect) {
        match effect {
            Effect::Control(_) => {}
            Effect::Assign(place, value) => self.tree(&value.tree, &kind(self.model, (*place).into())),
            Effect::Call(action, args) => {
                let model = self.model;
                for (arg, (_, ty)) in args.iter().zip(&model.actions[*action].params) {
                    self.tree(&arg.tree, &kind_of(ty));
                }
            }
            Effect::Block(code) => code.statements.iter().for_each(|statements| self.statements(statements)),
        }
    }

    fn statements(&mut self, statements: &[Statement]) {
        for statement in statements {
            match statement {
                Statement::Assign(place, tree) => self.tree(tree, &kind(self.model, (*place).into())),
                Statement::If(condition, then, otherwise) => {
                    self.tree(condition, &Kind::Bool);
                    self.statements(then);
                    self.statements(otherwise);
                }
            }
        }
    }

    /// `wanted` is what the value of the tree is used as.
    fn tree(&mut self, tree: &Tree, wanted: &Kind) {
        match tree {
            Tree::Bool(_) | Tree::Int(_) | Tree::Read(_) | Tree::Elapsed(..) | Tree::MacroElapsed(..) => {}
            Tree::Unary(_, of) => self.tree(of, wanted),
            Tree::Binary(Binary::And | Binary::Or, a, b) => {
                self.tree(a, &Kind::Bool);
                self.tree(b, &Kind::Bool);
            }
            Tree::Binary(operator, a, b) => {
                let other = if operator.is_comparison() { NUMBER } else { wanted.clone() };
                let of = self.kind(a).or_else(|| self.kind(b)).unwrap_or(other);
                self.tree(a, &of);
                self.tree(b, &of);
            }
            Tree::Opaque { text, of, .. } => match of.as_deref().filter(|of| of.how != How::Other) {
                Some(Computed { how: How::If, operands }) => {
                    for (operand, wanted) in operands.iter().zip([&Kind::Bool, wanted, wanted]) {
                        self.tree(operand, wanted);
                    }
                }
                Some(of) => of.operands.iter().for_each(|operand| self.tree(operand, &NUMBER)),
                None if is_literal(text) => {}
                None => self.found(text, wanted),
            },
        }
    }

    fn found(&mut self, text: &str, wanted: &Kind) {
        let plain = |text: &str| text.chars().filter(|c| !c.is_whitespace()).collect::<String>();
        if self.found.iter().all(|signal| plain(&signal.name) != plain(text)) {
            self.found.push(Signal { name: text.to_owned(), kind: wanted.clone() });
        }
    }

    /// What values a tree has, where it tells.
    fn kind(&self, tree: &Tree) -> Option<Kind> {
        match tree {
            // What it is compared with says more of its type.
            Tree::Int(_) => None,
            Tree::Read(read) => Some(self.kind_of_read(*read)),
            Tree::Unary(_, of) => self.kind(of),
            Tree::Binary(operator, a, b) if !operator.is_comparison() => self.kind(a).or_else(|| self.kind(b)),
            Tree::Bool(_) | Tree::Elapsed(..) | Tree::MacroElapsed(..) | Tree::Binary(..) => Some(Kind::Bool),
            Tree::Opaque { text, .. } if !is_literal(text) => None,
            Tree::Opaque { text, .. } if text.starts_with(|c: char| c.is_ascii_digit()) => Some(Kind::Float(64)),
            Tree::Opaque { text, .. } => Some(Kind::Other(text.rsplit_once("::").map_or("", |(ty, _)| ty).to_owned())),
        }
    }

    fn kind_of_read(&self, read: Read) -> Kind {
        match read {
            Read::Name(name) => kind(self.model, name),
            Read::Since(_) | Read::MacroSince(_) | Read::Ticks(_) => Kind::Time,
            _ => Kind::Bool,
        }
    }
}

/// A number of which nothing more is known.
const NUMBER: Kind = Kind::Int { signed: true, bits: 64 };

#[cfg(test)]
mod tests {
    use crate::{Chart, Kind};

    #[test]
    fn what_the_program_tells() {
        let chart = Chart::parse(
            "sfc C { input x: u8; input mode: Mode; input f: f32; output y, z: i16; action tell(n: u16);
               initial step A { N y = offset(x); tell(LIMIT) if near(x) && READY; }
               step B { P { z = z + DELTA; } }
               A -[near(x) || rising(seen()) && x > MOST && mode == Mode::Auto]-> B
                 -[mode == current() && f < 2.5 && f > least() && A.T < soak() && count() > 3 && x.min(TOP) > 1]-> A; }",
        )
        .unwrap_or_else(|refused| panic!("{refused}"));
        let found: Vec<(String, Kind)> = chart.outside().into_iter().map(|one| (one.name, one.kind)).collect();
        let (i16, u8) = (Kind::Int { signed: true, bits: 16 }, Kind::Int { signed: false, bits: 8 });
        let number = Kind::Int { signed: true, bits: 64 };
        let expected = [
            ("near(x)", Kind::Bool),
            ("MOST", u8),
            ("current()", Kind::Other("Mode".to_owned())),
            ("least()", Kind::Float(32)),
            ("soak()", Kind::Time),
            ("count()", number.clone()),
            ("TOP", number),
            ("offset(x)", i16.clone()),
            ("READY", Kind::Bool),
            ("LIMIT", Kind::Int { signed: false, bits: 16 }),
            ("DELTA", i16),
            ("seen()", Kind::Bool),
        ];
        assert_eq!(found, expected.map(|(name, kind)| (name.to_owned(), kind)));
    }
}
