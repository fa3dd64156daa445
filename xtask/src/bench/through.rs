//! The charts by way of a program and its passes, beside what is recorded of the generator and of who wrote them by hand.

use std::collections::BTreeSet;

use super::figures::Recorded;
use super::measure::{Build, costs};
use super::table::{FIGURES, Figure};
use super::{AUTHORS, Cost, LONG, RIVALS, TARGETS, pinned_compiler};
use crate::command::Result;
use crate::{firmware, project};

/// Measures the named charts, or all but the longest, and shows their costs; the images stay for a disassembler.
///
/// # Errors
/// A chart is unknown or gives other outputs than recorded, a tool is missing, a build fails.
pub(crate) fn run(words: &[&str]) -> Result {
    let (charts, targets) = wanted(words)?;
    let recorded = Recorded::read()?;
    let long = charts.contains(LONG.0.trim_end());
    let names = charts.iter().copied().collect::<Vec<_>>().join(" ");
    let features = if long { format!("through,{}", LONG.1) } else { "through".to_owned() };
    let what = Build { author: AUTHORS[0], features: &features, charts: (!charts.is_empty()).then_some(&*names) };
    let mut problems = Vec::new();
    for target in targets {
        let measured = costs(&pinned_compiler(target)?, target, &what)?;
        println!("{target}: flash · busy · idle · RAM");
        println!("{:24} {:>28} {:>28} {:>28}", "", "recorded", "through", "by hand");
        for (name, cost) in &measured {
            let before = recorded.find(target, name, AUTHORS[0])?;
            match before {
                None => problems.push(format!("{target}: {name} is not recorded")),
                Some(before) if before.hash != cost.hash => {
                    problems.push(format!("{target}: {name} has other outputs than recorded"));
                }
                Some(_) => {}
            }
            let hand = best(&recorded, target, name)?;
            let worse = before.is_some_and(|before| FIGURES.iter().any(|figure| is_more(figure, cost, &before)));
            let mark = if worse { "  *" } else { "" };
            println!("{name:24} {:>28} {:>28} {:>28}{mark}", figures(before.as_ref()), figures(Some(cost)), hand);
        }
        let known: BTreeSet<&str> = measured.iter().filter_map(|(name, _)| name.split(' ').next()).collect();
        problems.extend(charts.difference(&known).map(|chart| format!("there is no chart {chart}")));
        let images = project::target(firmware::FOLDER).join(target).join("release");
        println!("images: {}/CHART_DIALECT.elf", images.display());
    }
    if problems.is_empty() { Ok(()) } else { Err(problems.join("\n")) }
}

pub(super) fn wanted<'a>(words: &[&'a str]) -> Result<(BTreeSet<&'a str>, Vec<&'static str>)> {
    let mut charts = BTreeSet::new();
    let mut targets = TARGETS.to_vec();
    let mut words = words.iter();
    while let Some(word) = words.next() {
        match (*word, words.clone().next()) {
            ("--target", Some(&"m3")) => targets = vec![TARGETS[0]],
            ("--target", Some(&"m0")) => targets = vec![TARGETS[1]],
            (option, _) if option.starts_with('-') => return Err(format!("{option}: --target m3 or --target m0")),
            (chart, _) => {
                charts.insert(chart);
                continue;
            }
        }
        words.next();
    }
    Ok((charts, targets))
}

fn is_more(figure: &Figure, cost: &Cost, recorded: &Cost) -> bool {
    (figure.of)(cost) > (figure.of)(recorded).map(|value| value + figure.resolution)
}

fn figures(cost: Option<&Cost>) -> String {
    FIGURES.map(|figure| figure.show(cost.and_then(figure.of))).join(" · ")
}

/// Of each figure the best that somebody wrote by hand or with another crate.
fn best(recorded: &Recorded, target: &str, name: &str) -> Result<String> {
    let name = name.replace("_size ", " ").replace("_flags ", " ");
    let mut rivals = Vec::new();
    for author in &AUTHORS[1..=RIVALS] {
        rivals.extend(recorded.find(target, &name, author)?);
    }
    Ok(FIGURES.map(|figure| figure.show(rivals.iter().filter_map(figure.of).min())).join(" · "))
}
