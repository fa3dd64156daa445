//! Times as literals of `TIME`, which counts milliseconds.

use grafcet_compiler::diagnostic::Mark;
use grafcet_compiler::model::{Binary, Model, Read, Tree};

use super::expr::{At, Kind, Scope, refuse};
use super::text::{Text, strength};
use crate::Refused;

/// The longest that every PLC has: 2^31 - 1 ms.
pub(crate) const LONGEST: &str = "T#24d20h31m23s647ms";
const LONGEST_MS: u64 = (1 << 31) - 1;

/// `T#1m30s` of so many ticks of the chart's clock.
pub(crate) fn literal(model: &Model, ticks: u32, mark: Mark) -> Result<String, Refused> {
    milliseconds(model, ticks, mark).map(text)
}

/// The same as a number, which fits into a `DINT`.
pub(crate) fn milliseconds(model: &Model, ticks: u32, mark: Mark) -> Result<u64, Refused> {
    const MS: u64 = 1_000_000;
    let nanos = u64::from(ticks).saturating_mul(model.clock_nanos);
    if nanos % MS != 0 {
        return Err(Refused::at(
            mark,
            format!(
                "`TIME` counts milliseconds, and {} are none: choose a coarser time",
                model.time_text(ticks.into())
            ),
        ));
    }
    let ms = nanos / MS;
    if ms > LONGEST_MS {
        return Err(Refused::at(
            mark,
            format!("this is longer than `TIME` can tell, {LONGEST}: count it by a variable"),
        ));
    }
    Ok(ms)
}

impl Scope<'_> {
    /// A sum of times, or a difference. They end where those of the chart do, at zero, and where a time of the chart or a `TIME` does; no value between
    /// leaves the type.
    pub(super) fn of_times(&mut self, operator: Binary, sides: [&Tree; 2], at: &At<'_>) -> Result<Text, Refused> {
        if self.steps.is_some() {
            return Err(refuse(at, "in SFC arithmetic of times", "compare with a time that is a `param`"));
        }
        let known = sides.map(known);
        if let [Some(a), Some(b)] = known {
            let ticks = if operator == Binary::Add { a.saturating_add(b) } else { a.saturating_sub(b) };
            return literal(self.model, ticks, at.mark).map(Text::word);
        }
        let [a, b] = sides;
        match operator {
            Binary::Add => {
                self.adds_times = true;
                // What is known stands after.
                let (a, b, known) = if known[0].is_some() { (b, a, known[0]) } else { (a, b, known[1]) };
                let [first, second] =
                    [self.tree(a, &Kind::Time, at)?.text, self.tree(b, &Kind::Time, at)?.within(strength::PRODUCT)];
                let most = match known {
                    Some(ticks) => text(longest(self.model).saturating_sub(milliseconds(self.model, ticks, at.mark)?)),
                    None => format!("{} - {second}", text(longest(self.model))),
                };
                let text = format!("MIN(IN1 := {first}, IN2 := {most}) + {second}");
                Ok(Text { text, strength: strength::SUM })
            }
            Binary::Sub => {
                let [first, second] =
                    [self.tree(a, &Kind::Time, at)?.text, self.tree(b, &Kind::Time, at)?.within(strength::PRODUCT)];
                let text = format!("MAX(IN1 := {first}, IN2 := {second}) - {second}");
                Ok(Text { text, strength: strength::SUM })
            }
            _ => Err(refuse(at, "an operator on times beside `+` and `-`", "compare with a time that is a `param`")),
        }
    }
}

/// The longest time of the chart that `TIME` can tell.
fn longest(model: &Model) -> u64 {
    (u64::from(u32::MAX).saturating_mul(model.clock_nanos) / 1_000_000).min(LONGEST_MS)
}

/// A time that the chart tells.
fn known(tree: &Tree) -> Option<u32> {
    match tree {
        Tree::Read(Read::Ticks(ticks)) => Some(*ticks),
        Tree::Binary(operator @ (Binary::Add | Binary::Sub), a, b) => {
            let (a, b) = (known(a)?, known(b)?);
            Some(if *operator == Binary::Add { a.saturating_add(b) } else { a.saturating_sub(b) })
        }
        _ => None,
    }
}

fn text(ms: u64) -> String {
    const UNITS: [(&str, u64); 5] = [("d", 86_400_000), ("h", 3_600_000), ("m", 60_000), ("s", 1_000), ("ms", 1)];
    let mut rest = ms;
    let mut text = "T#".to_owned();
    for (unit, size) in UNITS {
        if rest >= size {
            text.push_str(&(rest / size).to_string());
            text.push_str(unit);
            rest %= size;
        }
    }
    if ms == 0 { "T#0s".to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::{LONGEST, LONGEST_MS, text};

    #[test]
    fn times_as_literals() {
        assert_eq!([0, 500, 5_000, 5_400_000, 61_001].map(text), ["T#0s", "T#500ms", "T#5s", "T#1h30m", "T#1m1s1ms"]);
        assert_eq!(text(LONGEST_MS), LONGEST);
    }
}
