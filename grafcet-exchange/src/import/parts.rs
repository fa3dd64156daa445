//! What belongs together in `a AND b AND c`: an edge, or a time.

use super::expr::{Kind, Scope};
use super::parser::{Expr, Op};
use super::source::same;

/// One of the parts of `a AND b AND c`.
pub(super) enum Part<'e> {
    Plain(&'e Expr),
    Rising(Expr),
    Falling(Expr),
    /// `5s/Step`, and whether what it is made of asks if the step is active.
    Elapsed(&'e Expr, &'e str, bool),
}

impl Scope<'_> {
    /// What belongs together: `a AND NOT a_was` is an edge, `S.X AND S.T >= T#5s` a time.
    pub(super) fn parts<'e>(&self, mut terms: Vec<&'e Expr>) -> Vec<Part<'e>> {
        let mut found = Vec::new();
        for (was, of) in &self.memory {
            let is_was = |expr: &Expr| matches!(expr, Expr::Name(name) if same(name, was));
            let not_was = terms.iter().position(|term| matches!(term, Expr::Not(inner) if is_was(inner)));
            let positions = conjunction(of).into_iter().map(|part| terms.iter().position(|term| *term == part));
            if let (Some(not), Some(mut places)) = (not_was, positions.collect::<Option<Vec<usize>>>()) {
                places.push(not);
                let at = places.iter().copied().min().unwrap_or_default();
                let mut index = 0;
                terms.retain(|_| {
                    index += 1;
                    !places.contains(&(index - 1))
                });
                found.push((at, Part::Rising(of.clone())));
            }
            let now = terms.iter().position(|term| matches!(term, Expr::Not(inner) if **inner == *of));
            let yes = terms.iter().position(|term| is_was(term));
            if let (Some(now), Some(yes)) = (now, yes) {
                terms.remove(now.max(yes));
                terms.remove(now.min(yes));
                found.push((now.min(yes), Part::Falling(of.clone())));
            }
        }
        let mut parts: Vec<Part<'e>> = Vec::new();
        let mut asked = "";
        for (index, term) in terms.iter().enumerate() {
            let active = |step: &str, other: &Expr| matches!(other, Expr::Member(of, member) if same(of, step) && same(member, "x"));
            let of_time = |other: &&Expr, step: &str| self.elapsed(other).is_some_and(|(_, of)| same(of, step));
            match term {
                // What the time says with it.
                Expr::Member(step, _)
                    if terms.get(index + 1).is_some_and(|next| of_time(next, step) && active(step, term)) =>
                {
                    asked = step;
                    continue;
                }
                _ => match self.elapsed(term) {
                    // No time is over at once, active or not.
                    Some((limit, step)) if same(asked, step) || *limit != Expr::Time(0) => {
                        parts.push(Part::Elapsed(limit, step, same(asked, step)));
                    }
                    _ => parts.push(Part::Plain(term)),
                },
            }
            asked = "";
        }
        for (at, part) in found {
            parts.insert(at.min(parts.len()), part);
        }
        parts
    }

    /// `S.T >= T#5s`, with a literal or a name.
    pub(super) fn elapsed<'e>(&self, expr: &'e Expr) -> Option<(&'e Expr, &'e str)> {
        let (Expr::Binary(Op::AtLeast, of, limit) | Expr::Binary(Op::AtMost, limit, of)) = expr else { return None };
        let Expr::Member(step, member) = &**of else { return None };
        let is_time = matches!(**limit, Expr::Time(_))
            || matches!(&**limit, Expr::Name(_)) && self.kind(limit) == Some(Kind::Time);
        (is_time && same(member, "t") && self.steps.contains(&step.to_lowercase())).then_some((&**limit, &**step))
    }
}

/// `a`, `b` and `c` of `a AND b AND c`.
pub(super) fn conjunction(expr: &Expr) -> Vec<&Expr> {
    match expr {
        Expr::Binary(Op::And, a, b) => {
            let mut all = conjunction(a);
            all.extend(conjunction(b));
            all
        }
        _ => vec![expr],
    }
}
