//! What the places of a chart begin with.

use super::{Expr, Model, Place, Tree};

impl Model {
    /// What the user has written there; without it a boolean begins as `false`.
    #[must_use]
    pub(crate) fn init_of(&self, place: Place) -> Option<&Expr> {
        match place {
            Place::Output(id) => self.outputs[id].init.as_ref(),
            Place::Var(id) => self.vars[id].init.as_ref(),
        }
    }

    /// Whether a boolean certainly begins as `true`: Rust that is not looked into may be either.
    #[must_use]
    pub fn starts_true(&self, place: Place) -> bool {
        self.init_of(place).is_some_and(|init| init.tree == Tree::Bool(true))
    }

    /// Whether a boolean may begin as `true`, as Rust may that is not looked into.
    #[must_use]
    pub fn may_start_true(&self, place: Place) -> bool {
        self.init_of(place).is_some_and(|init| init.tree != Tree::Bool(false))
    }
}

#[cfg(test)]
mod tests {
    use crate::diagnostic::Sink;
    use crate::model::Place;
    use crate::{model, parse};

    #[test]
    fn rust_that_is_not_looked_into_may_begin_as_either() {
        let chart =
            "sfc C { output none: bool; output no: bool = false; output yes: bool = true; output asked: bool = ASKED;
                     initial step A; A -[true]-> A; }";
        let mut sink = Sink::new();
        let chart = parse::chart(chart.parse().expect("tokens"), &mut sink).expect("a chart");
        let model = model::resolve(&chart, &mut sink);
        let starts = |id| (model.starts_true(Place::Output(id)), model.may_start_true(Place::Output(id)));
        let mut outputs = model.outputs.ids().map(starts);
        assert_eq!(outputs.next(), Some((false, false)), "none");
        assert_eq!(outputs.next(), Some((false, false)), "no");
        assert_eq!(outputs.next(), Some((true, true)), "yes");
        assert_eq!(outputs.next(), Some((false, true)), "asked");
    }
}
