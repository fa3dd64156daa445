//! What the generated charts shall not exceed.

use std::fmt::{self, Display, Formatter, Write};

use super::builds::Times;
use super::table::{BUSY, FIGURES, FLASH, Figure, IDLE, RAM, author, cpu};
use super::{Boards, Row};

/// What a figure is compared with.
#[derive(Clone, Copy, Debug)]
enum Than {
    /// The best of the rivals, chart by chart.
    Best,
    /// The better of the two hand-written ones.
    ByHand,
    /// One author, by the place in `AUTHORS`.
    Author(usize),
    /// Another generated chart.
    Chart(&'static str),
    /// Nothing: the limit is absolute.
    Nothing,
}

/// A figure of a chart in both dialects or in the one that is named, what it is compared with, and how much of that it may be.
type Rule = (&'static str, &'static Figure, Than, f64);

/// Machines as they are automated: nothing of them may cost more than the best of all programs by hand.
const PLANTS: [&str; 5] = ["laundry", "plating", "reactor", "packer", "picker"];

const RULES: [Rule; 33] = [
    ("line24v", &FLASH, Than::Best, 1.00),
    ("line24v", &BUSY, Than::Best, 1.00),
    ("line24v sfc", &FLASH, Than::Nothing, 78.00),
    ("line24v sfc", &BUSY, Than::Nothing, 11.00),
    ("line24v sfc", &IDLE, Than::Nothing, 10.00),
    ("line24v sfc", &RAM, Than::Nothing, 1.00),
    ("line24v grafcet", &RAM, Than::Nothing, 2.00),
    ("chain100", &FLASH, Than::Best, 1.00),
    ("chain100", &BUSY, Than::Best, 1.00),
    ("chain100", &BUSY, Than::Author(5), 0.10),
    ("chain100", &RAM, Than::Nothing, 1.00),
    ("chain100_size", &FLASH, Than::Author(1), 0.30),
    ("chain100_size", &BUSY, Than::Author(1), 4.00),
    ("chain100_size sfc", &FLASH, Than::Nothing, 300.00),
    ("chain100_size sfc", &BUSY, Than::Nothing, 33.00),
    ("chain100_size", &RAM, Than::Nothing, 1.00),
    // Asked for size it is never larger.
    ("seq64_size", &FLASH, Than::Chart("seq64"), 1.00),
    ("plating_size", &FLASH, Than::Chart("plating"), 1.00),
    ("picker_size", &FLASH, Than::Chart("picker"), 1.00),
    ("chain100_flags", &BUSY, Than::Author(5), 1.00),
    ("chain100_flags", &RAM, Than::Nothing, 13.00),
    ("par8", &FLASH, Than::Best, 0.95),
    ("par8", &BUSY, Than::ByHand, 0.90),
    ("par8 sfc", &FLASH, Than::Nothing, 480.00),
    ("par8 sfc", &BUSY, Than::Nothing, 75.00),
    ("par8 sfc", &IDLE, Than::Nothing, 15.00),
    ("par8", &RAM, Than::Nothing, 8.00),
    // Twice the branches.
    ("par16 grafcet", &FLASH, Than::Chart("par8"), 2.10),
    ("chain1000", &BUSY, Than::Chart("chain10"), 1.20),
    ("chain1000", &RAM, Than::Nothing, 2.00),
    // Five times the steps.
    ("chain5000", &FLASH, Than::Chart("chain1000"), 5.00),
    ("chain5000", &BUSY, Than::Chart("chain10"), 1.20),
    ("chain5000", &RAM, Than::Nothing, 2.00),
];

/// One comparison.
#[derive(Debug)]
pub(super) struct Goal {
    /// The chart, or what is built.
    what: String,
    /// Where it runs.
    place: String,
    figure: &'static str,
    than: String,
    value: f64,
    limit: f64,
}

impl Goal {
    pub(super) fn is_met(&self) -> bool {
        self.value <= self.limit
    }

    /// Whether it is the same goal on another target.
    fn is_beside(&self, other: &Self) -> bool {
        let key = |goal: &Self| (goal.what.clone(), goal.figure, goal.than.clone());
        key(self) == key(other)
    }
}

impl Display for Goal {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self { what, place, figure, than, value, limit } = self;
        write!(f, "{what}, {place}, {figure}: {value:.2} of {than}, at most {limit:.2}")
    }
}

/// The goals of the costs on a controller.
pub(super) fn of_costs(boards: &Boards) -> Vec<Goal> {
    let plants = PLANTS.iter().flat_map(|chart| FIGURES.map(|figure| (*chart, figure, Than::Best, 1.0)));
    let names: Vec<&str> =
        boards.first().map_or_else(Vec::new, |(_, rows)| rows.iter().map(|row| &row.name[..]).collect());
    let mut goals = Vec::new();
    for (chart, figure, than, limit) in RULES.into_iter().chain(plants) {
        for name in names.iter().filter(|name| is_of(name, chart)) {
            for (place, (target, rows)) in boards.iter().enumerate() {
                // What is absolute is so on the first target, but for memory, which is the same on all.
                if place > 0 && matches!(than, Than::Nothing) && figure.name != RAM.name {
                    continue;
                }
                let row = rows.iter().find(|row| row.name == *name);
                goals.extend(row.and_then(|row| goal(target, rows, row, (figure, than, limit))));
            }
        }
    }
    goals
}

