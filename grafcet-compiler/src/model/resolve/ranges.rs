//! What a param may be: `param soak: time in 1s..10s = 5s;`

use crate::analysis::integer_constant;
use crate::ast::{self, Bound, DeclKind, Limit};
use crate::diagnostic::{Mark, rules};
use crate::model::{Assumption, Binary, Expr, Name, Param, ParamId, Range, Read, Tree, Ty};

use super::Resolver;
use super::scope::Meaning;

impl Resolver<'_> {
    /// The third pass over a declaration: what stands after `in`, where that is a range.
    pub(super) fn range(&mut self, decl: &ast::Decl) {
        let Some(written) = &decl.range else { return };
        if decl.kind != DeclKind::Param {
            let message = match decl.kind {
                DeclKind::Input => {
                    "only a param has a range, as the chart itself sees to it; of an input it is assumed: `assume never level > 8;`"
                }
                _ => {
                    "only a param has a range; what the chart itself writes is a property, which is proved: `always n <= 8;`"
                }
            };
            return self.sink.notation(written.mark, message);
        }
        for name in &decl.names {
            let Some(Meaning::Value(Name::Param(id))) = self.scope.get(name) else { continue };
            let Some(range) = self.read(written, id) else { return };
            self.default_in(&range, id, decl);
            self.assume(&range, id, written.mark);
            self.model.params[id].range = Some(range);
        }
    }

    fn read(&mut self, written: &ast::Range, id: ParamId) -> Option<Range> {
        let ty = self.model.params[id].ty.clone();
        let (low, high) = (self.bound(&written.low, &ty)?, self.bound(&written.high, &ty)?);
        let text = format!("{}{}{}", written.low.text, if written.closed { "..=" } else { ".." }, written.high.text);
        let high = if written.closed { high } else { high - 1 };
        if low > high {
            let message =
                format!("there is nothing in `{text}`: the lower end stands first, and `..` leaves out the upper one");
            self.sink.notation(written.mark, message);
            return None;
        }
        Some(Range { low, high, text })
    }

    /// The value of an end, which is one of the type.
    fn bound(&mut self, bound: &Bound, ty: &Ty) -> Option<i128> {
        let message = match (&bound.limit, ty) {
            (Limit::Time(time), Ty::Time(_)) => {
                let before = self.sink.count();
                let ticks = self.ticks(time);
                // Nothing is said of a range whose end the clock cannot count.
                return (self.sink.count() == before).then(|| i128::from(ticks));
            }
            (Limit::Int(value), Ty::Int { signed, bits: bits @ 0..=64, rust }) => {
                let (least, most) =
                    if *signed { (-(1 << (bits - 1)), (1 << (bits - 1)) - 1) } else { (0, (1 << bits) - 1) };
                if (least..=most).contains(value) {
                    return Some(*value);
                }
                format!("`{}` is no `{}`", bound.text, quote::ToTokens::to_token_stream(rust))
            }
            (Limit::Int(_), Ty::Time(_)) => {
                let message =
                    format!("`{}` has no unit of time; the units are h, m, s, ms and us, as in `1s..10s`", bound.text);
                self.sink.rule(&rules::BAD_TIME, &[], vec![(bound.mark, message)]);
                return None;
            }
            (Limit::Time(_), Ty::Int { .. }) => {
                format!("`{}` is a time, and the param a number: `time` is the type of times", bound.text)
            }
            _ => "only an integer of at most 64 bits or a `time` has a range; leave this out".to_owned(),
        };
        self.sink.notation(bound.mark, message);
        None
    }

    /// Reports a value of the chart outside of the range. Of a constant of Rust the generated code makes sure.
    fn default_in(&mut self, range: &Range, id: ParamId, decl: &ast::Decl) {
        let param = &self.model.params[id];
        let Some(init) = &param.init else {
            if decl.init.is_none() && !range.contains(0) {
                let message = format!(
                    "`{}` is 0 where nothing else is said, which is not in `{}`; state what it is: `= {};`",
                    param.name,
                    range.text,
                    match &decl.range {
                        Some(written) => &written.low.text,
                        None => "…",
                    }
                );
                self.sink.notation(&param.name, message);
            }
            return;
        };
        if let Some(value) = integer_constant(&init.tree).filter(|value| !range.contains(*value)) {
            let value = if matches!(param.ty, Ty::Time(_)) { init.text.clone() } else { value.to_string() };
            let message = format!("`{value}` is not in `{}`, the range of `{}`", range.text, param.name);
            self.sink.notation(Mark::of(decl.init.as_ref()), message);
        }
    }

    /// For whoever reasons about the chart, a range is an assumption over the param.
    fn assume(&mut self, range: &Range, id: ParamId, mark: Mark) {
        let (below, above) = self.model.params[id].beyond(range);
        let (param, is_time) = (Read::Name(Name::Param(id)), self.model.is_time(Name::Param(id)));
        let mut reads = vec![param];
        let mut compare = |operator, value: i128| {
            let bound = match u32::try_from(value) {
                Ok(ticks) if is_time => {
                    reads.push(Read::Ticks(ticks));
                    Tree::Read(Read::Ticks(ticks))
                }
                _ => Tree::Int(value),
            };
            Tree::Binary(operator, Box::new(Tree::Read(param)), Box::new(bound))
        };
        let below = below.then(|| compare(Binary::Lt, range.low));
        let above = above.then(|| compare(Binary::Gt, range.high));
        let tree = match (below, above) {
            (Some(below), Some(above)) => Tree::Binary(Binary::Or, Box::new(below), Box::new(above)),
            (Some(one), None) | (None, Some(one)) => one,
            (None, None) => return,
        };
        let text = format!("{} outside of {}", self.model.params[id].name, range.text);
        let never = Expr { tree, tokens: syn::parse_quote!(false), reads, text, mark };
        self.model.assumptions.push(Assumption { never, mark, of_range: Some(id) });
    }
}

impl Param {
    /// Whether its type has values below and above the range.
    #[must_use]
    pub fn beyond(&self, range: &Range) -> (bool, bool) {
        match &self.ty {
            // On the host they have more values than on the controller.
            Ty::Int { signed, bits: 32, rust }
                if !quote::ToTokens::to_token_stream(rust).to_string().ends_with("32") =>
            {
                (*signed || range.low > 0, true)
            }
            Ty::Int { signed: true, bits, .. } => (range.low > -(1 << (bits - 1)), range.high < (1 << (bits - 1)) - 1),
            Ty::Int { bits, .. } => (range.low > 0, range.high < (1 << bits) - 1),
            _ => (range.low > 0, range.high < i128::from(u32::MAX)),
        }
    }
}

impl Range {
    /// Whether a param may have this value.
    #[must_use]
    pub fn contains(&self, value: i128) -> bool {
        (self.low..=self.high).contains(&value)
    }
}
