//! Times as literals of `TIME`, which counts milliseconds.

use grafcet_compiler::diagnostic::Mark;
use grafcet_compiler::model::Model;

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