/// Whether a chart of one dialect is meant by a name with or without the dialect.
fn is_of(name: &str, chart: &str) -> bool {
    name.strip_prefix(chart).is_some_and(|rest| rest.is_empty() || rest.starts_with(' '))
}

fn goal(target: &str, rows: &[Row], row: &Row, rule: (&'static Figure, Than, f64)) -> Option<Goal> {
    let (figure, than, limit) = rule;
    let ours = figure.get(row, 0)?;
    let by_hand = || (1..=2).filter_map(|author| figure.get(row, author)).min();
    let (other, name) = match than {
        Than::Best => (figure.best(row)?, "the best rival".to_owned()),
        Than::ByHand => (by_hand()?, "the better hand-written one".to_owned()),
        Than::Author(place) => (figure.get(row, place)?, author(place).to_owned()),
        Than::Chart(chart) => {
            let name = row.name.split(' ').next_back().map(|dialect| format!("{chart} {dialect}"))?;
            (figure.get(rows.iter().find(|row| row.name == name)?, 0)?, name)
        }
        Than::Nothing => (0, figure.unit().to_owned()),
    };
    // What the timer cannot tell apart is no difference.
    let ours = figure.shown(ours.saturating_sub(figure.resolution));
    let value = if other == 0 { ours } else { ours / figure.shown(other) };
    Some(Goal { what: row.name.clone(), place: target.to_owned(), figure: figure.name, than: name, value, limit })
}

/// The goals of the build times.
pub(super) fn of_builds(times: &Times) -> Vec<Goal> {
    let goal = |what: &str, figure, value: f64, than: &str, limit: f64| Goal {
        what: what.to_owned(),
        place: "host".to_owned(),
        figure,
        than: than.to_owned(),
        value,
        limit,
    };
    let ratio =
        |what: &str, [ours, _, statig]: [f64; 3], limit| goal(what, "processor time", ours / statig, "statig's", limit);
    vec![
        ratio("clean build of the macro and its dependencies", times.clean, 1.9),
        ratio("`cargo check` of 100 small charts after an edit", times.small, 1.0),
        ratio("`cargo check` of Chain1000", times.chain1000, 1.0),
        goal("rustc on Chain5000", "processor time", times.long.seconds, "a second", 2.0),
        goal("rustc on Chain5000", "memory", times.long.mebibytes, "a MiB", 400.0),
    ]
}

/// All goals in Markdown, those of one chart on all targets in one line.
pub(super) fn table(goals: &[Goal]) -> String {
    let mut table = String::from("| | | at most | reached | |\n| --- | --- | --: | --- | --- |\n");
    for goals in goals.chunk_by(Goal::is_beside) {
        let Some(Goal { what, figure, than, limit, .. }) = goals.first() else { continue };
        let reached = |goal: &Goal| {
            let mark = if goal.is_met() { "" } else { "**" };
            format!("{mark}{:.2}{mark} ({})", goal.value, cpu(&goal.place))
        };
        let reached = goals.iter().map(reached).collect::<Vec<_>>().join(", ");
        let verdict = if goals.iter().all(Goal::is_met) { "" } else { "**missed**" };
        _ = writeln!(table, "| {what} | {figure}, of {than} | {limit:.2} | {reached} | {verdict} |");
    }
    table
}

#[cfg(test)]
mod tests {
    use super::super::{AUTHORS, Cost, Row, Size};
    use super::of_costs;

    #[test]
    fn what_exceeds_a_goal_is_missed() {
        let cost = |flash, busy, ram| Some(Cost { hash: 0, busy, idle: 0, size: Some(Size { flash, ram }) });
        let mut costs = [None; AUTHORS.len()];
        costs[0] = cost(81, 4106, 2);
        costs[1] = cost(80, 4096, 1);
        let boards = vec![("thumb", vec![Row { name: "line24v sfc".to_owned(), costs }])];
        let goals = of_costs(&boards);
        let met: Vec<bool> = goals.iter().map(super::Goal::is_met).collect();
        // A byte of flash more is more, two ticks are not; of what is absolute, 81 bytes and two of RAM are too much.
        assert_eq!(met, [false, true, false, true, true, false]);
        assert_eq!(
            goals[3].to_string(),
            "line24v sfc, thumb, instructions, busy: 1.00 of an instruction, at most 11.00"
        );
        assert_eq!(goals[0].to_string(), "line24v sfc, thumb, flash: 1.01 of the best rival, at most 1.00");
    }
}
