//! A chart that is put into situations by hand.

use std::fmt::Write as _;

use super::{Random, Rng};

/// The chart with `forceable;`. At random moments it is forced into a situation in which it has been before, or into the steps of two of them, which
/// it may refuse.
pub(super) fn by_hand(mut made: Random, seed: u64) -> Random {
    let Some(end) = made.chart.rfind('}') else { return made };
    made.chart.insert_str(end, "forceable;\n");
    made.features.insert("forceable");
    // By chance alone there would be hardly any.
    if seed % 24 == 1 && !made.chart.contains("encoding flags") && !made.chart.contains("optimize size") {
        made.chart.insert_str(end, "encoding flags;\n");
        made.features.insert("encoding flags");
    }
    if made.chart.contains("encoding flags") {
        made.features.insert("forceable with flags");
    }
    let mut rng = Rng::new(seed ^ 0x5eed);
    let mut timeline = String::new();
    let lines: Vec<&str> = made.timeline.lines().collect();
    for (at, line) in lines.iter().enumerate() {
        let is_cycle = line.contains('|') && may_be_refused(&lines, at);
        match rng.below(100) {
            0..=6 if is_cycle => _ = write!(timeline, "force(~{}) ", rng.below(1000)),
            7..=8 if is_cycle => _ = write!(timeline, "force(~{},~{}) ", rng.below(1000), rng.below(1000)),
            _ => {}
        }
        timeline.push_str(line);
        timeline.push('\n');
    }
    made.timeline = timeline;
    made
}

/// Whether the cycle may be missing: those beside it lie less than 2^31 ticks apart.
fn may_be_refused(lines: &[&str], at: usize) -> bool {
    let before = lines[..at].iter().rev().find_map(|line| reading(line));
    let after = lines[at + 1..].iter().find_map(|line| reading(line));
    let (Some(before), Some(after)) = (before, after) else { return true };
    after.wrapping_sub(before) < 1 << 31
}

/// The reading of the clock in a line.
fn reading(line: &str) -> Option<u32> {
    let (_, rest) = line.split_once('@')?;
    rest.split_whitespace().next()?.parse().ok()
}
