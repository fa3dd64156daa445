//! What the generated charts shall not exceed.

use std::fmt::{self, Display, Formatter, Write};

use super::builds::Times;
use super::table::{BUSY, FLASH, Figure, RAM, author};
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

/// A figure of a chart, what it is compared with, and how many hundredths of that it may be.
type Rule = (&'static str, &'static Figure, Than, u32);

const RULES: [Rule; 16] = [
    ("line24v", &FLASH, Than::Best, 100),
    ("line24v", &BUSY, Than::Best, 100),
    ("line24v", &RAM, Than::Nothing, 200),
    ("chain100", &FLASH, Than::Best, 100),
    ("chain100", &BUSY, Than::Best, 100),
    ("chain100", &RAM, Than::Nothing, 100),
    ("chain100_size", &FLASH, Than::Author(1), 30),
    ("chain100_size", &BUSY, Than::Author(1), 400),
    ("chain100_size", &RAM, Than::Nothing, 100),
    ("chain100_flags", &BUSY, Than::Author(5), 100),
    ("chain100_flags", &RAM, Than::Nothing, 1300),
    ("par8", &FLASH, Than::Best, 95),
    ("par8", &BUSY, Than::ByHand, 90),
    ("par8", &RAM, Than::Nothing, 800),
    ("chain1000", &BUSY, Than::Chart("chain10"), 120),
    ("chain1000", &RAM, Than::Nothing, 200),
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
}

impl Display for Goal {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self { what, place, figure, than, value, limit } = self;
        write!(f, "{what}, {place}, {figure}: {value:.2} of {than}, at most {limit:.2}")
    }
}

/// The goals of the costs on a controller.
pub(super) fn of_costs(boards: &Boards) -> Vec<Goal> {
    let mut goals = Vec::new();
    for (chart, figure, than, hundredths) in RULES {
        for (target, rows) in boards {
            for row in rows.iter().filter(|row| is_of(row, chart)) {
                goals.extend(goal(target, rows, row, (figure, than, hundredths)));
            }
        }
    }
    // As flip-flop programs do it.
    for (target, rows) in boards {
        for row in rows.iter().filter(|row| is_of(row, "chain100")) {
            goals.extend(goal(target, rows, row, (&BUSY, Than::Author(5), 10)));
        }
    }
    goals
}

fn is_of(row: &Row, chart: &str) -> bool {
    row.name.strip_prefix(chart).is_some_and(|rest| rest.starts_with(' '))
}

fn goal(target: &str, rows: &[Row], row: &Row, rule: (&'static Figure, Than, u32)) -> Option<Goal> {
    let (figure, than, hundredths) = rule;
    let ours = f64::from(figure.get(row, 0)?);
    let by_hand = || (1..=2).filter_map(|author| figure.get(row, author)).min();
    let (other, name) = match than {
        Than::Best => (figure.best(row)?, "the best rival".to_owned()),
        Than::ByHand => (by_hand()?, "the better hand-written one".to_owned()),
        Than::Author(place) => (figure.get(row, place)?, author(place).to_owned()),
        Than::Chart(chart) => {
            let name = row.name.split(' ').next_back().map(|dialect| format!("{chart} {dialect}"))?;
            (figure.get(rows.iter().find(|row| row.name == name)?, 0)?, name)
        }
        Than::Nothing => (1, "a byte".to_owned()),
    };
    // What the timer cannot tell apart is no difference.
    let value = (ours - f64::from(figure.resolution)).max(0.0) / f64::from(other);
    Some(Goal {
        what: row.name.clone(),
        place: target.to_owned(),
        figure: figure.name,
        than: name,
        value,
        limit: f64::from(hundredths) / 100.0,
    })
}

/// The goals of the build times.
pub(super) fn of_builds(times: &Times) -> Vec<Goal> {
    let goal = |what: &str, ours: f64, other: f64, than: &str| Goal {
        what: what.to_owned(),
        place: "host".to_owned(),
        figure: "processor time",
        than: than.to_owned(),
        value: ours / other,
        limit: 1.0,
    };
    vec![
        goal("clean build of the macro and its dependencies", times.clean[0], times.clean[1], "smlang's"),
        goal("`cargo check` of Chain1000", times.chain1000[0], times.chain1000[2], "statig's"),
    ]
}

/// All goals in Markdown.
pub(super) fn table(goals: &[Goal]) -> String {
    let mut table = String::from("| | | | | at most | |\n| --- | --- | --- | --: | --: | --- |\n");
    for goal in goals {
        let Goal { what, place, figure, than, value, limit } = goal;
        let verdict = if goal.is_met() { "" } else { "**missed**" };
        _ = writeln!(table, "| {what} | {place} | {figure}, of {than} | {value:.2} | {limit:.2} | {verdict} |");
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
        // A byte of flash more is more, two ticks are not, and two bytes of RAM are allowed.
        assert_eq!(met, [false, true, true]);
        assert_eq!(goals[0].to_string(), "line24v sfc, thumb, flash: 1.01 of the best rival, at most 1.00");
    }
}
