//! Charts of the benches beside the same in C, measured now: nothing recorded is looked at.

use super::measure::{Build, costs};
use super::through::wanted;
use super::{Cost, pinned_compiler};
use crate::command::Result;

/// Who is compared, by their features.
const WRITERS: [&str; 2] = ["generated", "c"];

/// Measures the named charts as the macro and as C have them, and prints a row of a table for each.
///
/// # Errors
/// A tool is missing, a build fails, or the outputs of the two differ.
pub(crate) fn run(words: &[&str]) -> Result {
    let (charts, targets) = wanted(words)?;
    let names = charts.iter().copied().collect::<Vec<_>>().join(" ");
    let mut different = Vec::new();
    println!(
        "| chart | dialect | target | | flash | busy | idle | RAM |\n| --- | --- | --- | --- | --: | --: | --: | --: |"
    );
    for target in targets {
        let compiler = pinned_compiler(target)?;
        let measure =
            |author| costs(&compiler, target, &Build { author, features: author, charts: Some(names.as_str()) });
        let [generated, c] = WRITERS.map(measure);
        let c = c?;
        for (name, cost) in generated? {
            let place = format!("{} | {target}", name.replace(' ', " | "));
            // With `optimize size;` a chart is compared with the same C.
            let written = name.replace("_size ", " ");
            let Some((_, rival)) = c.iter().find(|(other, _)| *other == written) else {
                return Err(format!("{name} is not in C"));
            };
            let (ours, theirs) = (figures(&cost), figures(rival));
            println!("| {place} | generated | {} |", ours.map(|figure| format!("{figure:.1}")).join(" | "));
            println!("| {place} | C | {} |", theirs.map(|figure| format!("{figure:.1}")).join(" | "));
            let ratios = [0, 1, 2, 3].map(|at| format!("{:.2}", ours[at] / theirs[at]));
            println!("| {place} | ratio | {} |", ratios.join(" | "));
            if cost.hash != rival.hash {
                different.push(format!("{target}: {name}: {:08x} generated, {:08x} in C", cost.hash, rival.hash));
            }
        }
    }
    if different.is_empty() { Ok(()) } else { Err(format!("outputs differ:\n{}", different.join("\n"))) }
}

/// Flash, instructions per cycle busy and idle, RAM.
fn figures(cost: &Cost) -> [f64; 4] {
    let (flash, ram) = cost.size.map_or((0, 0), |size| (size.flash, size.ram));
    let each = |count: u32| f64::from(count) / f64::from(super::CYCLES);
    [f64::from(flash), each(cost.busy), each(cost.idle), f64::from(ram)]
}
