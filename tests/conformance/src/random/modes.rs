//! A chart that is run by its operating modes.

use std::fmt::Write as _;

use super::{Random, Rng};

/// The chart with `modes;`, of the whole chart or of one partial grafcet. It is automatic half of the time, and the push button goes up and down.
pub(super) fn held(mut made: Random, seed: u64) -> Random {
    let mut rng = Rng::new(seed ^ 0x0d0d_e5ed);
    let nets: Vec<usize> = made.chart.match_indices("\npartial ").map(|(at, _)| at + 1).collect();
    let inside = if nets.is_empty() || rng.chance(40) { None } else { Some(*rng.pick(&nets)) };
    let place = match inside {
        Some(net) => made.chart[net..].find('\n').map(|end| net + end + 1),
        None => made.chart.rfind('}'),
    };
    let Some(place) = place else { return made };
    made.chart.insert_str(place, "modes;\n");
    made.features.insert("modes");
    if inside.is_some() {
        made.features.insert("modes of a partial grafcet");
    }
    for (there, name) in
        [("else]->", "modes beside else"), ("\nany ", "modes beside any"), ("forceable;", "modes and forceable")]
    {
        if made.chart.contains(there) {
            made.features.insert(name);
        }
    }
    made.timeline = timeline(&made.timeline, &mut rng);
    made
}

fn timeline(of: &str, rng: &mut Rng) -> String {
    let (mut mode, mut push) = ("", false);
    let mut timeline = String::new();
    for line in of.lines() {
        if let (true, Some((before, after))) = (line.contains('|'), line.split_once('@')) {
            if rng.chance(15) {
                mode = *rng.pick(&[
                    "",
                    "",
                    "",
                    "",
                    "semi_automatic ",
                    "semi_automatic ",
                    "manual ",
                    "manual ",
                    "paused ",
                    "manual semi_automatic ",
                    "paused manual ",
                ]);
            }
            push ^= rng.chance(40);
            _ = writeln!(timeline, "{before}{mode}{}@{after}", if push { "push " } else { "" });
        } else {
            _ = writeln!(timeline, "{line}");
        }
    }
    timeline
}
